// Cross-sections in the plane with filleted corners: bands along a line, rings, full outlines, plates with
// holes.
#pragma once

#include <functional>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::scenes {

using Vector2 = Eigen::Vector2d;
using Polyline = std::vector<Vector2>;

/// The cross section that a sweep pulls through space.
struct Section {
    Polyline points;
    std::vector<std::vector<std::uint32_t>> loops;  ///< boundaries, the material on their left
    std::vector<TriangleIndices> cap;               ///< fills the loops; counter-clockwise
};

/// The line with each inner corner replaced by an arc of its radius (0 keeps the corner), cut into
/// `segmentsPerQuarter` chords per 90 degrees, at least one. radii: one for each inner corner. The arc's ends
/// lie on the line; a radius that does not fit is reduced until it does.
Polyline filleted(const Polyline& line, const std::vector<double>& radii, int segmentsPerQuarter);

/// The line moved to its left by `distance`; segments stay parallel, corners are mitred.
Polyline offsetLine(const Polyline& line, double distance);

/// The material between two lines of equally many points; `left` lies on the left of `right` as seen along
/// them.
Section bandSection(const Polyline& left, const Polyline& right);

/// A sheet of the given thickness; the line runs through its middle.
Section sheetSection(const Polyline& line, double thickness);

/// The material between two closed counter-clockwise loops of equally many points.
Section ringSection(const Polyline& outer, const Polyline& inner);

/// The inside of a convex counter-clockwise loop.
Section fullSection(const Polyline& loop);

/// A circle, counter-clockwise, beginning in the direction `from` (radians from the first axis).
Polyline circle(const Vector2& centre, double radius, int segments, double from = 0);

/// A rectangle, counter-clockwise, each corner an arc of segmentsPerQuarter chords.
Polyline roundedRectangle(const Vector2& low, const Vector2& high, double radius, int segmentsPerQuarter);

Section rectangleSection(const Vector2& low, const Vector2& high);

/// A square of half side `half` as `segments` points, evenly spread in direction, the first one on the first
/// diagonal. segments is a multiple of 4, so that the corners are among the points.
Polyline squareAround(const Vector2& centre, double half, int segments);

/// The radius of the hole in the middle of a cell, 0 for none; less than half the cell's shorter side.
using HoleRadius = std::function<double(std::size_t column, std::size_t row)>;

/// A plate with holes, triangulated as CAD exports do it: long thin triangles lead from a cell's corners to
/// its hole. The cells lie between the increasing lines xs and ys. holeSegments: a multiple of 4.
Section holedSection(const std::vector<double>& xs, const std::vector<double>& ys, const HoleRadius& radiusOf,
                     int holeSegments);

}  // namespace clearway::scenes
