// Makes room along a path in two ways and takes the better one: of the path as it is, and of the path shortened first.
// The shortened one takes fewer states and thus less time, but may lead through a narrower gap.
#pragma once

#include "planning/paths/elastic_band.h"

namespace clearway::planning {

/// Makes room as makeRoom does, the shortened way first. Limits are those of each way. Returns the clearance kept. Ways that
/// keep about as much clearance are compared by windingLength().
double makeRoomBothWays(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                        const RoomOptions& options);

}  // namespace clearway::planning
