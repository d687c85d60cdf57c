#include "planning/setup/planning_reach.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/number.h"
#include "planning/setup/plan_objective.h"
#include "planning/setup/problem_settings.h"

namespace clearway::planning {
namespace {

constexpr double kDefaultStepPerDiagonal = 1.0 / 500;

/// Of the bounds' diagonal: OMPL takes a state for one within the bounds when it is outside by rounding.
constexpr double kBoundsSlack = 1e-9;

}  // namespace

double stepOf(const Problem& problem, const PlanOptions& options, const Model& part) {
    if (options.step) return *options.step;
    if (problem.step) return *problem.step;
    return kDefaultStepPerDiagonal * part.box().diagonal().norm();
}

std::optional<Reach> planningReach(const Problem& problem, const PlanOptions& options, const Model& part,
                                   const Box& environmentBox) {
    if (mayUseSampler(problem, "max_clearance")) return std::nullopt;
    const Box bounds = boundsOf(problem, environmentBox);
    const Vector3 slack = Vector3::Constant(kBoundsSlack * bounds.diagonal().norm());
    const double radius = part.radiusAboutOrigin();
    const auto objective = chooseObjective(problem, options);
    const double clearance = objective ? largestClearance(*objective, part) : 0;
    const double told = std::max(stepOf(problem, options, part), clearance);
    const double cap = largestMargin(problem) + told + 2 * radius;
    return Reach{Box(bounds.min() - slack, bounds.max() + slack), radius, cap};
}

void requireReachOf(const Scene& scene, const Box& bounds, double step) {
    for (const Obstacle& obstacle : scene.obstacles) {
        if (!obstacle.model.reach()) continue;
        const Reach& reach = *obstacle.model.reach();
        if (!reach.positions.contains(bounds)) {
            throw std::invalid_argument(
                "the environment was built with a reach that leaves out positions within the bounds, "
                "expected one that holds them all");
        }
        if (!(reach.cap >= obstacle.margin + step)) {
            throw std::invalid_argument(
                "the environment was built with a reach whose cap is " + shortNumber(reach.cap) +
                ", expected at least the margin and a step, " + shortNumber(obstacle.margin + step));
        }
    }
}

}  // namespace clearway::planning
