#include "clearway/planning/scene_clearance.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/number.h"
#include "model/solids.h"
#include "planning/validity/contact_zones.h"

namespace clearway::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Relative error of rough distances. On planners' motions rough distances are twice as fast as exact ones,
/// for a few more queries.
constexpr double kRoughError = 0.05;
/// The share of upper that lower must reach; otherwise a tight distance is asked for.
constexpr double kRoughEnough = 0.9;

thread_local QueryTally tallyOfThisThread;

/// Visits the obstacles until `visit` returns false. The obstacle that was nearest last time comes first: it
/// blocks most often, and it caps what the others are asked for.
template <class Visit>
bool visitAll(std::size_t count, std::size_t first, const Visit& visit) {
    if (count == 0) return true;
    if (!visit(first)) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (i != first && !visit(i)) return false;
    }
    return true;
}

/// The answer when no obstacle was asked.
SceneDistance nowhere() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    SceneDistance result;
    result.lower = result.upper = result.distance = kInfinity;
    result.pointOnPart = result.pointOnEnvironment = Vector3::Constant(kNone);
    return result;
}

std::string meshName(const Model& model, std::int64_t component) {
    const auto& components = model.components();
    if (component >= 0 && static_cast<std::size_t>(component) < components.size()) {
        const std::string& name = components[static_cast<std::size_t>(component)].name;
        if (!name.empty()) return name;
    }
    const std::string& file = model.origin().file;
    return file.empty() ? "unnamed" : file.substr(file.find_last_of('/') + 1);
}

double marginOf(const Scene& scene, const SceneDistance& nearest) {
    return nearest.obstacle < 0 ? 0 : scene.obstacles[static_cast<std::size_t>(nearest.obstacle)].margin;
}

/// Describes a pair that touches or is closer than the margin.
std::string describePair(const Scene& scene, const SceneDistance& nearest) {
    const double margin = marginOf(scene, nearest);
    const MeshNames names = meshNames(scene, nearest);
    std::ostringstream message;
    message << "triangle " << nearest.partTriangle << " of the part's mesh '" << names.part
            << "' and triangle " << nearest.environmentTriangle << " of the environment's mesh '"
            << names.environment << "' are ";
    if (nearest.collides()) {
        message << "touching, expected a distance above " << margin;
    } else {
        message << nearest.distance << " apart, expected more than the margin " << margin;
    }
    return message.str();
}

}  // namespace

/// The last poses found free. Planners ask for a state and then for several motions to it.
class SceneClearance::FreePoses {
  public:
    bool contain(const Pose& pose) const {
        return std::any_of(poses_.begin(), poses_.end(), [&](const Pose& known) {
            return known.translation == pose.translation && known.rotation == pose.rotation;
        });
    }
    void add(const Pose& pose) {
        poses_[next_] = pose;
        next_ = (next_ + 1) % poses_.size();
    }

  private:
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::array<Pose, 8> poses_ = noPoses();
    std::size_t next_ = 0;

    /// NaN equals no pose.
    static std::array<Pose, 8> noPoses() {
        std::array<Pose, 8> none;
        none.fill({Matrix3::Identity(), Vector3::Constant(kNone)});
        return none;
    }
};

/// The data that one thread keeps from query to query.
struct SceneClearance::Scratch {
    std::vector<Workspace> workspaces;  ///< one for each obstacle
    std::size_t nearest = 0;            ///< the obstacle that was nearest, or in the way, last time
    FreePoses freePoses{};
};

struct SceneClearance::ThreadScratch {
    explicit ThreadScratch(std::size_t obstacles)
        : perThread([obstacles] { return Scratch{std::vector<Workspace>(obstacles)}; }) {}
    tbb::enumerable_thread_specific<Scratch> perThread;
};

/// The clearance of one obstacle, whether or not the obstacle counts.
struct SceneClearance::Asked {
    Bounds clearance;
    SceneDistance nearest;
    std::uint64_t queries = 0;

