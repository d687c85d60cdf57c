// Closed solids: sections swept along lines, outlines turned about an axis, stacks of loops, boxes, screws.
#pragma once

#include <functional>

#include "demos/scenes/assembly.h"
#include "demos/scenes/spine.h"

namespace clearway::scenes {

/// Pulls a section along x through the stations, which increase; its (first, second) coordinates become (y,
/// z). A flat side of the section becomes a row of long quads, two triangles each: the slivers of CAD
/// tessellations.
Piece sweep(const Section& section, const std::vector<double>& stations);

/// Pulls a section in (x, z) along y, and one in (x, y) along z.
Piece sweepAlongY(const Section& section, const std::vector<double>& stations);
Piece sweepAlongZ(const Section& section, const std::vector<double>& stations);

/// Turns an outline (distance from the axis, height) about z. The outline begins and ends on the axis and has
/// the material on its left.
Piece turned(const Polyline& outline, int segments);

/// A screw boss on a round pad that lies on z = 0, with a fillet where it rises from the pad and a rounding
/// at its head.
struct BossShape {
    double radius = 8;
    double height = 20;  ///< above z = 0
    double foot =
        4;  ///< radius of the fillet; the pad's radius is larger than the boss's by 2.1 times `foot`
    double rounding = 3;  ///< radius of the rounding, less than half the boss's radius
    double pad = 2;       ///< thickness of the pad
};
Polyline bossOutline(const BossShape& shape, int segmentsPerQuarter);

/// A cup, open at height 0, that hangs down to -depth.
struct CupShape {
    double radius = 38;
    double depth = 60;
    double wall = 2;
    double rounding = 10;  ///< inner radius of the bottom edge
};
Polyline cupOutline(const CupShape& shape, int segmentsPerQuarter);

/// A dome of the given base radius and height on z = 0: a rivet head or weld stud.
Polyline domeOutline(double radius, double height, int segmentsPerQuarter);

/// Pulls a section along a spine through the stations, which increase; its first coordinate goes along the
/// frame's y, its second along z. scales: one for each station, or empty for 1 everywhere. Bends must be
/// wider than the section.
Piece sweptAlong(const Spine& spine, const Section& section, const std::vector<double>& stations,
                 const std::vector<double>& scales = {});

/// Pulls a section along a line on frames that do not twist. The section's first direction is perpendicular
/// to the line and at the beginning nearest to `first`. Sections at the line's corners are mitred. The line
/// must not turn back on itself more sharply than the section is wide.
Piece pulled(const Section& section, const Line& line, const Vector3& first = Vector3::UnitZ());

/// A round bar along the line.
Piece rod(const Line& line, double radius, int segments);

/// A hollow pipe along the line, open at both ends.
Piece pipe(const Line& line, double radius, double wall, int segments);

/// A round bar whose radius depends on the length from its beginning (mm): conduits, bellows, plugs.
Piece variedRod(const Line& line, const std::function<double(double)>& radiusAt, int segments);

/// A solid of loops of equally many points, counter-clockwise seen from above, each at its height. The first
/// and the last loop are filled (they must be star-shaped about their first point, as convex ones are). The
/// solid lies on the left of the way up: heights may fall again where a wall turns inwards.
struct StackedLoop {
    Polyline loop;
    double height = 0;
};
Piece stacked(const std::vector<StackedLoop>& loops);

/// Pulls a profile (distance inwards from the rectangle's edge, height) around a rectangle with rounded
/// corners and fills its ends. A profile that goes up, in and down again makes a tray. Distances stay below
/// the corner radius.
Piece pressed(const Polyline& profile, const Vector2& low, const Vector2& high, double cornerRadius,
              int segmentsPerQuarter);

/// A box, rounded by `corner` about z and by `edge` where it meets its top and bottom. Radii that do not fit
/// are reduced.
Piece roundedBox(const Vector3& low, const Vector3& high, double corner, double edge, int segmentsPerQuarter);

/// A tray, open above, with rounded corners and bottom edges. The wall is thinner than the corner's radius,
/// which is reduced if it does not fit.
Piece tray(const Vector3& low, const Vector3& high, double corner, double wall, int segmentsPerQuarter);

/// Turns a closed counter-clockwise loop (distance from the axis, height) about z; all of the loop is off the
/// axis.
Piece ring(const Polyline& loop, int segments);

/// A screw: a hexagon head with a round flange on z = 0 and a shank below.
struct BoltShape {
    double shank = 3;  ///< radius
    double length = 12;
    double head = 5;  ///< half the width across flats
    double height = 5;
};
Piece bolt(const BoltShape& shape, int segments);

/// A box whose faces are cut into grids of cells, two triangles each: many equal triangles in few planes. The
/// cells are as near to cubes as their number allows. Some cells are cut into four about their middle, so
/// that there are exactly `triangles` (one less if that is odd). triangles: 12 or more.
Piece gridBox(const Box& box, std::size_t triangles);

}  // namespace clearway::scenes
