// Tests the promise that the measurement of "float only" relies on: its interval holds the true distance.
#include "bench/float_only.h"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/each_target.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(float_only_test)

using namespace clearway;
using namespace clearway::testing;

BOOST_DATA_TEST_CASE(interval_in_float_holds_the_true_distance_and_answer,
                     eachTarget() * eachWidth() * boost::unit_test::data::make({false, true}), target, width,
                     exactRectangles) {
    const UsingTarget usingTarget(target);
    int answered = 0;
    for (const QueryCase& queryCase : queryCases()) {
        BuildOptions options;
        options.nodeWidth = width;
        const ModelPair models = buildPair(queryCase, options);
        FloatOnly inFloat(models.part, models.environment, exactRectangles);
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const Answer answer = inFloat.distance(queryCase.poses[i]);
            const double truth = queryCase.answers[i].distance;
            BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
                BOOST_TEST(answer.lower <= truth);
                BOOST_TEST(truth <= answer.upper);
                BOOST_TEST(answer.lower <= answer.value);
                BOOST_TEST(answer.value <= answer.upper);
                BOOST_TEST((answer.lower == 0) == (answer.value == 0));
            }
            // The interval is narrow enough to be worth measuring.
            const double size = queryCase.oracle->sceneSize();
            answered += answer.lower > 0 && answer.upper - answer.lower <= 1e-4 * size;
        }
    }
    BOOST_TEST(answered > 30);
}

BOOST_AUTO_TEST_CASE(answer_of_a_warm_query_is_that_of_a_cold_one_but_for_ties) {
    const QueryCase& queryCase = queryCases().front();
    const ModelPair models = buildPair(queryCase);
    FloatOnly warm(models.part, models.environment), cold(models.part, models.environment);
    for (const Pose& pose : queryCase.poses) {
        cold.forgetWarmStart();
        const Answer a = warm.distance(pose), b = cold.distance(pose);
        BOOST_TEST((a.value == 0) == (b.value == 0));
        if (a.value > 0) BOOST_TEST(a.upper == b.upper, boost::test_tools::tolerance(1e-5));
    }
}

BOOST_AUTO_TEST_SUITE_END()
