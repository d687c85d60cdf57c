#include "clearway/scene_clearance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clearway/errors.h"
#include "core/number.h"
#include "model/solids.h"
#include "scene/contact_zones.h"
#include "scene/scene_scratch.h"

namespace clearway {
namespace {

constexpr double kFarAway = std::numeric_limits<double>::infinity();

/// Relative error of rough distances. On planners' motions rough distances are twice as fast as exact ones,
/// for a few more queries.
constexpr double kRoughError = 0.05;
/// Least lower / upper with which a rough distance suffices; below it a tight one is computed.
constexpr double kRoughEnough = 0.9;

/// The distance when no obstacle was queried: infinite.
SceneDistance nowhere() {
    SceneDistance result;
    result.lower = result.upper = result.distance = kFarAway;
    return result;
}

}  // namespace

/// The clearance of one obstacle, whether or not the obstacle counts.
struct SceneClearance::Asked {
    Bounds clearance;
    SceneDistance nearest;
    std::uint64_t queries = 0;

    /// True when reports are to name this obstacle: it has less clearance, as far as that is known.
    bool isNearerThan(const PoseClearance& sofar) const {
        if (!sofar.nearest.obstacle) return true;
        const bool isFar = std::isinf(clearance.upper) && std::isinf(sofar.upper);
        return isFar ? clearance.lower < sofar.lower : clearance.upper < sofar.upper;
    }
};

SceneClearance::SceneClearance(Scene scene)
    : scene_(std::move(scene)),
      zones_(std::make_unique<ContactZones>(scene_)),
      scratch_(std::make_unique<ThreadScratch>(scene_.obstacles.size())) {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        requireNotNegative("margin", obstacle.margin);
        if (obstacle.solids && !obstacle.shrunk && !scene_.partSolids) {
            throw ArgumentError(
                "an obstacle is solid and partSolids is null, expected makeSolids of the part's mesh");
        }
        hasSolids_ = hasSolids_ || obstacle.solids;
        zones_->add(scene_, obstacle);
        // A query here refuses models that cannot be queried together, rather than later inside a planner.
        Pose somewhere;
        if (const auto& range = obstacle.model.range()) somewhere.translation = range->positions.center();
        isFree(i, somewhere, scratch_->mine());
    }
    zoneCount_ = zones_->count();
    const auto mayOverlap = [](const Obstacle& obstacle) { return obstacle.overlap() > 0; };
    areSidesKept_ = hasSolids_ && zoneCount_ == 0 &&
                    std::none_of(scene_.obstacles.begin(), scene_.obstacles.end(), mayOverlap);
    if (areSidesKept_) scratch_->rememberTrees();
}

SceneClearance::~SceneClearance() = default;

double SceneClearance::mostClearance() const {
    double most = kFarAway;
    for (const Obstacle& obstacle : scene_.obstacles) {
        if (const auto& range = obstacle.model.range()) most = std::min(most, range->cap - obstacle.margin);
    }
    return most;
}

bool SceneClearance::isFree(const Pose& X_environmentPart) const {
    Scratch& mine = scratch_->mine();
    if (mine.freePoses.contain(X_environmentPart)) return true;
    PoseClearance slacks;
    zones_->findSlacks(scene_, X_environmentPart, slacks);
    const bool isClear = mine.clearPose && isSamePose(*mine.clearPose, X_environmentPart);
    if (!isClear && !isClearOfSurfaces(X_environmentPart, slacks, mine)) return false;
    if (!isOutsideSolids(X_environmentPart, slacks)) return false;
    mine.freePoses.add(X_environmentPart);
    return true;
}

bool SceneClearance::isClearOfSurfaces(const Pose& X_environmentPart) const {
    Scratch& mine = scratch_->mine();
    if (mine.freePoses.contain(X_environmentPart)) return true;
    PoseClearance slacks;
    zones_->findSlacks(scene_, X_environmentPart, slacks);
    if (!isClearOfSurfaces(X_environmentPart, slacks, mine)) return false;
    mine.clearPose.emplace(X_environmentPart);
    return true;
}

