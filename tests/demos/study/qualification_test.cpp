#include "demos/study/qualification.h"

#include <boost/test/unit_test.hpp>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(qualification_test)

using namespace study;

const Measure kNone = std::nullopt;

BOOST_AUTO_TEST_CASE(seeds_run_until_they_cannot_change_the_verdict) {
    const StudyOptions options;
    BOOST_TEST(!isDecided({}, options));
    BOOST_TEST(!isDecided({kNone, kNone, 0.5}, options));
    BOOST_TEST(isDecided({kNone, 0.5, kNone, kNone}, options));  // at most 7 of 10 could be solved
    BOOST_TEST(!isDecided(Outcomes(5, Measure(2)), options));    // the other five could be quick
    BOOST_TEST(isDecided(Outcomes(6, Measure(2)), options));
    BOOST_TEST(!isDecided(Outcomes(9, Measure(0.5)), options));
    BOOST_TEST(isDecided(Outcomes(10, Measure(0.5)), options));
}

BOOST_AUTO_TEST_CASE(a_planner_enters_where_it_mostly_solves_quickly) {
    const StudyOptions options;
    Outcomes outcomes(8, Measure(0.5));
    outcomes.insert(outcomes.end(), {kNone, kNone});
    const QualifiedRow row = judge("s", "P", outcomes, options);
    BOOST_TEST(row.enters());
    BOOST_TEST(row.solved == 8u);
    BOOST_TEST(row.medianSeconds.value() == 0.5);
    BOOST_TEST(row.limitSeconds.value() == 5);
    outcomes.push_back(kNone);
    outcomes.erase(outcomes.begin());
    BOOST_TEST(judge("s", "P", outcomes, options).verdict == "solves too few");
    BOOST_TEST(judge("s", "P", Outcomes(10, Measure(1.5)), options).verdict == "too slow");
    BOOST_TEST(judge("s", "P", Outcomes(10, Measure(1e-4)), options).limitSeconds.value() ==
               options.leastLimit);
    BOOST_TEST(!judge("s", "P", Outcomes(3, kNone), options).medianSeconds);
}

BOOST_AUTO_TEST_CASE(a_planner_that_enters_fewer_than_three_problems_is_unable) {
    StudyOptions options;
    options.planners = {"P", "Q"};
    std::vector<QualifiedRow> rows;
    for (const char* scene : {"a", "b", "c", "d"}) {
        rows.push_back(judge(scene, "P", Outcomes(10, Measure(0.5)), options));
        rows.push_back(judge(scene, "Q", Outcomes(10, Measure(*scene < 'c' ? 0.5 : 5)), options));
    }
    BOOST_TEST(unablePlanners(rows, options) == std::vector<std::string>({"Q"}),
               boost::test_tools::per_element());
    BOOST_TEST(unablePlanners({rows[0], rows[1], rows[4], rows[5]}, options).empty());  // two problems alone
    BOOST_TEST(unablePlanners({rows[4], rows[5]}, options) == std::vector<std::string>({"Q"}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(seeds_and_then_the_slowest_planners_go_where_the_time_does_not_suffice) {
    StudyOptions options;
    options.generalSplits = {"sah"};
    options.leafSplits = {"none", "all"};
    std::vector<QualifiedRow> rows;
    for (const double seconds : {0.1, 0.4, 0.2})
        rows.push_back(judge("s", "P", Outcomes(10, Measure(seconds)), options));
    rows.push_back(judge("s", "Q", Outcomes(3, kNone), options));
    const auto seeds = [&](double available) {
        fitSeeds(rows, options, available);
        std::vector<std::uint64_t> all;
        for (const QualifiedRow& row : rows) all.push_back(row.seeds);
        return all;
    };
    // Ten seeds of each row take 20 times its median, doubled for what else a run does.
    using Seeds = std::vector<std::uint64_t>;
    BOOST_TEST(seeds(29) == Seeds({10, 10, 10, 0}), boost::test_tools::per_element());
    BOOST_TEST(seeds(27) == Seeds({5, 5, 5, 0}), boost::test_tools::per_element());
    BOOST_TEST(seeds(13) == Seeds({5, 0, 5, 0}), boost::test_tools::per_element());
    BOOST_TEST(seeds(0) == Seeds({0, 0, 0, 0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
