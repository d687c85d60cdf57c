// Scenes in which obstacles may reach a little way into the part: poses, motions and words agree with depths.
#include <boost/test/unit_test.hpp>

#include "clearway/overlap.h"
#include "clearway/shrink.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"
#include "support/winding.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(overlap_scene_test)

using planning::MotionReport;
using planning::MotionVerdict;

constexpr double kOverlap = 0.5;

Scene overlapScene(const Mesh& part, const Mesh& obstacle) {
    const ShrunkPart shrunk = shrink(part, {kOverlap});
    Scene scene(Model::build(part), Model::build(obstacle));
    scene.obstacles[0].solids = makeSolids(obstacle).solids;
    scene.obstacles[0].shrunk = shrunkModel(shrunk, Model::build(shrunk.mesh));
    return scene;
}

BOOST_AUTO_TEST_CASE(a_part_may_sink_into_a_floor_as_deep_as_the_overlap) {
    const Mesh part = named(box({2, 2, 2}), "part"),
               floor = named(translated(box({20, 20, 5}), {0, 0, -5}), "floor");
    const PartInSpace space(overlapScene(part, floor));
    for (const double sunk : {-3.0, 0.0, 0.2, 0.37}) BOOST_TEST(space.isValid({1, 2, 2 - sunk}));
    for (const double sunk : {0.38, 0.5, 1.0, 3.0}) BOOST_TEST(!space.isValid({1, 2, 2 - sunk}));
    BOOST_TEST(!space.isValid({0, 0, -5}));  // all of it within the floor
    BOOST_TEST(space.checker->clearance(space.at({0, 0, 1.7}).get()) > 0.075 - 1e-9);
    BOOST_TEST(space.checker->clearance(space.at({0, 0, 1.7}).get()) < 0.075 + 1e-9);
    BOOST_TEST(space.checker->clearance(space.at({0, 0, 1}).get()) <= 0);
    BOOST_TEST(space.check({-5, 0, 1.65}, {5, 3, 1.7}));
    BOOST_TEST(!space.check({-5, 0, 1.65}, {5, 3, 1}));
    BOOST_TEST(!space.check({0, 0, 3}, {0, 0, -13}));
    const MotionReport report =
        space.validator->report(space.at({-5, 0, 1.65}).get(), space.at({5, 3, 1.7}).get());
    BOOST_TEST((report.verdict == MotionVerdict::kValid));
    BOOST_TEST(report.lowerClearance > 0);
    const WhyInvalid why = space.checker->whyInvalid(space.at({0, 0, 1}).get());
    BOOST_TEST((why.kind == WhyInvalid::Kind::kTooDeep));
    BOOST_TEST(why.limit == 0.5);
    BOOST_TEST(why.environmentMesh == "floor");
    BOOST_TEST(why.partMesh == "part");
    BOOST_TEST_REQUIRE(why.nearest.witness.has_value());
    BOOST_TEST(why.nearest.witness->environmentTriangle >= 0);
    const WhyInvalid within = space.checker->whyInvalid(space.at({0, 0, -5}).get());
    BOOST_TEST((within.kind == WhyInvalid::Kind::kInSolid));
    BOOST_TEST(within.environmentMesh == "floor");
    BOOST_TEST(within.isPartInside);
}

BOOST_AUTO_TEST_CASE(an_obstacle_within_the_part_is_invalid_even_when_it_is_open) {
    Mesh sheet = named(box({1, 1, 0.01}), "sheet");
    sheet.triangles.resize(2);
    sheet.components[0].triangleCount = 2;
    const PartInSpace space(overlapScene(named(box({4, 4, 4}), "part"), sheet));
    BOOST_TEST(!space.isValid({0, 0, 0}));
    BOOST_TEST(space.isValid({5, 0, 0}) == space.isValid({-5, 0, 0}));
    BOOST_TEST(space.isValid({0, 0, 3.7}));   // 0.3 deep
    BOOST_TEST(!space.isValid({0, 0, 3.3}));  // 0.7 deep
}

/// The case's inner skin is there twice, so it winds -1 times around what is in its cavity.
BOOST_AUTO_TEST_CASE(each_component_winds_around_its_own_inside) {
    Mesh part =
        joined(joined(joined(box({10, 10, 10}), reversed(box({8, 8, 8}))), reversed(box({7.9, 7.9, 7.9}))),
               box({5, 5, 5}));
    part.components = {{"case", 0, 36}, {"core", 36, 12}};
    const PartInSpace space(overlapScene(part, named(box({1, 1, 1}), "grain")));
    BOOST_TEST(!space.isValid({0, 0, 0}));
    BOOST_TEST(!space.isValid({3, 0, 0}));
    BOOST_TEST(space.isValid({6.6, 0, 0}));  // in the cavity
}

BOOST_AUTO_TEST_CASE(poses_and_motions_agree_with_depths) {
    Random random(3);
    const Mesh part = torus(5, 2, 8), obstacle = box({1, 2, 6}, 2);
    const PartInSpace space(overlapScene(part, obstacle));
    const OverlapMeter meter(part);
    int shallow = 0, deep = 0, certified = 0;
    for (int n = 0; n < 150; ++n) {
        const Pose X = random.pose(7);
        PartState state;
        state.position = X.translation;
        state.rotation = Eigen::Quaterniond(X.rotation);
        const DeepestPoint found = meter.deepest(obstacle, poseOf(state));
        const bool isValid = space.checker->isValid(space.at(state).get());
        if (found.lower > kOverlap) {
            ++deep;
            BOOST_REQUIRE(!isValid);
        }
        if (found.upper < 0.7 * kOverlap && found.upper > 0) {
            ++shallow;
            BOOST_REQUIRE(isValid);  // the obstacle is longer than the part, and the part than the obstacle
        }
        PartState next = state;
        next.position += 2 * random.inBox(1);
        const auto a = space.at(state), b = space.at(next);
        if (!space.validator->checkMotion(a.get(), b.get())) continue;
        ++certified;
        auto between = space.at(state);
        for (int k = 0; k <= 20; ++k) {
            space.space->interpolate(a.get(), b.get(), k / 20.0, between.get());
            const DeepestPoint there = meter.deepest(obstacle, poseOf(space.stateOf(between.get())));
            BOOST_REQUIRE(there.lower <= kOverlap);
        }
    }
    BOOST_TEST(shallow > 3);
    BOOST_TEST(deep > 20);
    BOOST_TEST(certified > 20);
}

BOOST_AUTO_TEST_CASE(a_margin_is_kept_from_the_shrunk_part) {
    Scene scene = overlapScene(box({2, 2, 2}), translated(box({20, 20, 5}), {0, 0, -5}));
    scene.obstacles[0].margin = 0.4;  // as of a planner that looks for room
    const PartInSpace space(scene);
    BOOST_TEST(space.isValid({0, 0, 2.1}));
    BOOST_TEST(!space.isValid({0, 0, 1.95}));
    const WhyInvalid why = space.checker->whyInvalid(space.at({0, 0, 1.95}).get());
    BOOST_TEST((why.kind == WhyInvalid::Kind::kTooClose));
    BOOST_TEST(why.limit == 0.4);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
