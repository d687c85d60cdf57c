// The measures of the scene tunnel-console, shared by its part and its environment. Straight coordinates (s
// along, u across, v up from the underside of the part's flanges; see Screw), millimetres.
#pragma once

#include <array>

#include "program/scenes/detail.h"
#include "program/scenes/piece.h"
#include "program/scenes/random.h"
#include "program/scenes/screw.h"
#include "program/scenes/section.h"
#include "program/scenes/tunnel_console.h"

namespace clearway::scenes {

struct TunnelConsoleDesign {
    Screw screw;
    double clearance = 10;
    double gap = 12;          ///< between sections, so that `clearance` is left in space
    double room = 0;          ///< what floor, walls and roof leave beyond the gap; 0: all is at the gap
    double longestStep = 60;  ///< of a sweep's stations, so that its chords keep to their share of the gap

    // The console: a hat section, open below, with flanges.
    double length = 860;
    double height = 150;
    double flangeHalfWidth = 118;
    double footHalfWidth = 92;
    double topHalfWidth = 84;
    double shellThickness = 3;
    double topRadius = 20;  ///< of the fillets, at the middle of the sheet
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

    double exitAngle = 1.16;  ///< of the screw motion, radians

    double floorTop() const { return -gap - room; }
    double halfWidthAt(double v) const {
        return footHalfWidth + (topHalfWidth - footHalfWidth) * (v / height);
    }
    double thinnestSheet() const { return skinThickness; }
};

/// The measures for the options; throws std::invalid_argument for a clearance that cannot be. From version 2
/// on the sheets keep farther off than the gap, from version 3 on also when the gap is narrow.
TunnelConsoleDesign designTunnelConsole(const SceneOptions& options, int version);

/// What a rib leaves beside the console on the right, on the left and over it; each at least the gap.
struct RibGaps {
    std::array<double, 3> sides;
};

/// The inner edge of a rib, from the floor on the right to the floor on the left.
Polyline ribOpening(const TunnelConsoleDesign& design, const RibGaps& gaps, double floor,
                    int segmentsPerQuarter);

/// The console, bent, its middle at s = 0. `studs` small domes are added inside it.
Assembly buildConsole(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs);

/// Everything around it, in the world.
Assembly buildTunnel(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs);

/// A placement that carries a rigid piece to a straight point: its x, y, z along s, u, v there.
Placement rigidAt(const Screw& screw, const Vector3& straight);

}  // namespace clearway::scenes
