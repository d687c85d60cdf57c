#include "problem/outside.h"

#include <algorithm>
#include <limits>

#include "clearway/errors.h"
#include "problem/config.h"

namespace clearway {

std::string nameOf(const BoxSide& side) {
    return std::string(side.isUpper ? "+" : "-") + kAxisNames[side.axis];
}

std::optional<BoxSide> sideNamed(const std::string& name) {
    for (const BoxSide& side : sidesOf({})) {
        if (nameOf(side) == name) return side;
    }
    return std::nullopt;
}

std::vector<BoxSide> sidesOf(const Outside& outside) {
    if (outside.side) return {*outside.side};
    return {{0, true}, {0, false}, {1, true}, {1, false}, {2, true}, {2, false}};
}

Box movedBox(const Pose& X_ab, const Box& box_b) {
    if (box_b.isEmpty()) return box_b;
    const Vector3 centre = X_ab * Vector3(box_b.center());
    const Vector3 half = X_ab.rotation.cwiseAbs() * Vector3(0.5 * box_b.sizes());
    return Box(centre - half, centre + half);
}

double overlapAt(const BoxSide& side, const Box& part, const Box& surroundings) {
    if (part.isEmpty() || surroundings.isEmpty()) return -std::numeric_limits<double>::infinity();
    const int axis = side.axis;
    return side.isUpper ? surroundings.max()[axis] - part.min()[axis]
                        : part.max()[axis] - surroundings.min()[axis];
}

double overlapOf(const Outside& outside, const Box& part, const Box& surroundings) {
    double least = std::numeric_limits<double>::infinity();
    for (const BoxSide& side : sidesOf(outside)) least = std::min(least, overlapAt(side, part, surroundings));
    return least;
}

Vector3 flattestDirection(const Box& box, int dimensions) {
    Vector3 nearest = Vector3::Zero().cwiseMax(box.min()).cwiseMin(box.max());  // of the box, to the origin
    if (dimensions == 2) nearest.z() = 0;
    if (nearest.stableNorm() > 0) return -nearest.stableNormalized();
    Vector3 flattest = Vector3::UnitX();
    for (int axis = 0; axis < dimensions; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const Vector3 direction = sign * Vector3::Unit(axis);
            if (supportAlong(direction, box) < supportAlong(flattest, box)) flattest = direction;
        }
    }
    return flattest;
}

double supportAlong(const Vector3& direction, const Box& box) {
    return direction.cwiseProduct(box.min()).cwiseMax(direction.cwiseProduct(box.max())).sum();
}

void requireNoGoalContact(const Problem& problem) {
    if (!problem.outside || !problem.rules.goalContact) return;
    throw ArgumentError((problem.file.empty() ? "" : problem.file + ": ") +
                        "contact.goal is given and the goal is outside, expected one of them");
}

}  // namespace clearway
