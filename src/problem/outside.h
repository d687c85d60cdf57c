// A goal outside: how far the boxes of part and surroundings overlap, and contradictions of the goal.
#pragma once

#include <vector>

#include "clearway/problem.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

/// The sides beyond which the part may be: the one of the goal, or all six.
std::vector<BoxSide> sidesOf(const Outside& outside);

/// The box, along the axes of frame a, of a box in frame b. An empty box stays empty.
Box movedBox(const Pose& X_ab, const Box& box_b);

/// How far the part's box must move, straight along an axis, until it is beyond the side. Negative: the gap beyond
/// that side. Infinitely negative where a box is empty. Boxes in one frame; environment units.
double overlapAt(const BoxSide& side, const Box& part, const Box& surroundings);

/// The least overlap over the goal's sides. The part is outside exactly when it is below 0.
double overlapOf(const Outside& outside, const Box& part, const Box& surroundings);

/// The unit direction along which the box has its least support: turned this way, the part takes the least space
/// on that side. dimensions: 3, or 2 for a direction in the plane of x and y.
Vector3 flattestDirection(const Box& box, int dimensions);

/// The support of a box: the largest dot product of a unit direction with a point of the box, relative to the origin
/// of its coordinates; negative when the whole box lies behind the origin.
double supportAlong(const Vector3& direction, const Box& box);

/// Throws ArgumentError, naming the problem's file, when the goal is outside but has contacts, which lie around a
/// pose.
void requireNoGoalContact(const Problem& problem);

}  // namespace clearway

#pragma GCC visibility pop
