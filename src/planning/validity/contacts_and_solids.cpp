// Which obstacles count at a pose, and what solids enclose there.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/solids.h"
#include "planning/validity/mesh_names.h"
#include "planning/validity/scene_clearance.h"

namespace clearway::planning {
namespace {

/// What Model::displacement may be too large by, at a pose that the part moves to while ignored obstacles are
/// to stay so: its excess and its rounding, with room.
constexpr double kSpareExcess = 3e-6;
constexpr double kSpareRounding = 1e-13;

}  // namespace

void SceneClearance::addZone(std::size_t i) {
    const Zone wanted{scene_.obstacles[i].isIgnoredAtStart, scene_.obstacles[i].isIgnoredAtGoal};
    if ((wanted.atStart && !scene_.startContact) || (wanted.atGoal && !scene_.goalContact)) {
        throw std::invalid_argument(
            std::string("an obstacle is ignored in ") +
            (wanted.atStart && !scene_.startContact ? "startContact" : "goalContact") +
            ", which is not set, expected a contact zone");
    }
    zoneOf_.push_back(-1);
    if (!wanted.atStart && !wanted.atGoal) return;
    std::size_t zone = 0;
    while (zone < zones_.size() &&
           (zones_[zone].atStart != wanted.atStart || zones_[zone].atGoal != wanted.atGoal)) {
        ++zone;
    }
    if (zone == zones_.size()) zones_.push_back(wanted);
    zoneOf_.back() = static_cast<int>(zone);
}

SceneClearance::Spare SceneClearance::spareOf(const std::optional<ContactZone>& contact,
                                              const Pose& X) const {
    if (!contact || !X.rotation.allFinite() || !X.translation.allFinite()) return {};
    const double moved = scene_.part.displacement(contact->X_environmentPart, X, contact->distance);
    const double spare = contact->distance - moved;
    if (!(spare >= 0)) return {};
    const double doubt = kSpareExcess * contact->distance +
                         kSpareRounding * (scene_.part.radiusAboutOrigin() + contact->distance);
    return {std::max(0.0, spare - doubt), spare + doubt};
}

void SceneClearance::findSpares(const Pose& X_environmentPart, PoseClearance& answer) const {
    if (zones_.empty()) return;
    const Spare atStart = spareOf(scene_.startContact, X_environmentPart),
                atGoal = spareOf(scene_.goalContact, X_environmentPart);
    answer.isInStartContact = atStart.least >= 0;
    answer.isInGoalContact = atGoal.least >= 0;
    for (std::size_t i = 0; i < zones_.size(); ++i) {
        const Spare start = zones_[i].atStart ? atStart : Spare(), goal = zones_[i].atGoal ? atGoal : Spare();
        ZoneClearance& zone = answer.zones[i];
        zone.clearance = kUnknownClearance;
        zone.spare = std::max(start.least, goal.least);
        zone.mostSpare = std::max(start.most, goal.most);
    }
}

bool SceneClearance::isIgnored(std::size_t i, const PoseClearance& at) const {
    return zoneOf_[i] >= 0 && at.zones[static_cast<std::size_t>(zoneOf_[i])].isIgnored();
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

std::string SceneClearance::enclosure(const Pose& X_environmentPart) const {
    PoseClearance at;
    findSpares(X_environmentPart, at);
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (isIgnored(i, at)) continue;
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
    if (found.nearest.collides()) return "in collision: " + whyBlocked(scene_, found.nearest);
    const bool isApart = found.nearest.lower > marginOf(scene_, found.nearest);
    if (!isApart) return "too close: " + whyBlocked(scene_, found.nearest);
    return "in collision: " + enclosure(X_environmentPart);
}

// Only where it can turn a verdict: elsewhere surfaces are too close already, and may touch.
void SceneClearance::lookAtSolids(const Pose& X_environmentPart, bool isOutside,
                                  PoseClearance& answer) const {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        double& clearance = zoneOf_[i] < 0 ? answer.lowerAlways
                                           : answer.zones[static_cast<std::size_t>(zoneOf_[i])].clearance;
        if (!(clearance > 0) || (zoneOf_[i] < 0 && isOutside)) continue;
        if (!enclosureBy(i, X_environmentPart)) continue;
        clearance = 0;
        if (isIgnored(i, answer)) continue;
        answer.lower = std::min(answer.lower, 0.0);
        answer.upper = std::min(answer.upper, 0.0);
    }
}

}  // namespace clearway::planning
