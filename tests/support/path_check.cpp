#include "support/path_check.h"

#include <ompl/base/ScopedState.h>

#include <algorithm>
#include <limits>

#include "clearway/planning/state_to_pose.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing {

std::vector<Pose> posesAlong(const std::vector<PartState>& path, Space kind, double sceneSize, int states) {
    const Box anywhere(Vector3::Constant(-1e9), Vector3::Constant(1e9));
    const auto space = planning::makeSpace(kind, anywhere, sceneSize / 10);
    const auto toPose = planning::stateToPose(*space);
    std::vector<ob::ScopedState<>> given;
    std::vector<double> reached{0};
    for (const PartState& state : path) {
        given.push_back(planning::toOmpl(space, kind, state));
        if (given.size() > 1)
            reached.push_back(reached.back() + given[given.size() - 2].distance(given.back()));
    }
    std::vector<Pose> poses;
    for (int i = 0; i < states; ++i) {
        const double length = reached.back() * i / (states - 1);
        const auto next = std::upper_bound(reached.begin() + 1, reached.end() - 1, length) - reached.begin();
        const auto k = static_cast<std::size_t>(next);
        const double gap = reached[k] - reached[k - 1];
        ob::ScopedState<> state(space);
        space->interpolate(given[k - 1].get(), given[k].get(), gap > 0 ? (length - reached[k - 1]) / gap : 0,
                           state.get());
        poses.push_back(toPose(state.get()));
    }
    return poses;
}

double leastDistance(const MeshOracle& oracle, const std::vector<PartState>& path, const Problem& problem,
                     int states) {
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& pose : posesAlong(path, problem.space, oracle.sceneSize(), states)) {
        least = std::min(least, oracle.distance(pose).distance);
    }
    return least;
}

int collisionsAlong(const MeshOracle& oracle, const std::vector<PartState>& path, const Problem& problem,
                    int states) {
    int collisions = 0;
    for (const Pose& pose : posesAlong(path, problem.space, oracle.sceneSize(), states)) {
        collisions += oracle.collides(pose);
    }
    return collisions;
}

}  // namespace clearway::testing
