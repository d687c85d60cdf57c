// Solids from a stack of loops: rounded boxes, trays and shrouds, screws, rings.
#pragma once

#include "program/scenes/piece.h"
#include "program/scenes/section.h"

namespace clearway::scenes {

/// Loops of as many points each, counter-clockwise seen from above, each at its height; the first and the
/// last are filled (they must be star-shaped about their first point, as convex ones are). The solid lies on
/// the left of the way up: heights may fall again where a wall turns inwards.
struct StackedLoop {
    Polyline loop;
    double height = 0;
};
Piece stacked(const std::vector<StackedLoop>& loops);

/// A profile (distance inwards from the rectangle's edge, height), pulled around a rectangle with rounded
/// corners and filled at its ends. A profile that goes up, in and down again makes a tray; distances stay
/// below the corner radius.
Piece pressed(const Polyline& profile, const Vector2& low, const Vector2& high, double cornerRadius,
              int segmentsPerQuarter);

/// A box, rounded by `corner` about z and by `edge` where it meets its top and bottom. Radii that do not fit
/// are lessened.
Piece roundedBox(const Vector3& low, const Vector3& high, double corner, double edge, int segmentsPerQuarter);

/// A tray open above, with rounded corners and bottom edges. The wall is thinner than the corner's radius,
/// which is lessened where it does not fit.
Piece tray(const Vector3& low, const Vector3& high, double corner, double wall, int segmentsPerQuarter);

/// A closed loop (distance from the axis, height), counter-clockwise, all of it off the axis, turned about z.
Piece ring(const Polyline& loop, int segments);

/// A hexagon head with a round flange on z = 0 and a shank below.
struct BoltShape {
    double shank = 3;  ///< radius
    double length = 12;
    double head = 5;  ///< half the width across flats
    double height = 5;
};
Piece bolt(const BoltShape& shape, int segments);

}  // namespace clearway::scenes
