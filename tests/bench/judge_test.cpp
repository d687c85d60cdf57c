#include "bench/judge.h"

#include <boost/test/unit_test.hpp>
#include <limits>

BOOST_AUTO_TEST_SUITE(judge_test)

using namespace clearway::testing;

constexpr double kTolerance = 1e-6;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Series seriesOf(Question question, bool isClearway, const std::vector<double>& values, double within = 0) {
    Series series;
    series.question = question;
    series.isClearway = isClearway;
    series.within = within;
    for (const double value : values) series.answers.push_back({value, value, value, {}});
    return series;
}

/// Three poses: contact, 1 and 2 apart. Every series answers rightly until a test changes an answer.
struct Court {
    std::vector<Series> all = {seriesOf(Question::kDistance, true, {0, 1, 2}),
                               seriesOf(Question::kDistance, false, {-1, 1, 2}),
                               seriesOf(Question::kCollides, true, {1, 0, 0}),
                               seriesOf(Question::kCollides, false, {1, 0, 0}),
                               seriesOf(Question::kIsWithin, true, {1, 1, 0}, 1.5),
                               seriesOf(Question::kIsWithin, false, {1, 1, 0}, 1.5)};
    std::vector<double> truth = {0, 1, 2};

    Judgement verdict(std::size_t refereed = 0) const {
        return judge(
            all, 3, kTolerance, [this](std::size_t pose) { return truth[pose]; }, refereed);
    }
};

std::vector<int> wrongOnly(std::size_t series) {
    std::vector<int> wrong(6, 0);
    wrong[series] = 1;
    return wrong;
}

BOOST_AUTO_TEST_CASE(where_all_agree_nobody_is_wrong_and_the_referee_is_not_asked) {
    const Judgement judgement = Court().verdict();
    BOOST_TEST(judgement.wrong == std::vector<int>(6, 0), boost::test_tools::per_element());
    BOOST_TEST(judgement.askedPoses() == 0);
    BOOST_TEST(judgement.collidingPoses() == 1);
    BOOST_TEST(judgement.complaints.empty());
}

BOOST_AUTO_TEST_CASE(a_wrong_answer_of_a_peer_is_counted_for_the_peer) {
    for (const std::size_t series : {1, 3, 5}) {
        Court court;
        court.all[series].answers[2].value = series == 1 ? 0 : 1;
        const Judgement judgement = court.verdict();
        BOOST_TEST(judgement.wrong == wrongOnly(series), boost::test_tools::per_element());
        BOOST_TEST(judgement.askedPoses() == 1);
        BOOST_TEST(judgement.complaints.empty());
    }
}

BOOST_AUTO_TEST_CASE(a_wrong_verdict_of_clearway_is_a_complaint) {
    for (const std::size_t series : {2, 4}) {
        Court court;
        court.all[series].answers[0].value = 0;  // "free" at contact
        const Judgement judgement = court.verdict();
        BOOST_TEST(judgement.wrong == wrongOnly(series), boost::test_tools::per_element());
        BOOST_TEST(judgement.complaints.size() == 1U);
    }
}

BOOST_AUTO_TEST_CASE(a_wrong_distance_of_clearway_is_a_complaint_when_only_the_referee_knows_better) {
    Court court;
    court.truth[1] = 0.5;
    BOOST_TEST(court.verdict().complaints.empty());
    const Judgement judgement = court.verdict(/*refereed*/ 3);
    BOOST_TEST(judgement.askedPoses() == 3);
    BOOST_TEST(judgement.wrong[0] == 1);
    BOOST_TEST(judgement.wrong[1] == 1);  // the peer that agreed with clearway's wrong answer
}

BOOST_AUTO_TEST_CASE(an_interval_that_misses_the_true_distance_is_wrong) {
    Court court;
    court.all[0].answers[1].lower = 1 + 2 * kTolerance;
    BOOST_TEST(court.verdict().wrong == wrongOnly(0), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(differences_within_the_tolerance_are_not_wrong) {
    Court court;
    court.all[1].answers[2].value = 2 + kTolerance / 2;
    court.truth[1] = 1 - kTolerance / 2;
    BOOST_TEST(court.verdict(3).wrong == std::vector<int>(6, 0), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_number_is_wrong) {
    Court court;
    court.all[1].answers[1].value = kNaN;
    BOOST_TEST(court.verdict().wrong == wrongOnly(1), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(verdicts_of_clearway_must_agree_with_its_distance_even_within_the_tolerance) {
    Court court;
    court.all[0].answers[0] = {kTolerance / 10, kTolerance / 10, kTolerance / 10, {}};  // not quite contact
    BOOST_TEST(court.verdict().wrong == wrongOnly(2), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
