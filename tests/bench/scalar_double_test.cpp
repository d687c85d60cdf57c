// Tests the promises that the measurements of "scalar double" and "root volumes" rely on.
#include "bench/scalar_double.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(scalar_double_test)

using namespace clearway;
using namespace clearway::testing;

BOOST_AUTO_TEST_CASE(plain_search_in_double_finds_the_true_distance_within_its_interval) {
    for (const int width : nodeWidths()) {
        for (const QueryCase& queryCase : queryCases()) {
            BuildOptions options;
            options.nodeWidth = width;
            const ModelPair models = buildPair(queryCase, options);
            ScalarDouble scalar(models.part, models.environment);
            for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
                const Answer answer = scalar.distance(queryCase.poses[i]);
                const double truth = queryCase.answers[i].distance;
                BOOST_TEST_CONTEXT(queryCase.name << ", nodes of " << width << ", pose " << i) {
                    BOOST_TEST(answer.lower <= truth);
                    BOOST_TEST(std::abs(answer.value - truth) <= 1e-12 * queryCase.oracle->sceneSize());
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(bound_of_the_root_volumes_never_exceeds_the_true_distance) {
    int above0 = 0;
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase);
        const ScalarDouble scalar(models.part, models.environment);
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const Answer answer = scalar.rootBound(queryCase.poses[i]);
            BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
                BOOST_TEST(answer.lower <= queryCase.answers[i].distance);
            }
            above0 += answer.lower > 0;
        }
    }
    BOOST_TEST(above0 > 10);
}

BOOST_AUTO_TEST_SUITE_END()
