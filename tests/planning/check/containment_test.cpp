// A part inside a solid obstacle touches nothing, but is invalid. So is a part around a solid obstacle.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/full_run.h"
#include "support/oracle.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"
#include "support/winding.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(containment_test)

using planning::MotionReport;
using planning::MotionVerdict;

Scene solidScene(const Mesh& part, const Mesh& obstacle, double margin = 0) {
    Scene scene(Model::build(part), Model::build(obstacle), margin);
    scene.partSolids = makeSolids(part).solids;
    scene.obstacles[0].solids = makeSolids(obstacle).solids;
    return scene;
}

Scene withoutSolids(Scene scene) {
    scene.obstacles[0].solids = nullptr;
    return scene;
}

/// The names are those of the meshes. isPartInside: otherwise the obstacle is inside the part.
void checkEnclosed(const Scene& scene, const Vector3& inside, bool isPartInside = true) {
    const PartInSpace solid(scene), skin(withoutSolids(scene));
    BOOST_TEST(skin.isValid(inside));
    BOOST_TEST(!solid.isValid(inside));
    BOOST_TEST(solid.checker->clearance(solid.at(inside).get()) == 0);
    const WhyInvalid why = solid.checker->whyInvalid(solid.at(inside).get());
    BOOST_TEST((why.kind == WhyInvalid::Kind::kInSolid));
    BOOST_TEST(why.isPartInside == isPartInside);
    BOOST_TEST(why.partMesh == scene.part.components()[0].name);
    BOOST_TEST(why.environmentMesh == scene.obstacles[0].model.components()[0].name);
    BOOST_TEST_REQUIRE(why.obstacle.has_value());
    BOOST_TEST(*why.obstacle == 0u);
    const Vector3 near = inside + Vector3(0.01, 0.02, 0.03);
    BOOST_TEST(skin.check(inside, near));
    BOOST_TEST(!solid.check(inside, near));
    std::pair<ob::State*, double> lastValid(nullptr, -1);
    BOOST_TEST(!solid.validator->checkMotion(solid.at(inside).get(), solid.at(near).get(), lastValid));
    BOOST_TEST(lastValid.second == 0);
    const MotionReport report = solid.validator->report(solid.at(inside).get(), solid.at(near).get());
    BOOST_TEST((report.verdict == MotionVerdict::kInvalid));
    BOOST_TEST(report.upperClearance <= 0);
}

