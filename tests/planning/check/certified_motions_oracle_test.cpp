// Hard motions in crowded scenes: the answers of validators, checked at many poses by the validity checker. With
// CLEARWAY_FULL=1 there are more than 20,000 motions of more than 1,000 poses.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/full_run.h"
#include "support/motion_judge.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(certified_motions_oracle_test)

namespace ob = ompl::base;

std::string described(const ob::ScopedState<>& state) {
    std::ostringstream text;
    text.precision(17);
    for (const double value : state.reals()) text << value << " ";
    return text.str();
}

using TallyOfKinds = std::array<MotionTally, kHardKinds>;

/// Each seed is a motion of a scene. Adds its tally to those of the kinds, too.
MotionTally judgeSeed(const CrowdedScene& scene, const OtherValidators& others, int seed, int poses,
                      TallyOfKinds& kinds) {
    Random random(static_cast<std::uint64_t>(seed));
    const int kind = seed % kHardKinds;
    const HardMotion motion(scene, static_cast<HardKind>(kind), random);
    MotionTally tally;
    BOOST_TEST_CONTEXT(scene.name << ", " << kHardKindNames[kind] << ", seed " << seed << ", from "
                                  << described(motion.s1) << "to " << described(motion.s2)) {
        tally = judgeMotion(scene, others, motion, poses, random);
    }
    kinds[static_cast<std::size_t>(kind)] += tally;
    return tally;
}

MotionTally judgeMotions(const CrowdedScene& scene, int motions, int poses, TallyOfKinds& kinds) {
    const OtherValidators others(scene);
    MotionTally all;
    for (int seed = 1; seed <= motions; ++seed) all += judgeSeed(scene, others, seed, poses, kinds);
    return all;
}

BOOST_AUTO_TEST_CASE(answers_about_a_motion_are_true_of_its_poses) {
    const int motions = isFullRun() ? 1620 : 27, poses = isFullRun() ? 1000 : 60;
    TallyOfKinds kinds;
    MotionTally all;
    for (const CrowdedLayout& layout : crowdedLayouts()) {
        const CrowdedScene scene(layout);
        const MotionTally tally = judgeMotions(scene, motions, poses, kinds);
        BOOST_TEST_MESSAGE(scene.name << ": " << tally);
        BOOST_TEST(tally.valid > motions / 10, scene.name);
        BOOST_TEST(tally.invalid > motions / 10, scene.name);
        BOOST_TEST(tally.undecided < motions / 5, scene.name);
        BOOST_TEST((tally.kept > 0 && tally.lost > 0), scene.name);
        if (isFullRun()) BOOST_TEST((tally.crossing > 0) == scene.hasZones(), scene.name);
        all += tally;
    }
    for (int kind = 0; kind < kHardKinds; ++kind) {
        const MotionTally& tally = kinds[static_cast<std::size_t>(kind)];
        BOOST_TEST_MESSAGE(kHardKindNames[kind] << ": " << tally);
        const bool endsOutside = static_cast<HardKind>(kind) == HardKind::kLeavesBounds;
        BOOST_TEST((tally.valid > 0) == !endsOutside, kHardKindNames[kind]);
        BOOST_TEST(tally.invalid > 0, kHardKindNames[kind]);
    }
    BOOST_TEST_MESSAGE("all: " << all);
    BOOST_TEST(all.crossing > 0);
    BOOST_TEST(all.enclosed > 0);
    BOOST_TEST(all.outOfBounds > 0);
    BOOST_TEST(all.turnLeftOut > 0);
    BOOST_TEST(all.otherValid > 0);
}

/// Motions of the long form that were hard for this test: one starts closer than a least interval to a zone's border, one so
/// close to contact that its report gives up where checkMotion goes on.
BOOST_AUTO_TEST_CASE(answers_are_true_at_borders_and_beside_contact) {
    const std::pair<std::string, int> found[] = {{"assembly, far off centre", 907},
                                                 {"plane, far, off centre, range", 1430}};
    const std::vector<CrowdedLayout> layouts = crowdedLayouts();
    TallyOfKinds kinds;
    for (const auto& [name, seed] : found) {
        const auto layout = std::find_if(layouts.begin(), layouts.end(),
                                         [&](const CrowdedLayout& each) { return each.name == name; });
        BOOST_TEST_REQUIRE((layout != layouts.end()), name);
        const CrowdedScene scene(*layout);
        judgeSeed(scene, OtherValidators(scene), seed, 60, kinds);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
