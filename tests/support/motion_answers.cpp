#include "support/motion_answers.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <utility>

namespace clearway::testing {

namespace ob = ompl::base;
using planning::MotionVerdict;

namespace {

Scene withObstaclesReversed(Scene scene) {
    std::reverse(scene.obstacles.begin(), scene.obstacles.end());
    return scene;
}

template <class Call>
MotionVerdict verdictOf(const planning::MotionValidator& validator, const Call& isValid) {
    const planning::MotionCounters before = validator.counters();
    if (isValid()) return MotionVerdict::kValid;
    const planning::MotionCounters after = validator.counters();
    BOOST_TEST(after.unusable == before.unusable);
    return after.undecided > before.undecided ? MotionVerdict::kUndecided : MotionVerdict::kInvalid;
}

}  // namespace

OtherValidators::OtherValidators(const CrowdedScene& scene)
    : reversed(scene.si, withObstaclesReversed(scene.scene), scene.limit.options()),
      byCallbacks(scene.si,
                  planning::SharedScene(scene.scene, planning::stateToPose(*scene.space),
                                        planning::displacementBound(*scene.space, scene.scene.part),
                                        planning::stateMotion(scene.space, scene.scene.part)),
                  scene.limit.options()),
      byClearance(scene.si,
                  planning::SharedScene(scene.scene, planning::stateToPose(*scene.space),
                                        planning::displacementBound(*scene.space, scene.scene.part)),
                  scene.limit.options()) {}

MotionAnswers::MotionAnswers(std::string theName, const planning::MotionValidator& validator,
                             const CrowdedScene& scene, const HardMotion& motion)
    : name(std::move(theName)), leastInterval(validator.leastInterval()) {
    const ob::State *s1 = motion.s1.get(), *s2 = motion.s2.get();
    const auto limited = [&](const auto& call) {
        scene.limit.begin();
        const auto result = call();
        isStopped = isStopped || scene.limit.isReached();
        return result;
    };
    check = limited([&] { return verdictOf(validator, [&] { return validator.checkMotion(s1, s2); }); });
    ob::ScopedState<> reached(scene.space), expected = motion.s1;
    std::pair<ob::State*, double> last(reached.get(), 1);
    forward =
        limited([&] { return verdictOf(validator, [&] { return validator.checkMotion(s1, s2, last); }); });
    lastValid = last.second;
    BOOST_TEST((forward == MotionVerdict::kValid ? lastValid == 1 : lastValid >= 0 && lastValid < 1));
    if (lastValid > 0) scene.space->interpolate(s1, s2, lastValid, expected.get());
    if (lastValid < 1) BOOST_TEST(reached.reals() == expected.reals());

    constexpr double kLongestProfiled = 10;  // part's diagonals: a profile has 50 points in each
    const double travel = planning::displacementBound(*scene.space, scene.scene.part)(s1, s2);
    if (travel <= kLongestProfiled * scene.diagonal) {
        profile = limited([&] { return validator.profile(s1, s2); });
    } else {
        profile.report = limited([&] { return validator.report(s1, s2); });
    }
    BOOST_TEST(!report().whyInvalid.isUnusable());
}

bool MotionAnswers::says(MotionVerdict verdict) const {
    return check == verdict || forward == verdict || report().verdict == verdict;
}

double MotionAnswers::certified() const {
    return says(MotionVerdict::kValid) ? 1 : std::max(lastValid, report().certifiedTime);
}

}  // namespace clearway::testing
