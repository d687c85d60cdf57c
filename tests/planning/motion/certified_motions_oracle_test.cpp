// Hard motions in crowded scenes: the answers of validators, checked at many poses by the validity checker. With
// CLEARWAY_FULL=1 there are more than 20,000 motions of more than 1,000 poses.
#include <array>
#include <boost/test/unit_test.hpp>
#include <sstream>
#include <string>

#include "support/full_run.h"
#include "support/motion_judge.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(certified_motions_oracle_test)

namespace {

namespace ob = ompl::base;

std::string described(const ob::ScopedState<>& state) {
    std::ostringstream text;
    text.precision(17);
    for (const double value : state.reals()) text << value << " ";
    return text.str();
}

using TallyOfKinds = std::array<MotionTally, kHardKinds>;

MotionTally judgeMotions(const CrowdedScene& scene, int motions, int poses, TallyOfKinds& kinds) {
    OtherValidators others(scene);
    MotionTally all;
    for (int seed = 1; seed <= motions; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const int kind = seed % kHardKinds;
        const HardMotion motion(scene, static_cast<HardKind>(kind), random);
        BOOST_TEST_CONTEXT(scene.name << ", " << kHardKindNames[kind] << ", seed " << seed << ", from "
                                      << described(motion.s1) << "to " << described(motion.s2)) {
            const MotionTally tally = judgeMotion(scene, others, motion, poses, random);
            kinds[static_cast<std::size_t>(kind)] += tally;
            all += tally;
        }
    }
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

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
