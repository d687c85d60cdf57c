// The directions in which contacts leave a part a way.
#pragma once

#include <ompl/util/RandomNumbers.h>

#include <vector>

#include "planning/improve/contact_planes.h"

namespace clearway::planning {

/// Unit twists.
struct TwistDirections {
    std::vector<Twist> open;  ///< leave the gaps open for a while
    std::vector<Twist>
        late;  ///< leave them open for no more than a gap: to be tried when there is nothing else
};

/// Turns a first set of directions aside, each until it leaves the gaps of the rows open, to first order. The set: the directions that the
/// rows oppose least and most, the axes of the environment and those given, and random ones, all of them both ways. axes: three directions of
/// the part, as columns, environment's frame. play: a gap, environment units.
TwistDirections directionsAlong(const std::vector<ContactRow>& rows, const Matrix3& axes,
                                const PartMoves& moves, double play, ompl::RNG& random);

}  // namespace clearway::planning
