#include "support/anytime_planner.h"

#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "clearway/planning/objectives.h"
#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/validity_checker.h"
#include "core/number.h"
#include "planning/plan/finish.h"
#include "planning/space/ompl_states.h"
#include "support/processor_time.h"

namespace clearway::testing {
namespace {

/// The longest edge of a planner's trees, as `clearway plan` sets it.
double rangeOf(const Problem& problem, const Model& part) {
    return problem.fineness ? 20 * *problem.fineness : 0.25 * part.box().diagonal().norm();
}

}  // namespace

AnytimePlanner::AnytimePlanner(const Problem& problem, const Scene& scene, const std::string& planner,
                               const Parameters& parameters, const std::string& objective,
                               std::uint32_t seed) {
    const planning::OmplMessages unobserved;
    ompl::RNG::setSeed(seed);
    const Box bounds = boundsOf(problem, scene.environmentBox(), scene.part.box());
    const auto space = planning::makeSpace(problem.space, bounds, scene.part.radiusAboutOrigin());
    si_ = std::make_shared<ob::SpaceInformation>(space);
    si_->setStateValidityChecker(std::make_shared<planning::ValidityChecker>(si_, scene));
    validator_ = std::make_shared<planning::MotionValidator>(si_, scene);
    si_->setMotionValidator(validator_);
    si_->setup();
    objective_ = planning::makeObjective(si_, scene, {objective, {}});
    definition_ = std::make_shared<ob::ProblemDefinition>(si_);
    definition_->setStartAndGoalStates(planning::toOmpl(space, problem.space, problem.start),
                                       planning::toOmpl(space, problem.space, problem.goal));
    definition_->setOptimizationObjective(objective_);
    planner_ = planning::makePlanner(si_, planner);
    if (planning::hasParameter(*planner_, "range")) {
        planning::setParameter(*planner_, "range", formatNumber(rangeOf(problem, scene.part)));
    }
    if (planning::hasParameter(*planner_, "planners")) {
        const std::string one = "RRTConnect[range=" + formatNumber(rangeOf(problem, scene.part)) + "]";
        planning::setParameter(*planner_, "planners", one + "," + one);
    }
    for (const auto& [name, value] : parameters) planning::setParameter(*planner_, name, value);
    planner_->setProblemDefinition(definition_);
    planner_->setup();
}

double AnytimePlanner::planSeconds(double seconds) {
    const double begin = processorSeconds();
    return processorSecondsOf([&] {
        plan(ob::PlannerTerminationCondition([=] { return processorSeconds() - begin >= seconds; }));
    });
}

void AnytimePlanner::planIterations(std::uint64_t iterations) {
    std::atomic<std::uint64_t> asked{0};
    plan(ob::PlannerTerminationCondition([&] { return ++asked > iterations; }));
}

void AnytimePlanner::plan(const ob::PlannerTerminationCondition& isSpent) {
    const planning::OmplMessages unobserved;
    planner_->solve(isSpent);
    if (const auto found = planning::bestSolution(*definition_)) {
        if (!best_ || objective_->isCostBetterThan(ob::Cost(found->cost), ob::Cost(*best_))) {
            best_ = found->cost;
            bestPath_ = found->solution.path_;
        }
    }
    definition_->clearSolutionPaths();
}

double AnytimePlanner::certifiedClearance() {
    if (!bestPath_) return -std::numeric_limits<double>::infinity();
    const auto& states = bestPath_->as<og::PathGeometric>()->getStates();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < states.size(); ++i) {
        least = std::min(least, validator_->report(states[i - 1], states[i]).lowerClearance);
    }
    return least;
}

}  // namespace clearway::testing
