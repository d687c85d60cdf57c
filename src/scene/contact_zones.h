// Which obstacles count at a pose: a scene's contact zones let the assembled part touch some of them.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/scene.h"
#include "clearway/scene_clearance.h"

namespace clearway {

class ContactZones {
  public:
    /// Throws ArgumentError when a contact zone of the scene has no pose or no finite length above 0.
    explicit ContactZones(const Scene& scene);

    /// Puts the scene's next obstacle into its zone. Throws ArgumentError when the scene lacks the
    /// contact zone that the obstacle is ignored in.
    void add(const Scene& scene, const Obstacle& obstacle);

    std::size_t count() const { return zones_.size(); }

    /// Where the clearance of an obstacle's zone is kept; null when the obstacle always counts.
    ZoneClearance* zoneOf(std::size_t obstacle, Clearances& at) const {
        return zoneOf_[obstacle] < 0 ? nullptr : &at.zones[static_cast<std::size_t>(zoneOf_[obstacle])];
    }
    bool isIgnored(std::size_t obstacle, const Clearances& at) const {
        return zoneOf_[obstacle] >= 0 && at.zones[static_cast<std::size_t>(zoneOf_[obstacle])].isIgnored();
    }

    /// Fills in how far each zone's obstacles stay ignored around a pose, and forgets the zones' clearances.
    void findSlacks(const Scene& scene, const Pose& X_environmentPart, PoseClearance& answer) const;

    /// Whether an obstacle counts at a pose and wherever the part is moved from there by at most `moved`.
    bool countsAround(const Scene& scene, std::size_t obstacle, const Pose& X_environmentPart,
                      double moved) const;

  private:
    struct Zone {
        bool atStart, atGoal;
    };
    std::vector<Zone> zones_;
    std::vector<int> zoneOf_;  ///< of each obstacle; -1: it always counts
};

}  // namespace clearway
