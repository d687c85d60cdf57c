// The measures of the scene tunnel-console, shared by part and environment. Straight coordinates (s along, u
// across, v up from the underside of the part's flanges; see Screw), millimetres.
#pragma once

#include <array>
#include <cmath>

#include "demos/scenes/assembly.h"
#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"
#include "demos/scenes/section.h"

namespace clearway::scenes {

/// A screw about a horizontal axis: the line that the tunnel bends along, and the motion that threads the
/// console through it. A sweep along a screw slides along itself, so the gap between two such sweeps is
/// constant.
///
/// Straight coordinates are (s, u, v): millimetres along, across and up. Bending takes the line u = v = 0 to
/// a helix about the line parallel to y through (0, 0, radius), lowest at s = 0, where its direction is x
/// (and drifts to y).
struct Screw {
    double radius = 880;  ///< mm, of the helix u = v = 0
    double drift = 100;   ///< mm along the axis per radian

    double angleAt(double s) const { return s / radius; }

    /// The world point of a straight point; v < radius.
    Vector3 bend(const Vector3& straight) const {
        const double angle = angleAt(straight.x()), r = radius - straight.z();
        return {r * std::sin(angle), straight.y() + drift * angle, radius - r * std::cos(angle)};
    }

    /// Like bend() for s >= 0; for s < 0 the helix continues in its tangent plane.
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

    /// The ratio by which a distance across the sweeps' sections may exceed the distance in space, for
    /// sections at least `leastRadius` from the axis: the sections are not perpendicular to the helix.
    double obliquity(double leastRadius) const { return std::hypot(1.0, drift / leastRadius); }
};

struct TunnelConsoleDesign {
    Screw screw;
    double clearance = 10;
    double gap = 12;          ///< between sections; leaves `clearance` in space
    double room = 0;          ///< extra distance of floor, walls and roof beyond the gap
    double longestStep = 60;  ///< between a sweep's stations; bounds the chords' share of the gap

    // The console: a hat section, open below, with flanges.
    double length = 860;
    double height = 150;
    double flangeHalfWidth = 118;
    double footHalfWidth = 92;
    double topHalfWidth = 84;
    double shellThickness = 3;
    double topRadius = 20;  ///< of the fillet, at the middle of the sheet
    double footRadius = 6;
    double innerDepth = 66;  ///< how far cups and webs hang down from the top
    double thinPlate = 2.5;

    // The tunnel. It begins at s = 0.
    double startAt = 60;  ///< s of the part's rear end in the assembled pose
    double tunnelLength = 940;
    double wallHalfWidth = 145;
    double roofHeight = 185;
    double skinThickness = 1.6;  ///< the thinnest sheet of the scene
    double floorThickness = 2;
    double ribThickness = 2.5;

    double exitAngle = 1.16;  ///< radians of the screw motion

    double floorTop() const { return -gap - room; }
    double halfWidthAt(double v) const {
        return footHalfWidth + (topHalfWidth - footHalfWidth) * (v / height);
    }
    double thinnestSheet() const { return skinThickness; }
};

/// The measures for the options. Throws std::invalid_argument for a clearance out of range.
TunnelConsoleDesign designTunnelConsole(const SceneOptions& options);

/// Gaps between a rib and the console on the right, on the left and above; each at least the design's gap.
struct RibGaps {
    std::array<double, 3> sides;
};

/// The inner edge of a rib, from the floor on the right to the floor on the left.
Polyline ribOpening(const TunnelConsoleDesign& design, const RibGaps& gaps, double floor,
                    int segmentsPerQuarter);

/// Places a rigid piece at a straight point, its x, y, z along s, u, v there.
Placement rigidAt(const Screw& screw, const Vector3& straight);

}  // namespace clearway::scenes
