#include "planning/validity/scene_clearance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/number.h"

namespace clearway::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Measured on planners' motions: twice as fast as exact distances, for a few more queries.
constexpr double kRoughError = 0.05;
constexpr double kRoughEnough = 0.9;  ///< of upper: what lower must be, or a tight distance is asked for

/// Visits the obstacles, the one that was nearest last time first, until `visit` says no: it blocks most
/// often, and caps what the others are asked for.
template <class Visit>
bool visitAll(std::size_t count, std::size_t first, const Visit& visit) {
    if (count == 0) return true;
    if (!visit(first)) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (i != first && !visit(i)) return false;
    }
    return true;
}

void requireContact(const char* name, const std::optional<ContactZone>& contact) {
    if (!contact) return;
    requirePose(contact->X_environmentPart);
    if (contact->distance > 0 && std::isfinite(contact->distance)) return;
    throw std::invalid_argument(std::string(name) + ".distance is " + shortNumber(contact->distance) +
                                ", expected a finite length above 0");
}

SceneDistance nowhere() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    SceneDistance result;
    result.lower = result.upper = result.distance = kInfinity;
    result.pointOnPart = result.pointOnEnvironment = Vector3::Constant(kNone);
    return result;
}

}  // namespace

SceneClearance::SceneClearance(Scene scene) : scene_(std::move(scene)), owner_(newScratchOwner()) {
    requireContact("startContact", scene_.startContact);
    requireContact("goalContact", scene_.goalContact);
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        if (!(obstacle.margin >= 0) || !std::isfinite(obstacle.margin)) {
            throw std::invalid_argument("margin is " + shortNumber(obstacle.margin) +
                                        ", expected a finite number >= 0");
        }
        if (obstacle.solids && !scene_.partSolids) {
            throw std::invalid_argument(
                "an obstacle is solid and partSolids is null, expected makeSolids of "
                "the part's mesh");
        }
        hasSolids_ = hasSolids_ || obstacle.solids;
        addZone(i);
        // Models that cannot be queried together are the caller's mistake: better told here than inside a
        // planner.
        Pose somewhere;
        if (const auto& reach = obstacle.model.reach()) somewhere.translation = reach->positions.center();
        isFree(i, somewhere);
    }
}

double SceneClearance::mostClearance() const {
    double most = kInfinity;
    for (const Obstacle& obstacle : scene_.obstacles) {
        if (const auto& reach = obstacle.model.reach()) most = std::min(most, reach->cap - obstacle.margin);
    }
    return most;
}

bool SceneClearance::isFree(const Pose& X_environmentPart) const {
    PoseClearance at;
    findSpares(X_environmentPart, at);
    ThreadScratch& mine = scratch();
    const bool isApart = visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        if (isIgnored(i, at) || isFree(i, X_environmentPart)) return true;
        mine.nearest = i;
        return false;
    });
    if (!isApart || !hasSolids_) return isApart;
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (!isIgnored(i, at) && enclosureBy(i, X_environmentPart)) return false;
    }
    return true;
}

bool SceneClearance::isFree(std::size_t i, const Pose& X_environmentPart) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    ThreadScratch& mine = scratch();
    Workspace& workspace = mine.workspaces[i];
    const bool isBlocked =
        obstacle.margin == 0
            ? collides(scene_.part, obstacle.model, X_environmentPart, workspace)
            : isWithin(scene_.part, obstacle.model, X_environmentPart, obstacle.margin, workspace);
    mine.tally->addWithin(workspace.counters());
    return !isBlocked;
}

// What the nearest obstacle so far leaves caps what the next ones are asked for.
PoseClearance SceneClearance::at(const Pose& X_environmentPart, const ClearanceOptions& options) const {
    PoseClearance answer;
    if (zoneOf_.size() == 1 && zoneOf_[0] < 0 && !hasSolids_) {  // most scenes: nothing to compare
        const Asked found = ask(0, X_environmentPart, options);
        answer.lower = answer.lowerAlways = found.lower;
        answer.upper = answer.upperAlways = found.upper;
        answer.nearest = found.nearest;
        answer.queries = found.queries;
        nameTriangle(answer.nearest);
        return answer;
    }
    findSpares(X_environmentPart, answer);
    ThreadScratch& mine = scratch();
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        ClearanceOptions asked = options;
        asked.cap = std::min(options.cap, answer.upper);
        if (asked.cap + scene_.obstacles[i].margin < 0) return true;
        ZoneClearance* zone = zoneOf_[i] < 0 ? nullptr : &answer.zones[static_cast<std::size_t>(zoneOf_[i])];
        if (zone && zone->isIgnored() && zone->spare >= options.leastSpare) return true;
        const Asked found = ask(i, X_environmentPart, asked);
        answer.queries += found.queries;
        if (zone) {
            const bool isFirst = zone->clearance == kUnknownClearance;
            zone->clearance = isFirst ? found.lower : std::min(zone->clearance, found.lower);
            zone->upper = std::min(zone->upper, found.upper);
            if (zone->isIgnored()) return true;
        } else {
            answer.lowerAlways = std::min(answer.lowerAlways, found.lower);
            answer.upperAlways = std::min(answer.upperAlways, found.upper);
        }
        if (isNearer(found, answer)) {
            answer.nearest = found.nearest;
            mine.nearest = i;
        }
        answer.lower = std::min(answer.lower, found.lower);
        answer.upper = std::min(answer.upper, found.upper);
        return true;
    });
    if (answer.nearest.obstacle < 0) answer.nearest = nowhere();
    if (hasSolids_) lookAtSolids(X_environmentPart, options.isOutside, answer);
    nameTriangle(answer.nearest);
    return answer;
}

