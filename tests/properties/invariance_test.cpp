// Changes that must not change an answer: the roles of part and environment, the scale, the place, and the workspace's history.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/each_target.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(invariance_test)

using namespace clearway;
using namespace clearway::testing;

void checkAll(const QueryCase& queryCase, int width) {
    const ModelPair models = buildPair(queryCase, ofWidth(width));
    Workspace workspace;
    for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
        const Pose& pose = queryCase.poses[i];
        BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
            const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
            checkDistance(result, queryCase, pose, queryCase.answers[i]);
            BOOST_TEST(collides(models.part, models.environment, pose, workspace) == result.collides());
        }
    }
}

std::vector<Pose> firstPoses(const QueryCase& queryCase, std::size_t n) {
    return {queryCase.poses.begin(), queryCase.poses.begin() + static_cast<std::ptrdiff_t>(n)};
}

// Scales the whole scene, meshes and gaps, by the factor.
QueryCase scaledCase(const QueryCase& queryCase, double factor) {
    std::vector<Pose> poses = queryCase.poses;
    for (Pose& pose : poses) pose.translation *= factor;
    return makeCase(queryCase.name + " times " + std::to_string(std::ilogb(factor)),
                    scaledBy(queryCase.part, factor), scaledBy(queryCase.environment, factor), poses);
}

BOOST_DATA_TEST_CASE(part_and_environment_may_be_exchanged, eachWidth(), width) {
    for (const QueryCase& queryCase : queryCases()) {
        std::vector<Pose> inverted;
        for (const Pose& pose : queryCase.poses) inverted.push_back(inverse(pose));
        const QueryCase exchanged =
            makeCase(queryCase.name + " exchanged", queryCase.environment, queryCase.part, inverted);
        for (std::size_t i = 0; i < inverted.size(); ++i) {
            BOOST_TEST(std::abs(exchanged.answers[i].distance - queryCase.answers[i].distance) <=
                       1e-14 * queryCase.oracle->sceneSize());
        }
        checkAll(exchanged, width);
    }
}

BOOST_DATA_TEST_CASE(scaling_by_powers_of_two_scales_the_answer_exactly, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    for (const int exponent : {-60, -20, 20, 60}) {
        const double factor = std::ldexp(1.0, exponent);
        for (const std::size_t which : {std::size_t{1}, std::size_t{2}}) {
            const QueryCase& original = queryCases()[which];
            const QueryCase scaled = scaledCase(original, factor);
            checkAll(scaled, width);
            const ModelPair models = buildPair(original, ofWidth(width));
            const ModelPair scaledModels = buildPair(scaled, ofWidth(width));
            Workspace workspace;
            for (std::size_t i = 0; i < original.poses.size(); ++i) {
                const auto before =
                    distance(models.part, models.environment, original.poses[i], {}, workspace);
                const auto after =
                    distance(scaledModels.part, scaledModels.environment, scaled.poses[i], {}, workspace);
                BOOST_TEST_CONTEXT(scaled.name << ", pose " << i) {
                    BOOST_TEST(after.distance == before.distance * factor);
                    BOOST_TEST(after.lower == before.lower * factor);
                    BOOST_TEST(after.upper == before.upper * factor);
                    BOOST_TEST(after.witness->partTriangle == before.witness->partTriangle);
                }
            }
        }
    }
}

BOOST_DATA_TEST_CASE(scales_whose_squares_leave_the_range_of_double_scale_the_answer_too, eachWidth(),
                     width) {
    const QueryCase& original = queryCases()[1];
    const ModelPair models = buildPair(original, ofWidth(width));
    for (const int exponent : {-900, -600, 600, 900}) {
        const double factor = std::ldexp(1.0, exponent);
        const Model part = Model::build(scaledBy(original.part, factor), ofWidth(width));
        const Model environment = Model::build(scaledBy(original.environment, factor), ofWidth(width));
        Workspace workspace;
        for (const Pose& pose : original.poses) {
            const Pose scaledPose{pose.rotation, pose.translation * factor};
            const auto before = distance(models.part, models.environment, pose, {}, workspace);
            const auto after = distance(part, environment, scaledPose, {}, workspace);
            BOOST_TEST_CONTEXT(original.name << " times 2^" << exponent) {
                BOOST_TEST(after.distance == before.distance * factor);
                BOOST_TEST(after.lower == before.lower * factor);
                BOOST_TEST(after.upper == before.upper * factor);
                BOOST_TEST(collides(part, environment, scaledPose, workspace) == before.collides());
            }
        }
    }
}

