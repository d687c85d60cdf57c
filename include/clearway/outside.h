// A goal of many poses: the part's box has left the box of its surroundings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

/// One of the six sides of a box along the axes.
struct BoxSide {
    int axis = 0;         ///< 0, 1, 2 for x, y, z
    bool isUpper = true;  ///< the side of the larger coordinates
};

/// The name of a side: "+x", "-x", ... "-z".
std::string nameOf(const BoxSide& side);

/// The side of that name; empty for every other text.
std::optional<BoxSide> sideNamed(const std::string& name);

/// The part is outside where its box and that of its surroundings are apart or, with a side, where its box is
/// beyond that side of the other one. Both boxes are along the environment's axes.
struct Outside {
    std::optional<BoxSide> side;  ///< the side to leave by; without it any side will do
};

/// The sides beyond which the part may be: the one of the goal, or all six.
std::vector<BoxSide> sidesOf(const Outside& outside);

/// The box, along the axes of frame a, of a box in frame b. An empty box stays empty.
Box movedBox(const Pose& X_ab, const Box& box_b);

/// How far the part's box must move, straight along an axis, until it is beyond the side. Negative: the gap beyond
/// that side. Infinitely negative where a box is empty. Boxes in one frame; environment units.
double overlapAt(const BoxSide& side, const Box& part, const Box& surroundings);

/// The least overlap over the goal's sides. The part is outside exactly when it is below 0.
double overlapOf(const Outside& outside, const Box& part, const Box& surroundings);

/// The unit direction along which the box has its least support: turned this way, the part needs the least clearance
/// on that side. dimensions: 3, or 2 for a direction in the plane of x and y.
Vector3 flattestDirection(const Box& box, int dimensions);

/// The support of a box: the largest dot product of a unit direction with a point of the box, relative to the origin
/// of its coordinates; negative when the whole box lies behind the origin.
double reachAlong(const Vector3& direction, const Box& box);

}  // namespace clearway

#pragma GCC visibility pop
