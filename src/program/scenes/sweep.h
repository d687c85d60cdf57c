// Solids from outlines: a section pulled along a line, an outline turned about an axis.
#pragma once

#include "program/scenes/piece.h"
#include "program/scenes/section.h"

namespace clearway::scenes {

/// The section's (first, second) coordinate becomes (y, z), pulled along x through the stations, which
/// increase. A flat side of the section becomes a row of long quads, each two triangles: the slivers of CAD
/// tessellations.
Piece sweep(const Section& section, const std::vector<double>& stations);

/// The same for a section in (x, z), pulled along y, and for one in (x, y), pulled along z.
Piece sweepAlongY(const Section& section, const std::vector<double>& stations);
Piece sweepAlongZ(const Section& section, const std::vector<double>& stations);

/// Evenly spaced from first to last, at most `step` apart.
std::vector<double> stationsBetween(double first, double last, double step);

/// The outline (distance from the axis, height), turned about z. It begins and ends on the axis and has the
/// material on its left.
Piece turned(const Polyline& outline, int segments);

/// A screw boss on a round pad that lies on z = 0: a fillet where it rises from the pad, a rounding at its
/// head.
struct BossShape {
    double radius = 8;
    double height = 20;   ///< above z = 0
    double foot = 4;      ///< radius of the fillet; the pad is 2.1 times as much wider than the boss
    double rounding = 3;  ///< radius of the rounding, less than half the boss's radius
    double pad = 2;       ///< thickness of the pad
};
Polyline bossOutline(const BossShape& shape, int segmentsPerQuarter);

/// A cup open at height 0 that hangs down to -depth: outer radius, wall thickness and a rounded bottom edge.
struct CupShape {
    double radius = 38;
    double depth = 60;
    double wall = 2;
    double rounding = 10;  ///< inner radius of the bottom edge
};
Polyline cupOutline(const CupShape& shape, int segmentsPerQuarter);

/// A dome of the given base radius and height on z = 0: a rivet head or weld stud.
Polyline domeOutline(double radius, double height, int segmentsPerQuarter);

}  // namespace clearway::scenes