    /// True when reports are to name this obstacle: it has less clearance, as far as that is known.
    bool isNearerThan(const PoseClearance& sofar) const {
        if (sofar.nearest.obstacle < 0) return true;
        const bool isFar = std::isinf(clearance.upper) && std::isinf(sofar.upper);
        return isFar ? clearance.lower < sofar.lower : clearance.upper < sofar.upper;
    }
};

struct SceneClearance::Enclosure {
    const std::string* obstacleMesh;
    const std::string* partMesh;
    bool isPartInside;
};

SceneClearance::SceneClearance(Scene scene)
    : scene_(std::move(scene)),
      zones_(std::make_unique<ContactZones>(scene_)),
      scratch_(std::make_unique<ThreadScratch>(scene_.obstacles.size())) {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        if (!(obstacle.margin >= 0) || !std::isfinite(obstacle.margin)) {
            throw std::invalid_argument("margin is " + shortNumber(obstacle.margin) +
                                        ", expected a finite number >= 0");
        }
        if (obstacle.solids && !scene_.partSolids) {
            throw std::invalid_argument(
                "an obstacle is solid and partSolids is null, expected makeSolids of the part's mesh");
        }
        hasSolids_ = hasSolids_ || obstacle.solids;
        zones_->add(scene_, obstacle);
        // A query here refuses models that cannot be queried together, rather than later inside a planner.
        Pose somewhere;
        if (const auto& reach = obstacle.model.reach()) somewhere.translation = reach->positions.center();
        isFree(i, somewhere, scratch_->perThread.local());
    }
    zoneCount_ = zones_->count();
}

SceneClearance::~SceneClearance() = default;

double SceneClearance::mostClearance() const {
    double most = kInfinity;
    for (const Obstacle& obstacle : scene_.obstacles) {
        if (const auto& reach = obstacle.model.reach()) most = std::min(most, reach->cap - obstacle.margin);
    }
    return most;
}

bool SceneClearance::isFree(const Pose& X_environmentPart) const {
    Scratch& mine = scratch_->perThread.local();
    if (mine.freePoses.contain(X_environmentPart)) return true;
    if (!isFree(X_environmentPart, mine)) return false;
    mine.freePoses.add(X_environmentPart);
    return true;
}

bool SceneClearance::isFree(const Pose& X_environmentPart, Scratch& mine) const {
    PoseClearance at;
    zones_->findSpares(scene_, X_environmentPart, at);
    const bool isApart = visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        if (zones_->isIgnored(i, at) || isFree(i, X_environmentPart, mine)) return true;
        mine.nearest = i;
        return false;
    });
    if (!isApart || !hasSolids_) return isApart;
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (!zones_->isIgnored(i, at) && enclosureBy(i, X_environmentPart)) return false;
    }
    return true;
}

bool SceneClearance::isFree(std::size_t i, const Pose& X_environmentPart, Scratch& scratch) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    Workspace& workspace = scratch.workspaces[i];
    const bool isBlocked =
        obstacle.margin == 0
            ? collides(scene_.part, obstacle.model, X_environmentPart, workspace)
            : isWithin(scene_.part, obstacle.model, X_environmentPart, obstacle.margin, workspace);
    ++tallyOfThisThread.withins;
    tallyOfThisThread.work += workspace.counters();
    return !isBlocked;
}

PoseClearance SceneClearance::at(const Pose& X_environmentPart, const ClearanceOptions& options) const {
    PoseClearance answer;
    Scratch& mine = scratch_->perThread.local();
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
    zones_->findSpares(scene_, X_environmentPart, answer);
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        ClearanceOptions asked = options;
        asked.cap =
            std::min(options.cap, answer.upper);  // more than the nearest one so far is of no interest
        if (asked.cap + scene_.obstacles[i].margin < 0) return true;
        ZoneClearance* zone = zones_->zoneOf(i, answer);
        if (zone && zone->isIgnored() && zone->spare.lower >= options.leastSpare) return true;
        const Asked found = ask(i, X_environmentPart, asked, mine);
        answer.queries += found.queries;
        Bounds& least = zone ? zone->clearance : answer.always;
        const bool isFirst = least.lower == kUnknownClearance;
        least.lower = isFirst ? found.clearance.lower : std::min(least.lower, found.clearance.lower);
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
    if (answer.nearest.obstacle < 0) answer.nearest = nowhere();
    if (hasSolids_) lookAtSolids(X_environmentPart, options.isOutside, answer);
    nameTriangle(answer.nearest);
    return answer;
}