bool SceneClearance::isClearOfSurfaces(const Pose& X_environmentPart, const PoseClearance& slacks,
                                       Scratch& mine) const {
    return visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        if (zones_->isIgnored(i, slacks) || isFree(i, X_environmentPart, mine)) return true;
        mine.nearest = i;
        return false;
    });
}

bool SceneClearance::isOutsideSolids(const Pose& X_environmentPart, const PoseClearance& slacks) const {
    if (!hasSolids_) return true;
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (!zones_->isIgnored(i, slacks) && enclosureBy(i, X_environmentPart)) return false;
    }
    return true;
}

/// For the two ends of a motion that sweep() certified: whether `from` is remembered to be free on this thread. Then `to` is free, too,
/// because no surface was crossed on the way, and is remembered.
bool SceneClearance::isFreeBehind(const Pose& from, const Pose& to) const {
    if (!areSidesKept_) return false;
    Scratch& mine = scratch_->mine();
    if (!mine.freePoses.contain(from)) return false;
    if (!mine.freePoses.contain(to)) mine.freePoses.add(to);
    return true;
}

bool SceneClearance::isFree(std::size_t i, const Pose& X_environmentPart, Scratch& scratch) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    Workspace& workspace = scratch.workspaces[i];
    const bool isBlocked = obstacle.margin == 0 ? collides(scene_.partFor(obstacle), obstacle.model,
                                                           X_environmentPart, workspace)
                                                : isWithin(scene_.partFor(obstacle), obstacle.model,
                                                           X_environmentPart, obstacle.margin, workspace);
    ++tallyOfThisThread().withins;
    tallyOfThisThread().work += workspace.counters();
    return !isBlocked;
}

PoseClearance SceneClearance::at(const Pose& X_environmentPart, const ClearanceOptions& options) const {
    PoseClearance answer;
    Scratch& mine = scratch_->mine();
    if (scene_.obstacles.size() == 1 && zoneCount_ == 0 && !hasSolids_) {  // most scenes: nothing to compare
        const Asked found = ask(0, X_environmentPart, options, mine);
        answer.lower = found.clearance.lower;
        answer.upper = found.clearance.upper;
        answer.always = found.clearance;
        answer.nearest = found.nearest;
        answer.queries = found.queries;
        nameTriangle(answer.nearest);
        return answer;
    }
    zones_->findSlacks(scene_, X_environmentPart, answer);
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        ClearanceOptions asked = options;
        const double cap =
            std::min(options.cap.value_or(kFarAway), answer.upper);  // the nearest one so far is enough
        if (cap + scene_.obstacles[i].margin < 0) return true;
        asked.cap = cap;
        ZoneClearance* zone = zones_->zoneOf(i, answer);
        if (zone && zone->isIgnored() && zone->slack.lower >= options.leastSlack) return true;
        const Asked found = ask(i, X_environmentPart, asked, mine);
        answer.queries += found.queries;
        if (zone && !zone->clearance) zone->clearance.emplace();
        Bounds& least = zone ? *zone->clearance : answer.always;
        least.lower = std::min(least.lower, found.clearance.lower);
        least.upper = std::min(least.upper, found.clearance.upper);
        if (zone && zone->isIgnored()) return true;
        if (found.isNearerThan(answer)) {
            answer.nearest = found.nearest;
            mine.nearest = i;
        }
        answer.lower = std::min(answer.lower, found.clearance.lower);
        answer.upper = std::min(answer.upper, found.clearance.upper);
        return true;
    });
    if (!answer.nearest.obstacle) answer.nearest = nowhere();
    if (hasSolids_) {
        const bool isOutside = options.isOutside || mine.freePoses.contain(X_environmentPart);
        lookAtSolids(X_environmentPart, isOutside, answer);
    }
    nameTriangle(answer.nearest);
    return answer;
}

