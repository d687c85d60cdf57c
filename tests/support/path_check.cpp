#include "support/path_check.h"

#include <ompl/base/ScopedState.h>

#include <algorithm>
#include <limits>

#include "clearway/planning/state_to_pose.h"
#include "planning/planning_space.h"

namespace clearway::testing {

double leastDistance(const MeshOracle& oracle, const std::vector<PartState>& path, const Problem& problem,
                     int states) {
    const Box anywhere(Vector3::Constant(-1e9), Vector3::Constant(1e9));
    // Weighted by the scene's size, so that turns get their share of the states.
    const auto space = planning::makeSpace(problem.space, anywhere, oracle.sceneSize() / 10);
    const auto toPose = planning::stateToPose(*space);
    std::vector<ompl::base::ScopedState<>> given;
    std::vector<double> reached{0};
    for (const PartState& state : path) {
        given.push_back(planning::toOmpl(space, problem.space, state));
        if (given.size() > 1)
            reached.push_back(reached.back() + given[given.size() - 2].distance(given.back()));
    }
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < states; ++i) {
        const double length = reached.back() * i / (states - 1);
        const auto next = std::upper_bound(reached.begin() + 1, reached.end() - 1, length) - reached.begin();
        const auto k = static_cast<std::size_t>(next);
        const double gap = reached[k] - reached[k - 1];
        ompl::base::ScopedState<> state(space);
        space->interpolate(given[k - 1].get(), given[k].get(), gap > 0 ? (length - reached[k - 1]) / gap : 0,
                           state.get());
        least = std::min(least, oracle.distance(toPose(state.get())).distance);
    }
    return least;
}

}  // namespace clearway::testing