SceneClearance::Asked SceneClearance::ask(std::size_t i, const Pose& X_environmentPart,
                                          const ClearanceOptions& options, Scratch& scratch) const {
    Asked answer;
    DistanceOptions asked;
    asked.cap = options.cap + scene_.obstacles[i].margin;
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
    d = clearway::distance(scene_.part, obstacle.model, X_environmentPart, options, workspace);
    ++tallyOfThisThread.distances;
    tallyOfThisThread.work += workspace.counters();
    answer.nearest.obstacle = static_cast<int>(i);
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

/// No point of the part moves further than this from the middle of a piece to either end. PartMotion::length tells more
/// where the part is far from its own origin and turns.
double SceneClearance::movedInHalf(const MotionPiece& piece, double halfTime) const {
    const Box& box = scene_.part.box();
    const Vector3 centre = piece.middle.rotation * box.center();
    const Vector3 velocity = piece.velocity + piece.angularVelocity.cross(centre);
    const double aboutCentre = 0.5 * box.diagonal().norm() * piece.angularVelocity.norm();
    return halfTime * (velocity.norm() + aboutCentre) + piece.deviation + piece.deviationAcrossTurn;
}

/// The pieces with what the contact zones ignore of an obstacle.
MotionPieces SceneClearance::piecesFor(std::size_t i, const PartMotion& motion, double poseError) const {
    PoseClearance at;
    if (!zones_->zoneOf(i, at)) return motion.pieces;
    return [this, i, &motion, poseError](double from, double to) {
        MotionPiece piece = motion.pieces(from, to);
        PoseClearance here;
        zones_->findSpares(scene_, piece.middle, here);
        const double spare = zones_->zoneOf(i, here)->spare.lower;
        const double half = 0.5 * (to - from);
        const double moved = std::min(half * motion.length, movedInHalf(piece, half)) + poseError;
        if (spare >= moved) {
            piece.counts = MotionPiece::Counts::kNowhere;
        } else if (spare >= 0) {
            piece.counts = MotionPiece::Counts::kNotAtMiddle;
        }
        return piece;
    };
}

ContactsAt SceneClearance::contactsAt(const Pose& X_environmentPart) const {
    PoseClearance at;
    zones_->findSpares(scene_, X_environmentPart, at);
    return {at.isInStartContact, at.isInGoalContact};
}

SolidsAlong SceneClearance::stayOutsideSolids(const PartMotion& motion, double until, double poseError,
                                              double leastInterval) const {
    SolidsAlong answer;
    answer.until = until;
    PoseClearance none;
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (!scene_.obstacles[i].solids || !zones_->zoneOf(i, none)) continue;
        answer = stayOutsideSolid(i, motion, answer, poseError, leastInterval);
    }
    return answer;
}

/// Behind the border of a zone, which is too close to tell, a pose inside the solid is looked for.
SolidsAlong SceneClearance::stayOutsideSolid(std::size_t i, const PartMotion& motion,
                                             const SolidsAlong& others, double poseError,
                                             double leastInterval) const {
    constexpr int kLooksBehindBorder = 256;
    SolidsAlong answer = others;
    std::vector<TimeRange> left{{0, others.until}};
    for (int looks = 0; !left.empty() && looks < kLooksBehindBorder;) {
        const TimeRange range = left.back();
        left.pop_back();
        const SweepVerdict side = sideAlong(i, motion, range, poseError, leastInterval);
        if (answer.until < others.until) ++looks;
        if (side == SweepVerdict::kCertified) continue;
        if (side == SweepVerdict::kContact) {
            const double until = std::min(answer.until, range.from);
            return {SweepVerdict::kContact, until, std::min(answer.contactTime, range.from)};
        }
        const double middle = range.from + 0.5 * (range.to - range.from);
        if (motion.length * (range.to - range.from) > leastInterval) {
            left.push_back({middle, range.to});
            left.push_back({range.from, middle});
            continue;
        }
        answer.until = std::min(answer.until, range.from);
        if (answer.verdict == SweepVerdict::kCertified) answer.verdict = SweepVerdict::kUndecided;
    }
    return answer;
}

