#include "planning/plan/widening.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>

#include "clearway/planning/motion_validator.h"
#include "clearway/scene_clearance.h"
#include "core/clock.h"
#include "planning/improve/kept_clearance.h"
#include "planning/improve/part_moves.h"
#include "planning/improve/widen_both_ways.h"
#include "planning/plan/finish.h"
#include "planning/plan/goals.h"
#include "planning/planners/rising_floor.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// The clearances before and after are measured to these shares. The time is for bands.
constexpr double kBeforeAccuracy = 0.1, kAfterAccuracy = 0.01;
/// In a hurry one question does: whether the path keeps so much of the clearance expected. A path that winds less may have 3 % less.
constexpr double kSurely = 0.96, kHurried = 1;

constexpr int kEndBisections = 10;  ///< of the motion that leads outside

/// Whether a clearance still grows fast: by kFastGrowth within this share of the time so far.
constexpr double kFastGrowth = 0.05, kLookBack = 0.3;
constexpr double kLookSeconds = 0.01;  ///< between two looks
constexpr double kOneWay = 1.25;       ///< times as long goes on what has widened a single way

/// Watches a clearance. Several threads ask.
class Growth {
  public:
    template <class Clearance>
    bool isFast(const Clearance& clearance) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const double now = secondsSince(begin_);
        if (now - looked_ < kLookSeconds) return isFast_;
        looked_ = now;
        const double grown = clearance();
        if (grown > (1 + kFastGrowth) * reference_) {
            reference_ = grown;
            lastGrown_ = now;
        }
        isFast_ = now - lastGrown_ < kLookBack * now;
        return isFast_;
    }

  private:
    std::mutex mutex_;
    const Clock::time_point begin_ = Clock::now();
    double looked_ = 0, reference_ = 0, lastGrown_ = 0;
    bool isFast_ = true;
};

/// The setup's problem with a validator that ends with the time for widening, and without an objective.
class WideningSetup {
  public:
    WideningSetup(const PlanSetup& setup, const WideningLimits& limits)
        : si_(makeOnSharedSpace(setup.si->getStateSpace())),
          definition_(std::make_shared<ob::ProblemDefinition>(si_)) {
        const SharedScene& scene = setup.checker->shared();
        validator_ = std::make_shared<MotionValidator>(
            si_, scene, MotionOptions{setup.auditor->leastInterval(), limits.isSpent});
        si_->setStateValidityChecker(std::make_shared<ValidityChecker>(si_, scene));
        si_->setMotionValidator(validator_);
        setUpOnSharedSpace(*si_);
        for (unsigned int i = 0; i < setup.definition->getStartStateCount(); ++i) {
            definition_->addStartState(setup.definition->getStartState(i));
        }
        definition_->setGoal(setup.definition->getGoal());
    }

    const ob::SpaceInformationPtr& si() const { return si_; }
    const ob::ProblemDefinitionPtr& definition() const { return definition_; }
    const MotionValidator& validator() const { return *validator_; }

    og::PathGeometric copyOf(const og::PathGeometric& path) const {
        og::PathGeometric copy(si_);
        for (unsigned int i = 0; i < path.getStateCount(); ++i) copy.append(path.getState(i));
        return copy;
    }

  private:
    ob::SpaceInformationPtr si_;
    ob::ProblemDefinitionPtr definition_;
    std::shared_ptr<MotionValidator> validator_;
};

/// Returns the clearance that the widened path keeps, if it is known.
double widenBySweeps(const WideningSetup& setup, og::PathGeometric& path, const WideningLimits& limits,
                     double kept) {
    const Scene& scene = setup.validator().scene();
    const PartMoves moves(*setup.si()->getStateSpace(), scene.part);
    const SceneClearance& clearance = *setup.validator().shared().clearance();
    const double most = [&] {
        const SceneClearance::ColdStart cold(clearance);
        return clearance.at(moves.pose(path.getState(0))).lower;
    }();
    endFurtherOut(path, setup.definition()->getGoal(), scene, most);
    WideningOptions options;
    options.clearance = kept;
    options.sweeps = limits.sweeps;
    options.isSpent = limits.isSpent;
    return widenBothWays(path, setup.validator(), options);
}

double widenInTime(const WideningSetup& setup, og::PathGeometric& path, const WideningLimits& limits,
                   double kept) {
    RisingFloor rising(setup.si());
    rising.setProblemDefinition(setup.definition());
    rising.setRange(limits.range);
    rising.setThreads(std::max(1u, limits.threads));
    rising.lookForShortPaths();
    rising.setup();
    rising.startFrom(path, {kept, limits.planningSeconds});
    Growth growth;
    const Clock::time_point begin = Clock::now();
    std::atomic<double> due{0};
    rising.solve(ob::PlannerTerminationCondition([&] {
        const bool isFast = growth.isFast([&] { return rising.clearance().value_or(0); });
        if (limits.isSpent()) return true;
        if (!limits.isDue() || isFast) return false;
        if (due == 0) due = secondsSince(begin);
        return rising.hasWidenedSeveral() || secondsSince(begin) > kOneWay * due;
    }));
    if (const ob::PathPtr found = setup.definition()->getSolutionPath()) {
        path = *std::static_pointer_cast<og::PathGeometric>(found);
    }
    return rising.clearance().value_or(0);
}

/// Ends the path where its first motion that leads outside gets there: widenPath led it on, for clearance at its end.
void endOnceOutside(const PlanSetup& setup, og::PathGeometric& path) {
    cutOutside(setup, path);
    const auto last = static_cast<unsigned int>(path.getStateCount()) - 1;
    const ob::GoalPtr& goal = setup.definition->getGoal();
    if (last == 0 || !isOutside(goal, path.getState(last))) return;
    const og::PathGeometric whole = path;
    double inside = 0, outside = 1;
    const auto endAt = [&](double time) {
        setup.si->getStateSpace()->interpolate(whole.getState(last - 1), whole.getState(last), time,
                                               path.getState(last));
    };
    for (int k = 0; k < kEndBisections; ++k) {
        const double middle = 0.5 * (inside + outside);
        endAt(middle);
        (isOutside(goal, path.getState(last)) ? outside : inside) = middle;
    }
    endAt(outside);
}

}  // namespace

WideningReport widenPath(const PlanSetup& setup, og::PathGeometric& path, const WideningLimits& limits) {
    const WideningSetup wide(setup, limits);
    const double most = setup.auditor->scene().part.box().diagonal().norm();
    WideningReport report;
    report.before = keptClearance(path, wide.validator(), {0, most, kBeforeAccuracy, limits.isSpent});
    og::PathGeometric widened = wide.copyOf(path);
    const double expected =
        (limits.sweeps ? widenBySweeps : widenInTime)(wide, widened, limits, report.before);
    endOnceOutside(setup, widened);
    // The auditor decides: its motions do not end with the time for widening.
    report.after = setup.isStopped()
                       ? keptClearance(widened, *setup.auditor,
                                       {0, expected > 0 ? kSurely * expected : most, kHurried, {}})
                       : keptClearance(widened, *setup.auditor, {0, most, kAfterAccuracy, {}, expected});
    if (report.after < report.before) {
        report.after = report.before;
        return report;
    }
    path.clear();
    for (const ob::State* state : widened.getStates()) path.append(state);
    return report;
}

}  // namespace clearway::planning
