#include "planning/walk.h"

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
    return result;
}

}  // namespace clearway::planning
