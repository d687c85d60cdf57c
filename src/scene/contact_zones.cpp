#include "scene/contact_zones.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "clearway/errors.h"
#include "core/number.h"

namespace clearway {
namespace {

/// Model::displacement may be too large by its excess (a share of the zone's distance) and its rounding (a
/// share of all lengths). Both constants leave room, because the part moves to a pose where ignored obstacles
/// have to stay ignored.
constexpr double kSlackExcess = 3e-6;
constexpr double kSlackRounding = 1e-13;

void requireContact(const char* name, const std::optional<ContactZone>& contact) {
    if (!contact) return;
    requirePose(contact->X_environmentPart);
    if (contact->distance > 0 && std::isfinite(contact->distance)) return;
    throw ArgumentError(std::string(name) + ".distance is " + shortNumber(contact->distance) +
                        ", expected a finite length above 0");
}

Bounds slackOf(const Model& part, const std::optional<ContactZone>& contact, const Pose& X) {
    if (!contact || !X.rotation.allFinite() || !X.translation.allFinite()) return {-1, -1};
    const double moved = part.displacement(contact->X_environmentPart, X, contact->distance);
    const double slack = contact->distance - moved;
    if (!(slack >= 0)) return {-1, -1};
    const double doubt =
        kSlackExcess * contact->distance + kSlackRounding * (part.radiusAboutOrigin() + contact->distance);
    return {std::max(0.0, slack - doubt), slack + doubt};
}

}  // namespace

ContactZones::ContactZones(const Scene& scene) {
    requireContact("startContact", scene.startContact);
    requireContact("goalContact", scene.goalContact);
}

void ContactZones::add(const Scene& scene, const Obstacle& obstacle) {
    const Zone wanted{obstacle.isIgnoredAtStart, obstacle.isIgnoredAtGoal};
    if ((wanted.atStart && !scene.startContact) || (wanted.atGoal && !scene.goalContact)) {
        throw ArgumentError(std::string("an obstacle is ignored in ") +
                            (wanted.atStart && !scene.startContact ? "startContact" : "goalContact") +
                            ", which is not set, expected a contact zone");
    }
    zoneOf_.push_back(-1);
    if (!wanted.atStart && !wanted.atGoal) return;
    const auto isWanted = [&](const Zone& zone) {
        return zone.atStart == wanted.atStart && zone.atGoal == wanted.atGoal;
    };
    const auto found = std::find_if(zones_.begin(), zones_.end(), isWanted);
    zoneOf_.back() = static_cast<int>(found - zones_.begin());
    if (found == zones_.end()) zones_.push_back(wanted);
}

void ContactZones::findSlacks(const Scene& scene, const Pose& X_environmentPart,
                              PoseClearance& answer) const {
    if (zones_.empty()) return;
    const Bounds atStart = slackOf(scene.part, scene.startContact, X_environmentPart),
                 atGoal = slackOf(scene.part, scene.goalContact, X_environmentPart);
    answer.isInStartContact = atStart.lower >= 0;
    answer.isInGoalContact = atGoal.lower >= 0;
    for (std::size_t i = 0; i < zones_.size(); ++i) {
        const Bounds start = zones_[i].atStart ? atStart : Bounds{-1, -1},
                     goal = zones_[i].atGoal ? atGoal : Bounds{-1, -1};
        answer.zones[i].clearance.reset();
        answer.zones[i].slack = {std::max(start.lower, goal.lower), std::max(start.upper, goal.upper)};
    }
}

bool ContactZones::countsAround(const Scene& scene, std::size_t obstacle, const Pose& X_environmentPart,
                                double moved) const {
    if (zoneOf_[obstacle] < 0) return true;
    const Zone& zone = zones_[static_cast<std::size_t>(zoneOf_[obstacle])];
    const auto isOutside = [&](bool isWanted, const std::optional<ContactZone>& contact) {
        if (!isWanted || !contact) return true;
        const double limit = (contact->distance + moved) * (1 + 2 * kSlackExcess) +
                             2 * kSlackRounding * (scene.part.radiusAboutOrigin() + contact->distance);
        return scene.part.displacement(contact->X_environmentPart, X_environmentPart, limit) > limit;
    };
    return isOutside(zone.atStart, scene.startContact) && isOutside(zone.atGoal, scene.goalContact);
}

}  // namespace clearway
