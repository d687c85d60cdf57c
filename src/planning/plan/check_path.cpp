#include "clearway/planning/check_path.h"

#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <memory>

#include "clearway/errors.h"
#include "clearway/planning/displacement_bound.h"
#include "clearway/planning/outside_goal.h"
#include "clearway/planning/validity_checker.h"
#include "core/number.h"
#include "planning/check/motion_resolution.h"
#include "planning/plan/problem_settings.h"
#include "planning/space/ompl_refusal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// The tolerance of ends, as a share of the part's diagonal. Paths written with 6 digits are off by less.
constexpr double kTolerancePerDiagonal = 1e-4;

/// The farthest position, as a multiple of the scene's largest coordinate. Queries know nothing about
/// positions beyond it.
constexpr double kFarthest = 1e12;

double largestCoordinate(const Box& box) {
    return box.isEmpty() ? 0 : std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

void requirePositions(const std::vector<PartState>& path, const Scene& scene, const Box& bounds) {
    const double farthest =
        kFarthest * std::max({largestCoordinate(bounds), largestCoordinate(scene.environmentBox()),
                              largestCoordinate(scene.part.box())});
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double largest = path[i].position.cwiseAbs().maxCoeff();
        if (largest <= farthest) continue;
        throw ArgumentError("state " + std::to_string(i + 1) + " of the path has a coordinate of " +
                            shortNumber(largest) + ", expected at most " + shortNumber(farthest) +
                            ", 1e12 times the scene's largest");
    }
}

}  // namespace

PathCheck checkPath(const Problem& problem, const Scene& scene, const std::vector<PartState>& path,
                    const AuditOptions& options) try {
    if (path.empty()) throw ArgumentError("the path has no state, expected at least one");
    const Box bounds = boundsOf(problem, scene.environmentBox(), scene.part.box());
    requireRangeOf(scene, bounds, finenessOf(problem, scene.part));
    requirePositions(path, scene, bounds);
    const auto si = std::make_shared<ob::SpaceInformation>(
        makeSpace(problem.space, bounds, scene.part.radiusAboutOrigin()));
    const auto checker = std::make_shared<ValidityChecker>(si, scene);
    si->setStateValidityChecker(checker);
    si->setup();

    og::PathGeometric states(si);
    for (const PartState& state : path)
        states.append(toOmpl(si->getStateSpace(), problem.space, state).get());
    const ob::State* first = states.getState(0);
    const ob::State* last = states.getState(states.getStateCount() - 1);

    const DisplacementBound bound = displacementBound(*si->getStateSpace(), scene.part);
    const auto off = [&](const ob::State* state, const PartState& wanted) {
        return bound(state, toOmpl(si->getStateSpace(), problem.space, wanted).get());
    };
    PathCheck check;
    check.tolerance = kTolerancePerDiagonal * scene.part.box().diagonal().norm();
    check.offStart = off(first, problem.start);
    check.offGoal = problem.outside
                        ? OutsideGoal(si, scene, *problem.outside, problem.start).distanceGoal(last)
                        : off(last, problem.goal);
    const double clearance = std::max(0.0, std::min(checker->clearance(first), checker->clearance(last)));
    MotionOptions motions = auditMotions(scene, clearance);
    motions.isStopped = options.isStopped;
    check.audit = audit(states, MotionValidator(si, checker->shared(), motions), options);
    return check;
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

}  // namespace clearway::planning
