#include "planning/planners/rising_floor.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/validity_checker.h"
#include "core/clock.h"
#include "planning/check/floor_validator.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

constexpr double kAsGoodAsMost = 0.99;  ///< of the most: as good as it, since clearances are known to 1 %
constexpr double kWantedSlack = 1.15;   ///< costs are up to 10 % lower than clearances

}  // namespace

RisingFloor::RisingFloor(const ob::SpaceInformationPtr& si) : Planner(si, "RisingFloor") {
    specs_.optimizingPaths = true;
    specs_.multithreaded = true;
    declareParam<double>("range", this, &RisingFloor::setRange, &RisingFloor::getRange, "0.:1.:10000.");
    declareParam<unsigned int>("threads", this, &RisingFloor::setThreads, &RisingFloor::getThreads, "1:256");
    addPlannerProgressProperty("best cost REAL", [this] {
        const std::optional<double> best = clearance();
        return best ? std::to_string(*best) : std::string();
    });
}

RisingFloor::~RisingFloor() = default;

void RisingFloor::clear() {
    Planner::clear();
    {
        const std::lock_guard<std::mutex> lock(searchMutex_);
        search_.reset();
    }
    first_.reset();
    team_.reset();
    validator_.reset();
    checker_.reset();
}

std::shared_ptr<const FloorSearch> RisingFloor::search() const {
    const std::lock_guard<std::mutex> lock(searchMutex_);
    return search_;
}

std::optional<double> RisingFloor::clearance() const {
    const auto found = search();
    return found ? std::optional<double>(found->clearance()) : std::nullopt;
}

bool RisingFloor::hasWidenedSeveral() const {
    const auto found = search();
    return found && found->hasWidenedSeveral();
}

void RisingFloor::getPlannerData(ob::PlannerData& data) const {
    Planner::getPlannerData(data);
    if (search_) {
        search_->getPlannerData(data);
    } else if (team_) {
        team_->getPlannerData(data);
    }
}

void RisingFloor::startFrom(const og::PathGeometric& path, const First& first) {
    auto states = std::make_shared<og::PathGeometric>(si_);
    for (unsigned int i = 0; i < path.getStateCount(); ++i) states->append(path.getState(i));
    first_ = {{states, first.clearance}, first.seconds};
}

/// No path can have more clearance than its ends, nor more than the environment's range. A goal of many states is taken to have
/// one with as much as the start. Where no obstacle is in range, any length is as good.
double RisingFloor::mostClearance() const {
    const MinClearanceObjective objective(si_, validator_->shared());
    double most = -std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i) {
        most = std::max(most, objective.stateCost(pdef_->getStartState(i)).value());
    }
    const auto* goal = dynamic_cast<const ob::GoalState*>(pdef_->getGoal().get());
    if (goal != nullptr) most = std::min(most, objective.stateCost(goal->getState()).value());
    return std::min(most,
                    std::isfinite(most) ? objective.cap() : validator_->scene().part.box().diagonal().norm());
}

/// Costs are up to 10 % lower than clearances, so a threshold asks for a little more, or for a path of such a cost.
FloorSearchOptions RisingFloor::searchOptions() const {
    FloorSearchOptions options;
    options.range = range_;
    options.threads = threads_;
    options.wantsShortPaths = wantsShortPaths_;
    options.most = mostClearance();
    options.enough = kAsGoodAsMost * options.most;
    const auto objective =
        std::dynamic_pointer_cast<const MinClearanceObjective>(pdef_->getOptimizationObjective());
    if (!objective) return options;
    const double threshold = objective->getCostThreshold().value();
    options.enough = std::min(options.enough, kWantedSlack * threshold);
    options.isEnough = [this, threshold](const WidePath& path) {
        const ob::OptimizationObjectivePtr& cost = pdef_->getOptimizationObjective();
        return path.clearance >= threshold && cost->isSatisfied(path.path->cost(cost));
    };
    return options;
}

