// A screw about a level axis: the line the tunnel bends along and the motion that threads the console through
// it. What is swept by a screw slides along itself, so the gap between two such sweeps stays as it is.
#pragma once

#include <cmath>

#include "clearway/problem.h"

namespace clearway::scenes {

/// Straight coordinates are (s, u, v): millimetres along, across and up. Bending takes the line u = v = 0 to
/// a helix about the line parallel to y through (0, 0, radius), lowest at s = 0, where its direction is x
/// (and drifts to y).
struct Screw {
    double radius = 880;  ///< mm, of the helix u = v = 0
    double drift = 100;   ///< mm along the axis for each radian

    double angleAt(double s) const { return s / radius; }

    /// The bent place of a straight point; v < radius.
    Vector3 bend(const Vector3& straight) const {
        const double angle = angleAt(straight.x()), r = radius - straight.z();
        return {r * std::sin(angle), straight.y() + drift * angle, radius - r * std::cos(angle)};
    }

    /// As bend() for s >= 0; before it the tangent plane goes on straight.
    Vector3 bendAfterStart(const Vector3& straight) const {
        if (straight.x() >= 0) return bend(straight);
        return {straight.x(), straight.y() + drift * angleAt(straight.x()), straight.z()};
    }

    /// The rigid motion by `angle`: carries bend(s, u, v) to bend(s + angle * radius, u, v).
    PartState motion(double angle) const {
        PartState state;
        state.rotation = {std::cos(angle / 2), 0, -std::sin(angle / 2), 0};
        const Vector3 onAxis(0, 0, radius);
        state.position = onAxis - state.rotation * onAxis + Vector3(0, drift * angle, 0);
        return state;
    }

    /// How much a distance across the sweeps' sections may exceed the distance in space, for sections at
    /// least `leastRadius` from the axis: they are not square to the helix.
    double obliquity(double leastRadius) const { return std::hypot(1.0, drift / leastRadius); }
};

}  // namespace clearway::scenes
