#include "planning/planners/rising_floor.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <vector>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/validity_checker.h"
#include "planning/motion/floor_validator.h"
#include "planning/paths/room_both_ways.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Clock = std::chrono::steady_clock;

constexpr double kFirstShare = 0.3;       ///< of the difference between the best and the most clearance
constexpr double kLeastShare = 1.0 / 32;  ///< below it the shares begin anew, with more patience
constexpr double kPatience = 4;           ///< times the duration of the round that found the best path
constexpr double kLeastPatience = 0.05;   ///< seconds
constexpr double kGrowth = 1.5;           ///< of patience, when a round finds nothing
constexpr double kNearlyMost = 0.99;      ///< of the most: as good as it, since clearances are known to 1 %
constexpr double kWantedSlack = 1.15;     ///< costs are up to 10 % lower than clearances
constexpr int kFirstIdleStages = 4;       ///< of a path's first band: another way may have more room
constexpr double kGainLoss = 0.5;         ///< from one band of a path to the next
constexpr double kLeastGain = 1e-3;  ///< the smallest steps; a band begins with large ones again after them

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

/// The problem with margins raised by a floor, and the planners for it.
class RisingFloor::Round {
  public:
    Round(const RisingFloor& owner, double floor)
        : si_(std::make_shared<ob::SpaceInformation>(owner.si_->getStateSpace())),
          definition_(std::make_shared<ob::ProblemDefinition>(si_)) {
        Scene raised = owner.validator_->scene();
        for (Obstacle& obstacle : raised.obstacles) obstacle.margin += floor;
        si_->setStateValidityChecker(std::make_shared<ValidityChecker>(si_, raised));
        si_->setMotionValidator(std::make_shared<FloorValidator>(si_, *owner.validator_, floor));
        si_->setup();
        for (unsigned int i = 0; i < owner.pdef_->getStartStateCount(); ++i) {
            definition_->addStartState(owner.pdef_->getStartState(i));
        }
        definition_->setGoal(owner.pdef_->getGoal());
        for (unsigned int i = 0; i < owner.threads_; ++i) {
            planners_.push_back(i % 2 == 0 ? make<og::RRTConnect>(owner.range_)
                                           : make<og::RRT>(owner.range_));
        }
    }

    /// Returns a path, or null.
    std::shared_ptr<og::PathGeometric> solve(const ob::PlannerTerminationCondition& isSpent) {
        const ob::PlannerTerminationCondition isOver([&] { return isFound_ || isSpent(); });
        solveSideBySide(planners_, isOver, [&] { isFound_ = true; });
        if (!definition_->hasExactSolution()) return nullptr;
        return std::static_pointer_cast<og::PathGeometric>(definition_->getSolutionPath());
    }

  private:
    template <class Tree>
    ob::PlannerPtr make(double range) {
        const auto planner = std::make_shared<Tree>(si_);
        planner->setRange(range);
        planner->setProblemDefinition(definition_);
        planner->setup();
        return planner;
    }

    ob::SpaceInformationPtr si_;
    ob::ProblemDefinitionPtr definition_;
    std::vector<ob::PlannerPtr> planners_;
    std::atomic<bool> isFound_{false};
};

RisingFloor::RisingFloor(const ob::SpaceInformationPtr& si) : Planner(si, "RisingFloor") {
    specs_.optimizingPaths = true;
    specs_.multithreaded = true;
    declareParam<double>("range", this, &RisingFloor::setRange, &RisingFloor::getRange, "0.:1.:10000.");
    declareParam<unsigned int>("threads", this, &RisingFloor::setThreads, &RisingFloor::getThreads, "1:256");
}

void RisingFloor::clear() {
    Planner::clear();
    best_.reset();
    patience_ = share_ = 0;
}

void RisingFloor::startFrom(const og::PathGeometric& path, const First& first) {
    best_ = Found{std::make_shared<og::PathGeometric>(si_), first.clearance, 0};
    for (unsigned int i = 0; i < path.getStateCount(); ++i) best_->path->append(path.getState(i));
    patience_ = std::max(kLeastPatience, first.seconds);
    share_ = kFirstShare;
}

/// No path can have more clearance than its ends, nor more than the environment's reach or the objective's
/// cap.
double RisingFloor::mostClearance() const {
    const MinClearanceObjective objective(si_, validator_->scene());
    double most = objective.cap();
    for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i) {
        most = std::min(most, objective.stateCost(pdef_->getStartState(i)).value());
    }
    const auto* goal = dynamic_cast<const ob::GoalState*>(pdef_->getGoal().get());
    if (goal != nullptr) most = std::min(most, objective.stateCost(goal->getState()).value());
    return most;
}

