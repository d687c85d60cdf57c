// Random motions, checked at many poses and around their least distance. The exact oracle judges the poses of
// least distance. With CLEARWAY_FULL=1 there are 10,000 motions of 200 poses and 100 motions of 10,000.
#include <ompl/util/Console.h>

#include <boost/test/unit_test.hpp>
#include <memory>
#include <string>
#include <vector>

#include "support/full_run.h"
#include "support/random_motion.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(motion_oracle_test)

namespace ob = ompl::base;
using planning::MotionReport;
using planning::MotionVerdict;

struct Tally {
    int valid = 0, invalid = 0, undecided = 0, tight = 0;
};

void checkAgainstOracle(const MotionScene& scene, const RandomMotion& motion, int poses, int judged,
                        Tally& tally) {
    const ob::State *s1 = motion.s1.get(), *s2 = motion.s2.get();
    if (!scene.checker->isValid(s1)) return;
    const bool valid = scene.validator->checkMotion(s1, s2);
    std::pair<ob::State*, double> lastValid(nullptr, 2);
    const bool forward = scene.validator->checkMotion(s1, s2, lastValid);
    const MotionReport report = scene.validator->report(s1, s2);
    BOOST_TEST(!report.whyInvalid.isUnusable());
    const double closest = scene.trueClearance(s1, s2, report.closestTime);
    const double least = scene.validator->leastInterval();
    if (valid || forward || report.verdict == MotionVerdict::kValid) {
        const double found = scene.leastTrueClearance(s1, s2, 1, poses, judged);
        BOOST_TEST(found > 0);
        if (report.verdict == MotionVerdict::kValid) {
            BOOST_TEST(report.lowerClearance > 0);
            BOOST_TEST(report.lowerClearance <= found * (1 + 1e-9));
            BOOST_TEST(report.upperClearance >= closest * (1 - 1e-9));
        }
        ++tally.valid;
        tally.tight += found < 100 * least;
    }
    // A motion that is invalid in one order of samples may be undecided, but not valid, in another order,
    // where it comes too close to decide.
    if (!(valid && forward && report.verdict == MotionVerdict::kValid) && !(valid || forward)) {
        const bool isInvalid = report.verdict == MotionVerdict::kInvalid;
        const bool isOutside = isInvalid && !scene.si->satisfiesBounds(s2);
        BOOST_TEST((isOutside || closest <= (isInvalid ? 0 : least)));
        ++(isInvalid ? tally.invalid : tally.undecided);
    }
    if (!forward) BOOST_TEST(scene.leastTrueClearance(s1, s2, lastValid.second, poses, judged) > 0);
}

void checkScenes(std::uint64_t firstSeed, int motions, int poses, int judged) {
    std::vector<std::shared_ptr<const MotionScene>> scenes = motionScenes();
    scenes.push_back(screwMotionScene());
    for (const auto& scene : scenes) {
        Tally tally;
        for (int i = 0; i < motions; ++i) {
            const std::uint64_t seed = firstSeed + static_cast<std::uint64_t>(i);
            BOOST_TEST_CONTEXT(scene->name << ", margin " << scene->scene.largestMargin() << ", seed "
                                           << seed) {
                Random random(seed);
                checkAgainstOracle(*scene, RandomMotion(*scene, random), poses, judged, tally);
            }
        }
        BOOST_TEST_MESSAGE(scene->name << ", margin " << scene->scene.largestMargin() << ", seeds from "
                                       << firstSeed << ": " << tally.valid << " valid, of these "
                                       << tally.tight << " tight; " << tally.invalid << " invalid, "
                                       << tally.undecided << " undecided");
        BOOST_TEST(tally.valid > 0);
        BOOST_TEST(tally.invalid > 0);
    }
}

BOOST_AUTO_TEST_CASE(no_motion_called_valid_touches_by_the_oracle_and_none_called_invalid_is_free) {
    if (!isFullRun()) return checkScenes(1, 35, 200, 1);
    checkScenes(1000, 1700, 200, 5);
    checkScenes(100000, 17, 10000, 100);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
