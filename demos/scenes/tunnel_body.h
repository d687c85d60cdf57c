// The tunnel while it is built: sheet metal with beads, flanges and holes, and everything bolted,
// clipped and laid to it.
#pragma once

#include <functional>

#include "demos/scenes/random.h"
#include "demos/scenes/sheet_metal.h"
#include "demos/scenes/tunnel_console.h"

namespace clearway::scenes {

/// The tools that build the tunnel.
struct TunnelBody {
    static constexpr double kSlit = 0.3;   // mm between neighbours
    static constexpr double kCabin = 480;  // mm of floor in front of the tunnel's mouth

    const TunnelConsoleDesign& design;
    SheetMetal& metal;
    Random& random;

    Vector3 bend(double s, double u, double v) const { return design.screw.bendAfterStart({s, u, v}); }
    Piece swept(const Section& section, double from, double to) const;
    /// Places a rigid piece at a straight point: its x, y, z along s, u, v, its own z axis turned to `axis`.
    Piece rigid(const Piece& piece, const Vector3& at, const Vector3& axis) const;
    Piece boss(const BossShape& shape) const;
    void addBolt(const std::string& stem, const Vector3& at, const Vector3& axis, double shank);
    /// A line along s; `place` gives its (u, v).
    Line along(double from, double to, const std::function<Vector2(double s)>& place) const;

    /// True for the parts that lie at the gap: of `several` similar parts the first, and at most every
    /// fourth.
    static bool isNear(int i, int several) { return i % std::max(4, several / 3) == 0; }
    /// The extra distance of the other parts beyond the gap.
    double farther() { return design.room * random.between(0.25, 1); }
    double outerWall() const { return design.wallHalfWidth + design.skinThickness; }
    int count(double atRichnessOne) const { return metal.detail().count(atRichnessOne); }
};

/// Adds ribs, guides and mounts, the heater duct, propeller shaft and exhaust, pipes, hoses and cables,
/// straps, brackets, bolts, weld nuts and studs.
void addTunnelFittings(TunnelBody& body, int studs);

/// Everything around the console. onlyCount: see SheetMetal.
SheetMetal buildTunnelBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                           bool onlyCount);

}  // namespace clearway::scenes