SceneClearance::Asked SceneClearance::ask(std::size_t i, const Pose& X_environmentPart,
                                          const ClearanceOptions& options, Scratch& scratch) const {
    Asked answer;
    DistanceOptions asked;
    if (options.cap) asked.cap = *options.cap + scene_.obstacles[i].margin;
    if (options.isRough) {
        asked.relativeError = kRoughError;
        ask(i, X_environmentPart, asked, scratch, answer);
        const auto& [lower, upper] = answer.clearance;
        const bool isBeyondCap = std::isinf(upper) && lower > 0;
        if (upper <= 0 || isBeyondCap || lower >= kRoughEnough * upper) return answer;
        asked.relativeError = 0;
    }
    ask(i, X_environmentPart, asked, scratch, answer);
    return answer;
}

// lower > margin or upper <= margin decides at once. Only an interval that holds the margin needs a second
// query.
void SceneClearance::ask(std::size_t i, const Pose& X_environmentPart, const DistanceOptions& options,
                         Scratch& scratch, Asked& answer) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    const double margin = obstacle.margin;
    DistanceResult& d = answer.nearest;
    Workspace& workspace = scratch.workspaces[i];
    d = clearway::distance(scene_.partFor(obstacle), obstacle.model, X_environmentPart, options, workspace);
    ++tallyOfThisThread().distances;
    tallyOfThisThread().work += workspace.counters();
    answer.nearest.obstacle = i;
    ++answer.queries;
    bool valid = d.upper > margin;
    const bool isSure = margin == 0 || d.lower > margin || !valid;
    if (!isSure && (options.relativeError == 0 || std::isinf(d.upper))) {
        valid = isFree(i, X_environmentPart, scratch);
        ++answer.queries;
    }
    const double above = d.lower - margin;
    answer.clearance.lower =
        valid ? std::max(above, std::numeric_limits<double>::denorm_min()) : std::min(above, 0.0);
    answer.clearance.upper = d.upper - margin;
}

SceneDistance SceneClearance::distance(const Pose& X_environmentPart) const {
    SceneDistance least = nowhere();
    Scratch& mine = scratch_->mine();
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        DistanceOptions options;
        options.cap = least.upper;
        const Obstacle& obstacle = scene_.obstacles[i];
        const DistanceResult found = clearway::distance(scene_.partFor(obstacle), obstacle.model,
                                                        X_environmentPart, options, mine.workspaces[i]);
        const double lower = std::min(least.lower, found.lower);
        if (found.upper < least.upper || !least.obstacle) {
            static_cast<DistanceResult&>(least) = found;
            least.obstacle = i;
        }
        least.lower = lower;
        return true;
    });
    nameTriangle(least);
    return least;
}

std::vector<SceneDistance> SceneClearance::nearPairs(const Pose& X_environmentPart, double band,
                                                     NearPairs kept) const {
    if (!(band >= 0)) throw ArgumentError("band is " + shortNumber(band) + ", expected 0 or more");
    requirePose(X_environmentPart);
    const ThreadScratch::ForMotion mine(*scratch_);
    std::vector<SceneDistance> all;
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        for (DistanceResult& pair :
             clearway::nearPairs(scene_.partFor(obstacle), obstacle.model, X_environmentPart,
                                 band + obstacle.margin, mine->workspaces[i], kept)) {
            SceneDistance& found = all.emplace_back();
            static_cast<DistanceResult&>(found) = std::move(pair);
            found.obstacle = i;
            nameTriangle(found);
        }
    }
    const auto clearanceOf = [&](const SceneDistance& pair) {
        return pair.distance - scene_.obstacles[*pair.obstacle].margin;
    };
    std::stable_sort(all.begin(), all.end(), [&](const SceneDistance& a, const SceneDistance& b) {
        return clearanceOf(a) < clearanceOf(b);
    });
    return all;
}

