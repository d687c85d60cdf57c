#include "planning/planners/rising_floor.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/outside_goal.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/validity_checker.h"
#include "planning/motion/floor_validator.h"
#include "planning/planners/raise_clearance.h"

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
        definition_->setGoal(goalOf(owner.pdef_->getGoal()));
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
    /// A goal outside has to draw states that keep the floor.
    ob::GoalPtr goalOf(const ob::GoalPtr& given) const {
        const auto* outside = dynamic_cast<const OutsideGoal*>(given.get());
        return outside == nullptr ? given : std::make_shared<OutsideGoal>(si_, *outside);
    }

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
    patience_ = 0;
}

/// No path can have more clearance than its ends, nor more than the environment's reach or the objective's
/// cap. A goal of many states is taken to have one with as much as the start.
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

bool RisingFloor::isSatisfied(const Found& found, double most) const {
    if (found.clearance >= kNearlyMost * most) return true;
    const ob::OptimizationObjectivePtr& objective = pdef_->getOptimizationObjective();
    return objective && objective->isSatisfied(found.path->cost(objective));
}

std::optional<RisingFloor::Found> RisingFloor::planKeeping(
    double floor, const ob::PlannerTerminationCondition& isSpent) const {
    const std::shared_ptr<og::PathGeometric> states = Round(*this, floor).solve(isSpent);
    if (!states) return std::nullopt;
    Found found{std::make_shared<og::PathGeometric>(si_), 0};
    for (const ob::State* state : states->getStates()) found.path->append(state);
    found.clearance = std::max(floor, audit(*found.path, *validator_).lowerClearance);
    return found;
}

void RisingFloor::raise(const ob::PlannerTerminationCondition& isSpent, double seconds, double most) {
    const Clock::time_point begin = Clock::now();
    RaiseOptions options;
    options.clearance = best_->clearance;
    options.enough = kNearlyMost * most;
    options.isSpent = [&] { return isSpent() || secondsSince(begin) > seconds; };
    best_->clearance = raiseClearance(*best_->path, *validator_, options);
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
    double share = 0;  // of the difference between the best and the most clearance
    while (!isSpent() && !(best_ && isSatisfied(*best_, most))) {
        const Clock::time_point begin = Clock::now();
        const ob::PlannerTerminationCondition isOver(
            [&] { return isSpent() || (best_ && secondsSince(begin) > patience_); });
        const double floor = best_ ? best_->clearance + share * (most - best_->clearance) : 0;
        std::optional<Found> found = planKeeping(floor, isOver);
        const double spent = secondsSince(begin);
        if (found) {
            best_ = std::move(found);
            patience_ = std::max(kLeastPatience, kPatience * spent);
            share = kFirstShare;
        } else {
            patience_ *= kGrowth;
            share = share > kLeastShare ? 0.5 * share : kFirstShare;
        }
        if (best_) raise(isSpent, std::max(spent, kLeastPatience), most);
    }
    if (!best_) return ob::PlannerStatus::TIMEOUT;
    ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*best_->path));
    solution.setPlannerName(getName());
    pdef_->addSolutionPath(solution);
    return ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace clearway::planning
