#include "planning/walk.h"

#include <algorithm>
#include <limits>

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// False when the state is invalid.
bool look(const ob::State* state, const ValidityChecker& checker, Walk& walk) {
    double clearance = 0;
    if (!checker.isValid(state, clearance)) return false;
    ++walk.states;
    if (clearance < walk.leastClearance) {
        walk.leastClearance = clearance;
        *walk.where = state;
    }
    return true;
}

double marginOf(const Scene& scene, const SceneDistance& nearest) {
    return nearest.obstacle < 0 ? 0 : scene.obstacles[static_cast<std::size_t>(nearest.obstacle)].margin;
}

double leastMargin(const Scene& scene) {
    double least = scene.largestMargin();
    for (const Obstacle& obstacle : scene.obstacles) least = std::min(least, obstacle.margin);
    return least;
}

}  // namespace

std::optional<Walk> walk(const ompl::geometric::PathGeometric& path, const ValidityChecker& checker,
                         const DiscreteMotionValidator& validator, int refine,
                         const std::function<bool()>& isStopped) {
    const ob::StateSpacePtr& space = path.getSpaceInformation()->getStateSpace();
    Walk result;
    result.leastClearance = std::numeric_limits<double>::infinity();
    result.where.emplace(space);
    ob::ScopedState<> between(space);
    if (path.getStateCount() == 0 || !look(path.getState(0), checker, result)) return std::nullopt;
    for (std::size_t k = 1; k < path.getStateCount(); ++k) {
        const ob::State* from = path.getState(static_cast<unsigned int>(k - 1));
        const ob::State* to = path.getState(static_cast<unsigned int>(k));
        const std::uint64_t parts = validator.partsOf(from, to) * static_cast<std::uint64_t>(refine);
        if (parts == 0 || isStopped() || !look(to, checker, result)) return std::nullopt;
        for (std::uint64_t i = 1; i < parts; ++i) {
            space->interpolate(from, to, static_cast<double>(i) / static_cast<double>(parts), between.get());
            if (!look(between.get(), checker, result)) return std::nullopt;
        }
    }
    result.least = checker.distance(result.where->get());
    result.leastDistance = result.least.lower;
    return result;
}

std::optional<Walk> walkCertified(const ompl::geometric::PathGeometric& path,
                                  const MotionValidator& validator, const std::function<bool()>& isStopped) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const ob::StateSpacePtr& space = path.getSpaceInformation()->getStateSpace();
    const auto count = static_cast<unsigned int>(path.getStateCount());
    Walk result;
    result.leastClearance = kInfinity;
    double certified = kInfinity;
    for (unsigned int k = 0; k < count; ++k) {
        if (k == 0 && count > 1) continue;
        const ob::State *from = path.getState(k > 0 ? k - 1 : 0), *to = path.getState(k);
        if (isStopped()) return std::nullopt;
        const MotionReport report = validator.report(from, to);
        if (report.verdict != MotionVerdict::kValid) return std::nullopt;
        result.states += report.queries;
        certified = std::min(certified, report.lowerClearance);
        const double closest = report.closest.lower - marginOf(validator.scene(), report.closest);
        if (result.where && closest >= result.leastClearance) continue;
        result.leastClearance = closest;
        result.least = report.closest;
        result.where.emplace(space);
        space->copyState(result.where->get(), to);
        if (report.closestTime < 1) space->interpolate(from, to, report.closestTime, result.where->get());
    }
    if (!result.where) return std::nullopt;
    result.leastDistance = std::min(certified + leastMargin(validator.scene()), result.least.lower);
    return result;
}

}  // namespace clearway::planning