/// kUndecided: the range must be divided.
SweepVerdict SceneClearance::sideAlong(std::size_t i, const PartMotion& motion, const TimeRange& range,
                                       double poseError, double leastInterval) const {
    const MotionPiece piece = motion.pieces(range.from, range.to);
    const Pose& X = piece.middle;
    const double half = 0.5 * (range.to - range.from), travel = 2 * half * motion.length;
    const double moved = std::min(0.5 * travel, movedInHalf(piece, half)) + poseError;
    PoseClearance at;
    zones_->findSpares(scene_, X, at);
    if (zones_->zoneOf(i, at)->spare.lower >= moved) return SweepVerdict::kCertified;  // ignored throughout
    // No surfaces touch while the obstacle counts, so all of a range in which it counts is on one side.
    if (zones_->countsAround(scene_, i, X, moved)) {
        return enclosureBy(i, X) ? SweepVerdict::kContact : SweepVerdict::kCertified;
    }
    if (travel > leastInterval) return SweepVerdict::kUndecided;
    const bool isClear = !isWithin(scene_.part, scene_.obstacles[i].model, X, moved,
                                   scratch_->perThread.local().workspaces[i]);
    return isClear && !enclosureBy(i, X) ? SweepVerdict::kCertified : SweepVerdict::kUndecided;
}

SceneSweep SceneClearance::sweep(const PartMotion& motion, const SceneSweepOptions& options) const {
    SceneSweep answer;
    answer.certifiedUntil = options.until;
    Scratch& mine = scratch_->perThread.local();
    SweepOptions asked;
    asked.from = options.from;
    asked.leastInterval = options.leastInterval;
    asked.poseError = options.poseError;
    asked.isForward = options.isForward;
    asked.contactTime = options.contactInterval / motion.length;
    asked.isStopped = options.isStopped;
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        asked.margin = obstacle.margin + options.floor;
        asked.until = answer.certifiedUntil;
        asked.isContactAtEnd =
            answer.contactTime == asked.until || (options.isContactAtEnd && asked.until == options.until);
        const SweepResult found = clearway::sweep(
            scene_.part, obstacle.model, piecesFor(i, motion, options.poseError), asked, mine.workspaces[i]);
        ++answer.queries;
        ++tallyOfThisThread.sweeps;
        tallyOfThisThread.work += found.counters;
        if (found.verdict == SweepVerdict::kCertified) return true;
        mine.nearest = i;
        const bool isFirst = answer.verdict == SweepVerdict::kCertified;
        if (isFirst || found.verdict == SweepVerdict::kContact) answer.verdict = found.verdict;
        answer.contactTime = std::min(answer.contactTime, found.contactTime);
        answer.certifiedUntil = std::min(answer.certifiedUntil, found.certifiedUntil);
        return options.isForward && answer.certifiedUntil > options.from;
    });
    return answer;
}

LeastClearance SceneClearance::leastClearance(const PartMotion& motion,
                                              const LeastClearanceOptions& options) const {
    LeastClearance answer;
    answer.lower = kInfinity;
    answer.upper = std::min(options.cap, mostClearance());
    Scratch& mine = scratch_->perThread.local();
    LeastDistanceOptions asked;
    asked.poseError = options.poseError;
    asked.resolution = options.resolution;
    asked.isStopped = options.isStopped;
    visitAll(scene_.obstacles.size(), mine.nearest, [&](std::size_t i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        asked.margin = obstacle.margin;
        asked.cap = answer.upper;
        const LeastDistance found = leastDistance(
            scene_.part, obstacle.model, piecesFor(i, motion, options.poseError), asked, mine.workspaces[i]);
        ++answer.queries;
        ++tallyOfThisThread.sweeps;
        tallyOfThisThread.work += found.counters;
        answer.lower = std::min(answer.lower, found.lower);
        answer.isStopped = answer.isStopped || found.isStopped;
        if (found.upper < answer.upper) {
            answer.upper = found.upper;
            answer.time = found.time;
            mine.nearest = i;
        }
        return !answer.isStopped && answer.upper > 0;  // a motion in contact has no least clearance to find
    });
    return answer;
}