/// Whether it is what reports are to tell of: less clearance, as far as it is told.
bool SceneClearance::isNearer(const Asked& found, const PoseClearance& sofar) {
    if (sofar.nearest.obstacle < 0) return true;
    const bool isFar = std::isinf(found.upper) && std::isinf(sofar.upper);
    return isFar ? found.lower < sofar.lower : found.upper < sofar.upper;
}

SceneClearance::Asked SceneClearance::ask(std::size_t i, const Pose& X_environmentPart,
                                          const ClearanceOptions& options) const {
    Asked answer;
    DistanceOptions asked;
    asked.cap = options.cap + scene_.obstacles[i].margin;
    if (options.isRough) {
        asked.relativeError = kRoughError;
        ask(i, X_environmentPart, asked, answer);
        const bool isBeyondCap = std::isinf(answer.upper) && answer.lower > 0;
        if (answer.upper <= 0 || isBeyondCap || answer.lower >= kRoughEnough * answer.upper) return answer;
        asked.relativeError = 0;
    }
    ask(i, X_environmentPart, asked, answer);
    return answer;
}

// lower > margin and upper <= margin decide at once; only an interval that holds the margin asks a second
// time.
void SceneClearance::ask(std::size_t i, const Pose& X_environmentPart, const DistanceOptions& options,
                         Asked& answer) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    const double margin = obstacle.margin;
    DistanceResult& d = answer.nearest;
    ThreadScratch& mine = scratch();
    d = clearway::distance(scene_.part, obstacle.model, X_environmentPart, options, mine.workspaces[i]);
    mine.tally->addDistance(mine.workspaces[i].counters());
    answer.nearest.obstacle = static_cast<int>(i);
    ++answer.queries;
    bool valid = d.upper > margin;
    const bool isSure = margin == 0 || d.lower > margin || !valid;
    if (!isSure && (options.relativeError == 0 || std::isinf(d.upper))) {
        valid = isFree(i, X_environmentPart);
        ++answer.queries;
    }
    const double above = d.lower - margin;
    answer.lower = valid ? std::max(above, std::numeric_limits<double>::denorm_min()) : std::min(above, 0.0);
    answer.upper = d.upper - margin;
}

SceneDistance SceneClearance::distance(const Pose& X_environmentPart) const {
    SceneDistance least = nowhere();
    ThreadScratch& mine = scratch();
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        DistanceOptions options;
        options.cap = least.upper;
        const DistanceResult found = clearway::distance(scene_.part, scene_.obstacles[i].model,
                                                        X_environmentPart, options, mine.workspaces[i]);
        const double lower = std::min(least.lower, found.lower);
        if (found.upper < least.upper || least.obstacle < 0) {
            static_cast<DistanceResult&>(least) = found;
            least.obstacle = static_cast<int>(i);
        }
        least.lower = lower;
        return true;
    });
    nameTriangle(least);
    return least;
}

void SceneClearance::nameTriangle(SceneDistance& nearest) const {
    if (nearest.environmentTriangle < 0) return;
    const Obstacle& obstacle = scene_.obstacles[static_cast<std::size_t>(nearest.obstacle)];
    if (obstacle.fileTriangles.empty()) return;
    const auto component = static_cast<std::size_t>(nearest.environmentComponent);
    nearest.environmentTriangle += static_cast<std::int64_t>(obstacle.fileTriangles[component]) -
                                   obstacle.model.components()[component].firstTriangle;
}

void SceneClearance::forgetWarmStart() const {
    ThreadScratch& mine = scratch();
    for (Workspace& workspace : mine.workspaces) workspace.forgetWarmStart();
    mine.nearest = 0;
}

bool SceneClearance::isOutOfReach(const Pose& X_environmentPart) const {
    return std::any_of(scene_.obstacles.begin(), scene_.obstacles.end(), [&](const Obstacle& obstacle) {
        const std::optional<Reach>& reach = obstacle.model.reach();
        return reach && !reach->positions.contains(X_environmentPart.translation);
    });
}

}  // namespace clearway::planning