void SceneClearance::nameTriangle(SceneDistance& nearest) const {
    if (!nearest.witness) return;
    Witness& witness = *nearest.witness;
    const Obstacle& obstacle = scene_.obstacles[*nearest.obstacle];
    if (obstacle.shrunk) {
        const std::uint32_t triangle =
            obstacle.shrunk->partTriangles[static_cast<std::size_t>(witness.partTriangle)];
        witness.partTriangle = triangle;
        witness.partComponent = static_cast<std::int64_t>(componentOf(scene_.part.components(), triangle));
    }
    if (obstacle.fileTriangles.empty()) return;
    if (obstacle.shrunkBy > 0) {
        witness.environmentTriangle =
            obstacle.fileTriangles[static_cast<std::size_t>(witness.environmentTriangle)];
        return;
    }
    const auto component = static_cast<std::size_t>(witness.environmentComponent);
    witness.environmentTriangle += static_cast<std::int64_t>(obstacle.fileTriangles[component]) -
                                   obstacle.model.components()[component].firstTriangle;
}

SceneClearance::ColdStart::ColdStart(const SceneClearance& clearance)
    : isCold_(clearance.scratch_->perThread.local().isCold), wasCold_(isCold_) {
    Scratch& cold = clearance.scratch_->perThread.local().cold;
    if (!cold.isInMotion) {  // else a callback of a cold query asks
        cold.workspaces.resize(clearance.scene_.obstacles.size());
        for (Workspace& workspace : cold.workspaces) workspace.forgetWarmStart();
        cold.nearest = 0;
        cold.freePoses = FreePoses();
        cold.clearPose.reset();
    }
    isCold_ = true;
}

SceneClearance::ColdStart::~ColdStart() {
    isCold_ = wasCold_;
}

bool SceneClearance::isOutOfRange(const Pose& X_environmentPart) const {
    return std::any_of(scene_.obstacles.begin(), scene_.obstacles.end(), [&](const Obstacle& obstacle) {
        const std::optional<QueryRange>& range = obstacle.model.range();
        return range && !range->positions.contains(X_environmentPart.translation);
    });
}

std::optional<SceneClearance::Enclosure> SceneClearance::enclosureBy(std::size_t i,
                                                                     const Pose& X_environmentPart) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    if (!obstacle.solids) return std::nullopt;
    const Solids& part = obstacle.shrunk ? *obstacle.shrunk->solids : *scene_.partSolids;
    if (const auto found = obstacle.solids->holding({}, part, X_environmentPart)) {
        return Enclosure{found->outer, found->inner, true};
    }
    if (const auto found = part.holding(X_environmentPart, *obstacle.solids, {})) {
        return Enclosure{found->inner, found->outer, false};
    }
    return std::nullopt;
}

/// Lowers clearances to at most 0 where a solid holds the other body. Skips obstacles whose clearance is at most 0
/// already: their surfaces may touch, and enclosureBy() needs surfaces apart.
void SceneClearance::lookAtSolids(const Pose& X_environmentPart, bool isOutside,
                                  PoseClearance& answer) const {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        ZoneClearance* zone = zones_->zoneOf(i, answer);
        if (zone ? !zone->clearance : isOutside) continue;
        double& lower = zone ? zone->clearance->lower : answer.always.lower;
        if (!(lower > 0)) continue;
        if (!enclosureBy(i, X_environmentPart)) continue;
        lower = 0;
        if (zones_->isIgnored(i, answer)) continue;
        answer.lower = std::min(answer.lower, 0.0);
        answer.upper = std::min(answer.upper, 0.0);
    }
}

QueryTally& tallyOfThisThread() {
    thread_local QueryTally tally;
    return tally;
}

QueryTally takeQueryTally() {
    return std::exchange(tallyOfThisThread(), {});
}

}  // namespace clearway
