// collides, isWithin and distance never contradict one another or the oracle.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/each_target.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(verdicts_test)

using namespace clearway;
using namespace clearway::testing;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BOOST_DATA_TEST_CASE(contact_is_never_missed_and_the_three_queries_agree_on_it, eachTarget() * eachWidth(),
                     target, width) {
    const UsingTarget using_(target);
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase, ofWidth(width));
        Workspace workspace;
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const Pose& pose = queryCase.poses[i];
            const bool touching = collides(models.part, models.environment, pose, workspace);
            const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
            BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
                BOOST_TEST(isWithin(models.part, models.environment, pose, 0, workspace) == touching);
                BOOST_TEST(result.collides() == touching);
                BOOST_TEST((queryCase.answers[i].distance == 0) == touching);
            }
        }
    }
}

BOOST_DATA_TEST_CASE(within_agrees_with_oracle_and_interval, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase, ofWidth(width));
        Workspace workspace;
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const Pose& pose = queryCase.poses[i];
            const double truth = queryCase.answers[i].distance;
            const double oracleError =
                truth == 0 ? 0 : 32 * 0x1p-64 * largestCoordinate(queryCase, pose);  // long double's
            const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
            const auto within = [&](double d) {
                workspace.forgetWarmStart();
                return isWithin(models.part, models.environment, pose, d, workspace);
            };
            BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i << ", distance " << truth) {
                BOOST_TEST(within(std::nextafter(truth + oracleError, kInfinity)));
                BOOST_TEST(within(truth * (1 + 1e-6)));
                BOOST_TEST(within(2 * truth + queryCase.oracle->sceneSize()));
                BOOST_TEST(within(kInfinity));
                BOOST_TEST(within(result.upper));
                if (truth > oracleError) {
                    BOOST_TEST(!within(std::nextafter(truth - oracleError, 0.0)));
                    BOOST_TEST(!within(truth / 2));
                }
                if (result.lower > 0) BOOST_TEST(!within(std::nextafter(result.lower, 0.0)));
            }
        }
    }
}

// Far out, the range in which double cannot rule out contact is wider than what float can tell apart.
BOOST_DATA_TEST_CASE(far_from_the_origin_the_three_queries_agree_on_contact, eachTarget() * eachWidth(),
                     target, width) {
    const UsingTarget using_(target);
    for (const double away : {1e8, 1e9, 3e10, 1e13}) {
        const Vector3 place(away, -away, away);
        const QueryCase boxes =
            makeCase("boxes", box({1, 2, 3}, 1), translated(box({4, 5, 6}, 1), place), {});
        const ModelPair models = buildPair(boxes, ofWidth(width));
        Workspace warm;
        int contacts = 0, free = 0;
        for (int gap = 0; gap <= 80; ++gap) {  // in units of u64 * away
            const Pose pose{Matrix3::Identity(), place + Vector3(5 + gap * kUnitRoundoff * away, 0, 0)};
            Workspace cold, other;
            const bool touching = collides(models.part, models.environment, pose, cold);
            BOOST_TEST_CONTEXT(away << " away, gap " << gap) {
                BOOST_TEST(distance(models.part, models.environment, pose, {}, other).collides() == touching);
                BOOST_TEST(collides(models.part, models.environment, pose, warm) == touching);
                BOOST_TEST(distance(models.part, models.environment, pose, {}, warm).collides() == touching);
                BOOST_TEST(isWithin(models.part, models.environment, pose, 0, warm) == touching);
            }
            ++(touching ? contacts : free);
        }
        BOOST_TEST(contacts > 0);
        BOOST_TEST(free > 0);
    }
}

BOOST_AUTO_TEST_CASE(boxes_a_hair_apart_are_free_and_touching_ones_are_not) {
    const Mesh part = box({1, 2, 3}, 2), environment = box({4, 5, 6}, 3);
    const auto at = [](double gap) { return Pose{Matrix3::Identity(), {5 + gap, 0.3, 0.2}}; };
    for (const int width : nodeWidths()) {
        const Model partModel = Model::build(part, ofWidth(width));
        const Model environmentModel = Model::build(environment, ofWidth(width));
        Workspace workspace;
        for (const double gap : {1e-13, 1e-12, 1e-9, 1e-3}) {
            BOOST_TEST(!collides(partModel, environmentModel, at(gap), workspace));
            BOOST_TEST(distance(partModel, environmentModel, at(gap), {}, workspace).lower > 0.0);
            BOOST_TEST(!isWithin(partModel, environmentModel, at(gap), gap / 2, workspace));
            BOOST_TEST(isWithin(partModel, environmentModel, at(gap), gap * 1.25 + 1e-14, workspace));
        }
        for (const double depth : {0.0, 1e-15, 1e-12, 1e-3, 1.0}) {
            BOOST_TEST(collides(partModel, environmentModel, at(-depth), workspace));
            BOOST_TEST(distance(partModel, environmentModel, at(-depth), {}, workspace).upper == 0.0);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
