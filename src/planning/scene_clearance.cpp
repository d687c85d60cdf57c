#include "planning/scene_clearance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/number.h"
#include "planning/thread_workspace.h"

namespace clearway::planning {
namespace {

/// Measured on planners' motions: twice as fast as exact distances, for a few more queries.
constexpr double kRoughError = 0.05;
constexpr double kRoughEnough = 0.9;  ///< of upper: what lower must be, or a tight distance is asked for

}  // namespace

SceneClearance::SceneClearance(Scene scene) : scene_(std::move(scene)), owner_(newWorkspaceOwner()) {
    if (!(scene_.margin >= 0) || !std::isfinite(scene_.margin)) {
        throw std::invalid_argument("margin is " + shortNumber(scene_.margin) +
                                    ", expected a finite number >= 0");
    }
    // Models that cannot be queried together are the caller's mistake: better told here than inside a
    // planner.
    Pose somewhere;
    if (const auto& reach = scene_.environment.reach()) somewhere.translation = reach->positions.center();
    isFree(somewhere);
}

double SceneClearance::mostClearance() const {
    const std::optional<Reach>& reach = scene_.environment.reach();
    return reach ? reach->cap - scene_.margin : std::numeric_limits<double>::infinity();
}

bool SceneClearance::isFree(const Pose& X_environmentPart) const {
    Workspace& workspace = threadWorkspace(owner_);
    if (scene_.margin == 0) return !collides(scene_.part, scene_.environment, X_environmentPart, workspace);
    return !isWithin(scene_.part, scene_.environment, X_environmentPart, scene_.margin, workspace);
}

PoseClearance SceneClearance::at(const Pose& X_environmentPart, const ClearanceOptions& options) const {
    PoseClearance answer;
    DistanceOptions asked;
    asked.cap = options.cap + scene_.margin;
    if (options.isRough) {
        asked.relativeError = kRoughError;
        ask(X_environmentPart, asked, answer);
        const bool isBeyondCap = std::isinf(answer.upper) && answer.lower > 0;
        if (answer.upper <= 0 || isBeyondCap || answer.lower >= kRoughEnough * answer.upper) return answer;
        asked.relativeError = 0;
    }
    ask(X_environmentPart, asked, answer);
    return answer;
}

// lower > margin and upper <= margin decide at once; only an interval that holds the margin asks a second
// time.
void SceneClearance::ask(const Pose& X_environmentPart, const DistanceOptions& options,
                         PoseClearance& answer) const {
    const double margin = scene_.margin;
    DistanceResult& d = answer.nearest;
    d = clearway::distance(scene_.part, scene_.environment, X_environmentPart, options,
                           threadWorkspace(owner_));
    ++answer.queries;
    bool valid = d.upper > margin;
    const bool isSure = margin == 0 || d.lower > margin || !valid;
    if (!isSure && (options.relativeError == 0 || std::isinf(d.upper))) {
        valid = isFree(X_environmentPart);
        ++answer.queries;
    }
    const double above = d.lower - margin;
    answer.lower = valid ? std::max(above, std::numeric_limits<double>::denorm_min()) : std::min(above, 0.0);
    answer.upper = d.upper - margin;
}

DistanceResult SceneClearance::distance(const Pose& X_environmentPart) const {
    return clearway::distance(scene_.part, scene_.environment, X_environmentPart, {},
                              threadWorkspace(owner_));
}

bool SceneClearance::isOutOfReach(const Pose& X_environmentPart) const {
    const std::optional<Reach>& reach = scene_.environment.reach();
    return reach && !reach->positions.contains(X_environmentPart.translation);
}

}  // namespace clearway::planning