/// A validator of its own serves until the scene is another one.
void RisingFloor::chooseValidator() {
    const auto given = std::dynamic_pointer_cast<const MotionValidator>(si_->getMotionValidator());
    const ob::StateValidityCheckerPtr& checker = si_->getStateValidityChecker();
    if (given) {
        validator_ = given;
        checker_.reset();
    } else if (checker_ != checker) {
        validator_ = std::make_shared<MotionValidator>(si_, sceneOf(si_));
        checker_ = checker;
    }
}

/// Without a valid start each round would fail immediately and print OMPL's error again.
bool RisingFloor::hasValidStart() const {
    for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i) {
        const ob::State* start = pdef_->getStartState(i);
        if (si_->satisfiesBounds(start) && si_->isValid(start)) return true;
    }
    return false;
}

/// Goes on with the team of a former solve(), which follows what the problem definition has become.
ob::PlannerStatus RisingFloor::findFirst(const ob::PlannerTerminationCondition& isSpent) {
    const Clock::time_point begin = Clock::now();
    if (!team_ || teamValidator_ != validator_ || team_->getRange() != range_ ||
        team_->getThreads() != threads_) {
        const auto certified = makeOnSharedSpace(si_->getStateSpace());
        certified->setStateValidityChecker(
            std::make_shared<ValidityChecker>(certified, validator_->shared()));
        certified->setMotionValidator(std::make_shared<FloorValidator>(certified, *validator_, 0));
        setUpOnSharedSpace(*certified);
        team_ = std::make_shared<PlannerTeam>(certified);
        teamValidator_ = validator_;
        teamSeconds_ = 0;
        team_->setRange(range_);
        team_->setThreads(threads_);
    }
    const auto definition = std::make_shared<ob::ProblemDefinition>(team_->getSpaceInformation());
    for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i) {
        definition->addStartState(pdef_->getStartState(i));
    }
    definition->setGoal(pdef_->getGoal());
    team_->setProblemDefinition(definition);
    team_->setup();
    const ob::PlannerStatus status = team_->solve(isSpent);
    teamSeconds_ += secondsSince(begin);
    if (status == ob::PlannerStatus::EXACT_SOLUTION) {
        startFrom(*std::static_pointer_cast<og::PathGeometric>(definition->getSolutionPath()),
                  {0, teamSeconds_});
    }
    return status == ob::PlannerStatus::APPROXIMATE_SOLUTION ? ob::PlannerStatus(ob::PlannerStatus::TIMEOUT)
                                                             : status;
}

ob::PlannerStatus RisingFloor::solve(const ob::PlannerTerminationCondition& isSpent) {
    checkValidity();
    if (!hasValidStart()) {
        OMPL_ERROR("%s: There are no valid initial states!", getName().c_str());
        return ob::PlannerStatus::INVALID_START;
    }
    chooseValidator();
    if (search_ && !search_->isFor(pdef_, validator_)) {
        const std::lock_guard<std::mutex> lock(searchMutex_);
        search_.reset();
    }
    if (!search_ && !first_) {
        const ob::PlannerStatus status = findFirst(isSpent);
        if (!first_) return status;
    }
    if (search_ && first_) search_->add(first_->first, first_->second);
    if (!search_) {
        const std::lock_guard<std::mutex> lock(searchMutex_);
        search_ = std::make_shared<FloorSearch>(si_, pdef_, validator_, first_->first, first_->second);
    }
    first_.reset();
    search_->run(searchOptions(), [&] { return isSpent(); });
    // The widest path replaces this planner's earlier ones, which OMPL would prefer where they are shorter.
    const std::vector<ob::PlannerSolution> earlier = pdef_->getSolutions();
    pdef_->clearSolutionPaths();
    for (const ob::PlannerSolution& other : earlier) {
        if (other.plannerName_ != getName()) pdef_->addSolutionPath(other);
    }
    ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*search_->bestPath().path));
    solution.setPlannerName(getName());
    pdef_->addSolutionPath(solution);
    return ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace clearway::planning
