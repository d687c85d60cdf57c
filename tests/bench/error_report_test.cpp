// Tests that the figures agree with the answers.
#include "bench/error_report.h"

#include <boost/test/unit_test.hpp>
#include <limits>

BOOST_AUTO_TEST_SUITE(error_report_test)

using namespace clearway;
using namespace clearway::testing;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Mode modeWith(Mode::Says says, bool isQuery, const std::vector<Answer>& answers) {
    Mode mode{says, isQuery, {}, nullptr};
    mode.series.engine = "made up";
    mode.series.answers = answers;
    mode.series.nanoseconds = {std::vector<double>(answers.size(), 100),
                               std::vector<double>(answers.size(), 300)};
    return mode;
}

Answer interval(double value, double lower, double upper) {
    return {value, lower, upper, {}};
}

ErrorReport reportOf(const ModeFigures& figures, std::size_t margins) {
    ErrorReport report{"A", "", 4, 1, {}, {}, {figures}};
    report.margins.resize(margins);
    report.marginShares.resize(margins);
    return report;
}

BOOST_AUTO_TEST_CASE(errors_and_widths_are_shares_of_the_scene) {
    const Mode mode =
        modeWith(Mode::Says::kInterval, true,
                 {interval(10, 9, 11), interval(21, 20, 22), interval(0, 0, 0), interval(30, 30, 30)});
    const ModeFigures figures = figuresOf(mode, mode.series, {{10, 0}, {20, 0}, {0, 0}, {30, 0}}, 100);
    BOOST_TEST(figures.errors.count == 4);
    BOOST_TEST(figures.errors.worst == 0.01);
    BOOST_TEST(figures.errors.median == 0.0);
    BOOST_TEST(figures.widths.worst == 0.02);
    BOOST_TEST(figures.widths.median == 0.01);
    BOOST_TEST(figures.outside == 0);
    BOOST_TEST(figures.queriesPerSecond == 5e6);
    BOOST_TEST(figures.passRatios == std::vector<double>(2, 1.0));

    Series twiceAsFast = mode.series;
    twiceAsFast.nanoseconds = {{50, 50, 50, 50}, {150, 150, 150, 150}};
    BOOST_TEST(figuresOf(mode, twiceAsFast, {{10, 0}, {20, 0}, {0, 0}, {30, 0}}, 100).overFloatOnly == 2);
    BOOST_TEST(faults(reportOf(figures, 0)).empty());
}

BOOST_AUTO_TEST_CASE(percentile_leaves_out_one_in_a_thousand) {
    std::vector<double> values(2000, 1);
    values[7] = values[8] = 5;
    values[9] = 9;
    const Spread spread = spreadOf(values);
    BOOST_TEST(spread.median == 1);
    BOOST_TEST(spread.p999 == 5);
    BOOST_TEST(spread.worst == 9);
}

BOOST_AUTO_TEST_CASE(
    interval_that_misses_the_truth_by_more_than_the_oracle_is_off_is_a_fault_of_a_query_alone) {
    const std::vector<Answer> answers{interval(10, 10, 11), interval(20, 20, 20), interval(1, 1, 1)};
    const std::vector<Truth> truths{
        {9.5, 0.25}, {20.125, 0.25}, {0, 0}};  // missed, near enough, contact missed
    for (const bool isQuery : {true, false}) {
        const Mode mode = modeWith(Mode::Says::kInterval, isQuery, answers);
        const ModeFigures figures = figuresOf(mode, mode.series, truths, 100);
        BOOST_TEST(figures.outside == 2);
        BOOST_TEST(faults(reportOf(figures, 0)).size() == (isQuery ? 1 : 0));
    }
}

BOOST_AUTO_TEST_CASE(answers_beyond_the_cap_are_counted_and_have_no_error) {
    const Mode mode =
        modeWith(Mode::Says::kInterval, true, {interval(10, 10, 10), interval(kInfinity, 50, kInfinity)});
    const ModeFigures figures = figuresOf(mode, mode.series, {{10, 0}, {60, 0}}, 100);
    BOOST_TEST(figures.beyondCap == 1);
    BOOST_TEST(figures.errors.count == 1);
    BOOST_TEST(figures.widths.count == 1);
    BOOST_TEST(figures.outside == 0);
    BOOST_TEST(figuresOf(mode, mode.series, {{10, 0}, {40, 0}}, 100).outside ==
               1);  // the true distance is less than the answer says
}

BOOST_AUTO_TEST_CASE(table_has_a_field_for_every_column) {
    ModeFigures figures;
    figures.mode = "made up";
    figures.passRatios = {1};
    figures.verdicts = {{1, 2}, {3, 4}};
    ErrorReport report = reportOf(figures, 2);
    const std::string header = errorHeader({0, 1e-6}), row = errorRows(report);
    BOOST_TEST(std::count(header.begin(), header.end(), ',') == std::count(row.begin(), row.end(), ','));
    BOOST_TEST(row.find(",1,2,") != std::string::npos);
    BOOST_TEST(row.find(",3,4\n") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