BOOST_AUTO_TEST_CASE(a_part_inside_a_block_is_invalid_whichever_way_the_block_faces) {
    const Mesh part = named(box({1, 1, 1}), "peg"), block = named(box({10, 10, 10}, 3), "block");
    checkEnclosed(solidScene(part, block), {1, 2, 3});
    checkEnclosed(solidScene(part, reversed(block), 0.5), {1, 2, 3});
    BOOST_TEST(makeSolids(reversed(block)).turnedOver == std::vector<std::string>{"block"},
               boost::test_tools::per_element());
    const PartInSpace solid(solidScene(part, block));
    BOOST_TEST(solid.isValid({12, 0, 0}));
    BOOST_TEST(solid.check({12, 0, 0}, {12, 9, 9}));
    BOOST_TEST(solid.checker->clearance(solid.at({14, 0, 0}).get()) == 3,
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_profile_out_of_a_block_begins_without_clearance) {
    const PartInSpace solid(solidScene(box({1, 1, 1}), box({10, 10, 10})));
    const auto inside = solid.at({1, 2, 3}), outside = solid.at({14, 0, 0});
    const auto profile = solid.validator->profile(inside.get(), outside.get());
    BOOST_TEST((profile.report.verdict == MotionVerdict::kInvalid));
    BOOST_TEST(profile.points.front().clearance <= 0);
    BOOST_TEST(profile.points.back().clearance == 3, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_cavity_is_free_and_its_wall_is_not) {
    const Mesh part = named(box({1, 1, 1}), "peg");
    const Mesh hollow = named(joined(box({10, 10, 10}), reversed(box({5, 5, 5}))), "tank");
    for (const Mesh& tank : {hollow, reversed(hollow)}) {
        const PartInSpace solid(solidScene(part, tank));
        BOOST_TEST(solid.isValid({0, 0, 0}));
        BOOST_TEST(solid.check({0, 0, 0}, {3, -3, 3}));
        BOOST_TEST(!solid.isValid({5, 0, 0}));  // touches
        checkEnclosed(solidScene(part, tank), {7, 0, 0});
    }
}

BOOST_AUTO_TEST_CASE(each_loose_piece_of_the_part_counts) {
    const Mesh part = named(joined(box({1, 1, 1}), translated(box({1, 1, 1}), {30, 0, 0})), "pair");
    const Mesh block = named(box({10, 10, 10}), "block");
    checkEnclosed(solidScene(part, block), {-30, 0, 0});
    checkEnclosed(solidScene(part, block), {0, 0, 0});
    BOOST_TEST(PartInSpace(solidScene(part, block)).isValid({-15, 0, 0}));  // one on each side
}

BOOST_AUTO_TEST_CASE(an_obstacle_inside_a_closed_part_counts_and_inside_an_open_one_cannot) {
    const Mesh bolt = named(translated(box({1, 1, 1}), {3, 3, 3}), "bolt");
    Mesh part = named(box({10, 10, 10}), "cover");
    checkEnclosed(solidScene(part, bolt), {0, 0, 0}, false);
    part.triangles.pop_back();
    part = named(part, "cover");
    const MadeSolids made = makeSolids(part);
    BOOST_REQUIRE(made.refusals.size() == 1u);
    BOOST_TEST(made.refusals[0].find("'cover' encloses nothing: 3 open edges") == 0u);
    BOOST_TEST(PartInSpace(solidScene(part, bolt)).isValid({0, 0, 0}));
    BOOST_TEST(!PartInSpace(solidScene(bolt, named(box({10, 10, 10}), "block"))).isValid({0, 0, 0}));
}

// Solid angles decide, for random poses of a part of two pieces among shells within shells.
BOOST_AUTO_TEST_CASE(verdicts_are_those_of_distances_and_solid_angles) {
    Mesh obstacle =
        joined(reversed(torus(40, 15, 12)), joined(box({20, 20, 20}), reversed(box({15, 15, 15}))));
    obstacle = joined(obstacle, translated(box({8, 9, 10}), {70, 0, 0}));
    const std::uint32_t torusTriangles = static_cast<std::uint32_t>(torus(40, 15, 12).triangles.size());
    obstacle.components = {
        {"ring", 0, torusTriangles}, {"tank", torusTriangles, 24}, {"block", torusTriangles + 24, 12}};
    const Mesh part = joined(box({1, 2, 3}), translated(sphere(2, 6), {9, 0, 0}));
    for (const double margin : {0.0, 0.5}) {
        const Scene scene = solidScene(part, obstacle, margin);
        const PartInSpace solid(scene);
        const MeshOracle oracle(part, obstacle);
        Random random(61);
        int enclosed = 0, valid = 0;
        for (int i = 0; i < inForm(800, 300); ++i) {
            PartState state;
            state.position =
                Vector3(random.uniform(-60, 85), random.uniform(-60, 60), random.uniform(-20, 20));
            state.rotation = Eigen::Quaterniond(random.rotation());
            const auto omplState = solid.at(state);
            const Pose X = solid.checker->pose(omplState.get());
            const bool isApart = oracle.distance(X).distance > margin;
            bool isInside = false;
            for (const Vector3& piece : {Vector3(1, 2, 3), Vector3(9, 0, 2)}) {
                for (const Component& component : obstacle.components) {
                    isInside =
                        isInside || std::abs(windingBySolidAngles(obstacle, component, X * piece)) > 0.5;
                }
            }
            BOOST_TEST_CONTEXT("seed 61, state " << i << ", margin " << margin) {
                BOOST_TEST(solid.checker->isValid(omplState.get()) == (isApart && !isInside));
                BOOST_TEST((solid.checker->clearance(omplState.get()) > 0) == (isApart && !isInside));
            }
            enclosed += isApart && isInside;
            valid += isApart && !isInside;
        }
        BOOST_TEST(enclosed > 25);
        BOOST_TEST(valid > 100);
    }
}

// Motions from state to state, as a planner's trees make them, asked of a checker that remembers free states and of new ones.
BOOST_AUTO_TEST_CASE(what_is_remembered_of_free_states_changes_no_verdict) {
    const Mesh obstacle =
        named(joined(joined(box({20, 20, 20}), reversed(box({15, 15, 15}))), box({6, 4, 9})), "tank");
    const Scene scene =
        solidScene(joined(box({0.3, 0.6, 0.9}), translated(sphere(0.5, 6), {1.5, 0, 0})), obstacle);
    const PartInSpace remembering(scene);
    Random random(62);
    const auto anyState = [&](double within) {
        PartState state;
        for (int axis = 0; axis < 3; ++axis) state.position[axis] = random.uniform(-within, within);
        state.rotation = Eigen::Quaterniond(random.rotation());
        return state;
    };
    int valid = 0, invalid = 0, inSolid = 0;
    PartState from = anyState(10);
    for (int i = 0; i < inForm(4000, 400); ++i) {
        PartState to = anyState(i % 4 == 0 ? 22 : 3);
        if (i % 4 != 0) to.position += from.position;
        const auto s1 = remembering.at(from), s2 = remembering.at(to);
        const PartInSpace fresh(scene);
        std::pair<ob::State*, double> lastValid(nullptr, 0);
        const bool isFreeStart = fresh.checker->isValid(s1.get());
        const bool isValid = PartInSpace(scene).validator->checkMotion(s1.get(), s2.get());
        BOOST_TEST_CONTEXT("seed 62, motion " << i) {
            BOOST_TEST(remembering.validator->checkMotion(s1.get(), s2.get()) == isValid);
            BOOST_TEST(remembering.validator->checkMotion(s1.get(), s2.get(), lastValid) == isValid);
            BOOST_TEST(remembering.checker->isValid(s2.get()) == fresh.checker->isValid(s2.get()));
            BOOST_TEST((!isValid || isFreeStart));
        }
        (isValid ? valid : invalid) += 1;
        inSolid += fresh.checker->whyInvalid(s2.get()).kind == WhyInvalid::Kind::kInSolid;
        if (isValid || i % 10 == 0) from = to;
    }
    BOOST_TEST(valid > inForm(4000, 400) / 20);
    BOOST_TEST(invalid > inForm(4000, 400) / 20);
    BOOST_TEST(inSolid > inForm(4000, 400) / 50);
}

// The peg starts half inside the block, which its contact zone allows, and moves on until it is all inside.
BOOST_AUTO_TEST_CASE(a_motion_that_leaves_a_contact_zone_into_a_solid_is_invalid) {
    const Mesh part = named(box({1, 1, 1}), "peg"), block = named(box({10, 10, 10}), "block");
    Scene scene = solidScene(part, block);
    scene.obstacles[0].isIgnoredAtStart = true;
    scene.startContact = ContactZone{{Matrix3::Identity(), {10, 0, 0}}, 3};
    const PartInSpace solid(scene), skin(withoutSolids(scene));
    const Vector3 start(10, 0, 0), inside(0, 0, 0), outside(30, 0, 0);
    for (const Vector3& to : {inside, outside}) {
        const bool isFree = to == outside;
        BOOST_TEST(skin.check(start, to));
        BOOST_TEST(skin.check(to, start));
        BOOST_TEST(solid.check(start, to) == isFree);
        BOOST_TEST(solid.check(to, start) == isFree);
        const MotionReport report = solid.validator->report(solid.at(start).get(), solid.at(to).get());
        BOOST_TEST((report.verdict == MotionVerdict::kValid) == isFree);
        std::pair<ob::State*, double> lastValid(nullptr, 1);
        BOOST_TEST(solid.validator->checkMotion(solid.at(start).get(), solid.at(to).get(), lastValid) ==
                   isFree);
        if (isFree) continue;
        BOOST_TEST(std::abs(lastValid.second - 0.3) < 1e-3);  // the zone's border
        BOOST_TEST(std::abs(report.blockedTime - 0.3) < 1e-3);
        BOOST_TEST(!solid.isValid(start + report.blockedTime * (to - start)));
        BOOST_TEST(report.upperClearance <= 0);
    }
    BOOST_TEST(solid.validator->counters().undecided == 0u);
    BOOST_TEST(solid.isValid({7.5, 0, 0}));  // inside, but within the zone
    BOOST_TEST(!solid.isValid({6.5, 0, 0}));
    // The motion leads from inside the zone and the block to outside of both, through the block's face.
    BOOST_TEST(solid.check({8, 0, 0}, {12.9, 0, 0}));
    BOOST_TEST(!solid.check({8, 0, 0}, {8, 5, 0}));
    BOOST_TEST(skin.check({8, 0, 0}, {8, 5, 0}));
    // Within its zone the solid lowers no clearance, although it holds the part.
    const auto s1 = solid.at({7.2, 0, 0}), s2 = solid.at({8, 0, 0});
    BOOST_TEST(std::isinf(solid.validator->report(s1.get(), s2.get()).lowerClearance));
    // The state inside is not taken for free because no surface is in the way from the start.
    const planning::MotionValidator together(solid.si, solid.checker->shared());
    BOOST_TEST(solid.isValid(start));
    BOOST_TEST(!together.checkMotion(solid.at(start).get(), solid.at(inside).get()));
    BOOST_TEST(!solid.isValid(inside));
}

BOOST_AUTO_TEST_CASE(a_motion_at_the_border_of_a_contact_zone_in_a_solid_is_undecided_and_not_invalid) {
    Scene scene = solidScene(box({1, 1, 1}), box({10, 10, 10}));
    scene.obstacles[0].isIgnoredAtStart = true;
    scene.startContact = ContactZone{{Matrix3::Identity(), {10, 0, 0}}, 3};
    const PartInSpace solid(scene);
    const auto s1 = solid.at({7 + 2e-6, 0, 0}), s2 = solid.at({7 + 1e-6, 0, 0});
    std::pair<ob::State*, double> lastValid(nullptr, 1);
    BOOST_TEST(solid.checker->isValid(s1.get()));
    BOOST_TEST(solid.checker->isValid(s2.get()));
    BOOST_TEST(!solid.validator->checkMotion(s1.get(), s2.get()));
    BOOST_TEST(!solid.validator->checkMotion(s1.get(), s2.get(), lastValid));
    BOOST_TEST(solid.validator->counters().undecided == 2u);
    BOOST_TEST((solid.validator->report(s1.get(), s2.get()).verdict == MotionVerdict::kUndecided));
    const RigidMotion motion = motionBetween(solid.checker->pose(s1.get()), solid.checker->pose(s2.get()));
    BOOST_TEST((SceneClearance(scene).check(motion).verdict == SweepVerdict::kUndecided));
}

// The part is far from its own origin, so that the turn of 8e-5 that OMPL leaves out until the end takes it out of the block.
BOOST_AUTO_TEST_CASE(a_motion_out_of_a_solid_by_a_turn_that_ompl_leaves_out_is_invalid) {
    const Vector3 bodyInPart(0, 1e5, 0);
    const PartInSpace solid(solidScene(translated(box({0.5, 0.5, 0.5}), bodyInPart), box({3, 3, 3})), 2e5);
    const auto inside = solid.at(-bodyInPart), outside = solid.at(-bodyInPart, 8e-5);
    BOOST_TEST(!solid.checker->isValid(inside.get()));
    BOOST_TEST(solid.checker->isValid(outside.get()));
    for (const bool isOutward : {true, false}) {
        const ob::State* from = isOutward ? inside.get() : outside.get();
        const ob::State* to = isOutward ? outside.get() : inside.get();
        std::pair<ob::State*, double> lastValid(nullptr, 1);
        BOOST_TEST(!solid.validator->checkMotion(from, to));
        BOOST_TEST(!solid.validator->checkMotion(from, to, lastValid));
        BOOST_TEST(!solid.validator->keepsClearance(from, to, 0.1));
        const auto profile = solid.validator->profile(from, to);
        BOOST_TEST((profile.report.verdict == MotionVerdict::kInvalid));
        BOOST_TEST(profile.report.upperClearance <= 0);
        BOOST_TEST((profile.points.front().clearance > 0) == !isOutward);
        BOOST_TEST((profile.points.back().clearance > 0) == isOutward);
        BOOST_TEST(profile.points.back().time == 1);
    }
}

BOOST_AUTO_TEST_CASE(solids_without_the_parts_are_refused) {
    Scene scene = solidScene(box({1, 1, 1}), box({5, 5, 5}));
    scene.partSolids = nullptr;
    requireRefusedBy([&] { PartInSpace{scene}; }, {"partSolids is null"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