SceneDistance SceneClearance::distance(const Pose& X_environmentPart) const {
    SceneDistance least = nowhere();
    Scratch& mine = scratch_->perThread.local();
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
    Scratch& mine = scratch_->perThread.local();
    for (Workspace& workspace : mine.workspaces) workspace.forgetWarmStart();
    mine.nearest = 0;
    mine.freePoses = {};
}

bool SceneClearance::isOutOfReach(const Pose& X_environmentPart) const {
    return std::any_of(scene_.obstacles.begin(), scene_.obstacles.end(), [&](const Obstacle& obstacle) {
        const std::optional<Reach>& reach = obstacle.model.reach();
        return reach && !reach->positions.contains(X_environmentPart.translation);
    });
}

std::optional<SceneClearance::Enclosure> SceneClearance::enclosureBy(std::size_t i,
                                                                     const Pose& X_environmentPart) const {
    const Obstacle& obstacle = scene_.obstacles[i];
    if (!obstacle.solids) return std::nullopt;
    if (const auto found = obstacle.solids->holding({}, *scene_.partSolids, X_environmentPart)) {
        return Enclosure{found->outer, found->inner, true};
    }
    if (const auto found = scene_.partSolids->holding(X_environmentPart, *obstacle.solids, {})) {
        return Enclosure{found->inner, found->outer, false};
    }
    return std::nullopt;
}

/// Solids are looked at only where they can turn a verdict: elsewhere the surfaces are too close already, and
/// may touch.
void SceneClearance::lookAtSolids(const Pose& X_environmentPart, bool isOutside,
                                  PoseClearance& answer) const {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        ZoneClearance* zone = zones_->zoneOf(i, answer);
        double& lower = zone ? zone->clearance.lower : answer.always.lower;
        if (!(lower > 0) || (!zone && isOutside)) continue;
        if (!enclosureBy(i, X_environmentPart)) continue;
        lower = 0;
        if (zones_->isIgnored(i, answer)) continue;
        answer.lower = std::min(answer.lower, 0.0);
        answer.upper = std::min(answer.upper, 0.0);
    }
}

/// Names the solid and the mesh inside it, of the obstacles that count. Empty when nothing is enclosed.
std::string SceneClearance::describeEnclosure(const Pose& X_environmentPart) const {
    PoseClearance at;
    zones_->findSpares(scene_, X_environmentPart, at);
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (zones_->isIgnored(i, at)) continue;
        const auto found = enclosureBy(i, X_environmentPart);
        if (!found) continue;
        const std::string part = "the part's mesh '" + *found->partMesh + "'",
                          obstacle = "the solid '" + *found->obstacleMesh + "'";
        return found->isPartInside ? part + " is inside " + obstacle : obstacle + " is inside " + part;
    }
    return "";
}

std::string SceneClearance::whyInvalid(const Pose& X_environmentPart) const {
    const PoseClearance found = at(X_environmentPart);
    if (found.isValid()) return "";
    if (found.nearest.collides()) return "in collision: " + describePair(scene_, found.nearest);
    const bool isApart = found.nearest.lower > marginOf(scene_, found.nearest);
    if (!isApart) return "too close: " + describePair(scene_, found.nearest);
    return "in collision: " + describeEnclosure(X_environmentPart);
}

QueryTally takeQueryTally() {
    return std::exchange(tallyOfThisThread, {});
}

MeshNames meshNames(const Scene& scene, const SceneDistance& nearest) {
    if (nearest.partTriangle < 0 || nearest.obstacle < 0) return {};
    const Model& environment = scene.obstacles[static_cast<std::size_t>(nearest.obstacle)].model;
    return {meshName(scene.part, nearest.partComponent), meshName(environment, nearest.environmentComponent)};
}

}  // namespace clearway::planning
