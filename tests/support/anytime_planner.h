// A planner that keeps improving its path, asked again and again for its best path.
#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/Planner.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::testing {

class AnytimePlanner {
  public:
    using Parameters = std::vector<std::pair<std::string, std::string>>;

    /// Plans with certified motions, the edges and turn weight of `clearway plan`, and an objective by name.
    AnytimePlanner(const Problem& problem, const Scene& scene, const std::string& planner,
                   const Parameters& parameters, const std::string& objective, std::uint32_t seed);

    /// Plans on for `seconds` of processor time of all its threads, which makes the amount of work
    /// independent of other load on the machine. Returns the time used; it is less if the planner ended by
    /// itself.
    double planSeconds(double seconds);

    /// Plans as long as the planner asks at most this often whether to end: for most planners, once per
    /// iteration.
    void planIterations(std::uint64_t iterations);

    /// The best cost of all paths found so far; nothing if there is none.
    const std::optional<double>& best() const { return best_; }

    /// Whether the best cost is optimal.
    bool isSatisfied() const { return best_ && objective_->isSatisfied(ompl::base::Cost(*best_)); }

    /// The least clearance of the best path, by the validator's reports, whatever the objective.
    double certifiedClearance();

    const ompl::base::OptimizationObjective& objective() const { return *objective_; }

  private:
    void plan(const ompl::base::PlannerTerminationCondition& isSpent);

    ompl::base::SpaceInformationPtr si_;
    std::shared_ptr<planning::MotionValidator> validator_;
    ompl::base::OptimizationObjectivePtr objective_;
    ompl::base::ProblemDefinitionPtr definition_;
    ompl::base::PlannerPtr planner_;
    ompl::base::PathPtr bestPath_;
    std::optional<double> best_;
};

}  // namespace clearway::testing