/// The objective's threshold, and a little more because its costs are lower than clearances; infinite for others.
double RisingFloor::wantedClearance() const {
    const auto* objective =
        dynamic_cast<const MinClearanceObjective*>(pdef_->getOptimizationObjective().get());
    return objective ? kWantedSlack * objective->getCostThreshold().value()
                     : std::numeric_limits<double>::infinity();
}

bool RisingFloor::isSatisfied(const Found& found, double most) const {
    if (found.clearance >= kNearlyMost * most) return true;
    const ob::OptimizationObjectivePtr& objective = pdef_->getOptimizationObjective();
    return objective && objective->isSatisfied(found.path->cost(objective));
}

std::optional<RisingFloor::Found> RisingFloor::planKeeping(
    double floor, const ob::PlannerTerminationCondition& isSpent) const {
    const std::shared_ptr<og::PathGeometric> states = Round(*this, floor).solve(isSpent);
    if (!states) return std::nullopt;
    Found found{std::make_shared<og::PathGeometric>(si_), floor, 0};
    for (const ob::State* state : states->getStates()) found.path->append(state);
    return found;
}

/// A path's first band goes both ways, the next ones go on from the better one.
void RisingFloor::widen(Found& found, const std::function<bool()>& isSpent, double most) const {
    RoomOptions options;
    options.clearance = found.clearance;
    options.enough = std::min(kNearlyMost * most, wantedClearance());
    options.isSpent = isSpent;
    if (found.gain == 0) {
        options.idleStages = kFirstIdleStages;
        found.clearance = makeRoomBothWays(*found.path, *validator_, options, threads_ > 1);
        found.gain = kFirstBandGain;
    } else {
        found.gain = found.gain > kLeastGain ? kGainLoss * found.gain : kFirstBandGain;
        options.gain = found.gain;
        found.clearance = makeRoom(*found.path, *validator_, options);
    }
}

void RisingFloor::takeIfBetter(Found found) {
    if (!best_ || found.clearance > best_->clearance) best_ = std::move(found);
}

/// Looks for a path with another way that keeps more than the best one.
void RisingFloor::planAnew(const ob::PlannerTerminationCondition& isSpent, double most) {
    const Clock::time_point begin = Clock::now();
    const ob::PlannerTerminationCondition isOver(
        [&] { return isSpent() || (best_ && secondsSince(begin) > patience_); });
    std::optional<Found> found =
        planKeeping(best_ ? best_->clearance + share_ * (most - best_->clearance) : 0, isOver);
    const double spent = secondsSince(begin);
    if (found) {
        patience_ = std::max(kLeastPatience, kPatience * spent);
        share_ = kFirstShare;
        widen(*found, isSpent, most);
        takeIfBetter(std::move(*found));
        return;
    }
    patience_ *= kGrowth;
    share_ = share_ > kLeastShare ? 0.5 * share_ : kFirstShare;
    const Clock::time_point failed = Clock::now();
    const double seconds = std::max(spent, kLeastPatience);
    if (best_)
        widen(
            *best_, [&] { return isSpent() || secondsSince(failed) > seconds; }, most);
}

/// Without a valid start each round would fail immediately and print OMPL's error again.
bool RisingFloor::hasValidStart() const {
    for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i) {
        const ob::State* start = pdef_->getStartState(i);
        if (si_->satisfiesBounds(start) && si_->isValid(start)) return true;
    }
    return false;
}

ob::PlannerStatus RisingFloor::solve(const ob::PlannerTerminationCondition& isSpent) {
    checkValidity();
    if (!hasValidStart()) {
        OMPL_ERROR("%s: There are no valid initial states!", getName().c_str());
        return ob::PlannerStatus::INVALID_START;
    }
    validator_ = std::dynamic_pointer_cast<const MotionValidator>(si_->getMotionValidator());
    if (!validator_) validator_ = std::make_shared<MotionValidator>(si_, sceneOf(si_));
    const double most = mostClearance();
    if (best_ && best_->gain == 0)
        widen(
            *best_, [&] { return isSpent(); }, most);
    while (!isSpent() && !(best_ && isSatisfied(*best_, most))) planAnew(isSpent, most);
    if (!best_) return ob::PlannerStatus::TIMEOUT;
    ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*best_->path));
    solution.setPlannerName(getName());
    pdef_->addSolutionPath(solution);
    return ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace clearway::planning