BOOST_DATA_TEST_CASE(sizes_may_differ_a_millionfold, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Random random(17);
    const Mesh small = scaledBy(torus(4, 1, 6), 0x1p-20);
    const Mesh large = randomTerrain(random, 12, 4, 0.3);
    std::vector<Pose> poses;
    for (int i = 0; i < 6; ++i) poses.push_back(random.pose(1));
    checkAll(makeCase("small part", small, large, poses), width);
    checkAll(makeCase("large part", large, small, poses), width);
}

BOOST_DATA_TEST_CASE(meshes_may_lie_far_from_their_origin, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    const Pose offset{Matrix3::Identity(), {1e6, -2e6, 3e5}};
    for (const QueryCase& queryCase : queryCases()) {
        // Both meshes in common coordinates far out; the pose moves the part as before, but about the far
        // place.
        std::vector<Pose> poses;
        for (const Pose& pose : firstPoses(queryCase, 4)) poses.push_back(offset * pose * inverse(offset));
        checkAll(makeCase(queryCase.name + " far out", transformed(queryCase.part, offset),
                          transformed(queryCase.environment, offset), poses),
                 width);
    }
}

BOOST_DATA_TEST_CASE(a_part_may_lie_far_beyond_the_size_of_both, eachTarget() * eachWidth(), target, width) {
    // From 2^32 sizes on, fourth powers of lengths overflow float; queries go up to 2^60.
    const UsingTarget using_(target);
    Random random(23);
    const Mesh part = randomSoup(random, 20, 0.7, 0.4), environment = randomSoup(random, 30, 0.7, 0.4);
    const ModelPair models{Model::build(part, ofWidth(width)), Model::build(environment, ofWidth(width))};
    const MeshOracle oracle(part, environment);
    for (const int exponent : {20, 31, 32, 33, 34, 36, 40, 50, 58}) {
        const Pose pose{random.rotation(), random.direction() * std::ldexp(1.0, exponent)};
        const double truth = oracle.distance(pose).distance;
        BOOST_TEST_CONTEXT("seed 23, 2^" << exponent << " away") {
            Workspace workspace;
            const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
            BOOST_TEST(result.lower <= truth);
            BOOST_TEST(truth <= result.upper);
            BOOST_TEST(result.upper - result.lower <= 64 * kUnitRoundoff * truth);
            BOOST_TEST(isWithin(models.part, models.environment, pose, 1.001 * truth, workspace));
            BOOST_TEST(!isWithin(models.part, models.environment, pose, 0.999 * truth, workspace));
        }
    }
}

BOOST_DATA_TEST_CASE(the_past_of_a_workspace_changes_no_answer, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Workspace warm;
    for (int round = 0; round < 2; ++round) {
        for (const QueryCase& queryCase : queryCases()) {
            const ModelPair models = buildPair(queryCase, ofWidth(width));
            for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
                const Pose& pose = queryCase.poses[i];
                Workspace cold;
                const double rounding = 16 * kUnitRoundoff * largestCoordinate(queryCase, pose);
                const DistanceResult first = distance(models.part, models.environment, pose, {}, cold);
                const DistanceResult later = distance(models.part, models.environment, pose, {}, warm);
                BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
                    BOOST_TEST(std::abs(first.distance - later.distance) <= rounding);
                    BOOST_TEST(first.collides() == later.collides());
                    checkDistance(later, queryCase, pose, queryCase.answers[i]);
                }
                for (const double d : {0.0, 0.5 * first.distance, first.upper, 2 * first.distance}) {
                    cold.forgetWarmStart();
                    BOOST_TEST(isWithin(models.part, models.environment, pose, d, cold) ==
                               isWithin(models.part, models.environment, pose, d, warm));
                }
                cold.forgetWarmStart();
                BOOST_TEST(collides(models.part, models.environment, pose, cold) ==
                           collides(models.part, models.environment, pose, warm));
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
