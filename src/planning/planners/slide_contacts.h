// The contacts that a sliding part remembers, and the steps that they leave.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <optional>
#include <vector>

#include "clearway/scene_clearance.h"
#include "planning/improve/contact_planes.h"

namespace clearway::planning {

class SlideContacts {
  public:
    /// standoff: the gap that slides keep, environment units. The first three arguments must outlive this object.
    SlideContacts(const ompl::base::SpaceInformation& si, const SceneClearance& clearance,
                  const PartMoves& moves, double standoff)
        : si_(si), clearance_(clearance), moves_(moves), standoff_(standoff) {}

    /// Whether no contact is remembered.
    bool areNone() const { return contacts_.empty(); }

    /// Writes the state of the next step: as near to the target as the contacts let the part come, and at most `reach` away.
    /// Forgets contacts that are far by now. Returns whether that state is the target; none when the contacts leave no
    /// way on.
    std::optional<bool> step(const ompl::base::State* at, const ompl::base::State* target, double reach,
                             ompl::base::State* next);

    /// Remembers the plane of the closest pair at a pose. Where a motion was blocked, that pair is what blocks it.
    void lookAround(const ompl::base::State* state);

  private:
    std::vector<ContactRow> rowsAt(const Pose& X_environmentPart);
    double forgottenGap() const;

    const ompl::base::SpaceInformation& si_;
    const SceneClearance& clearance_;
    const PartMoves& moves_;
    double standoff_;
    std::vector<ContactPlane> contacts_;
};

}  // namespace clearway::planning
