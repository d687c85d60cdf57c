// Plane cross-sections with filleted corners, as they come before a sweep: bands along a line, rings and full
// outlines.
#pragma once

#include <vector>

#include "clearway/mesh.h"

namespace clearway::scenes {

using Vector2 = Eigen::Vector2d;
using Polyline = std::vector<Vector2>;

/// What a sweep pulls through space: boundary loops (material on their left) and the triangles that fill
/// them.
struct Section {
    Polyline points;
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<TriangleIndices> cap;  ///< counter-clockwise
};

/// The line with each inner corner replaced by an arc of its radius (0 keeps the corner), which is cut into
/// `segmentsPerQuarter` chords for 90 degrees, at least one. radii: one for each inner corner.
/// The arc's ends lie on the line; where a radius does not fit, it is lessened until it does.
Polyline filleted(const Polyline& line, const std::vector<double>& radii, int segmentsPerQuarter);

/// The line moved to its left by `distance`, its segments parallel to the old ones (mitred corners).
Polyline offsetLine(const Polyline& line, double distance);

/// The material between two lines of as many points, `left` on the left of `right` as seen along them.
Section bandSection(const Polyline& left, const Polyline& right);

/// A sheet of the given thickness with the line in its middle.
Section sheetSection(const Polyline& line, double thickness);

/// The material between two closed counter-clockwise loops of as many points.
Section ringSection(const Polyline& outer, const Polyline& inner);

/// A convex counter-clockwise loop, filled.
Section fullSection(const Polyline& loop);

/// Counter-clockwise, beginning in the given direction (radians from the first axis).
Polyline circle(const Vector2& centre, double radius, int segments, double from = 0);

/// Counter-clockwise, each corner an arc of segmentsPerQuarter chords.
Polyline roundedRectangle(const Vector2& low, const Vector2& high, double radius, int segmentsPerQuarter);

/// A rectangle between two corners.
Section rectangleSection(const Vector2& low, const Vector2& high);

/// A square of half side `half` as `segments` points, evenly spread in direction and beginning on the first
/// diagonal; segments is a multiple of 4, so that the corners are among them.
Polyline squareAround(const Vector2& centre, double half, int segments);

}  // namespace clearway::scenes
