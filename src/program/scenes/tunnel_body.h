// The scene tunnel-console, version 3: sheet metal with beads, flanges and holes, and all that is bolted,
// clipped and laid to it. Measures and straight coordinates are those of tunnel_console_design.h.
#pragma once

#include "program/scenes/curve.h"
#include "program/scenes/sheet_metal.h"
#include "program/scenes/tunnel_console_design.h"

namespace clearway::scenes {

/// What is around the console, and the console, its middle at s = 0. onlyCount: see SheetMetal.
SheetMetal buildTunnelBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                           bool onlyCount);
SheetMetal buildConsoleBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                            bool onlyCount);

/// What the tunnel is built with.
struct TunnelBody {
    const TunnelConsoleDesign& design;
    SheetMetal& metal;
    Random& random;

    Vector3 bend(double s, double u, double v) const { return design.screw.bendAfterStart({s, u, v}); }
    Piece swept(const Section& section, double from, double to) const;
    /// Its x, y, z along s, u, v at the point, its own z axis turned to `axis`.
    Piece rigid(const Piece& piece, const Vector3& at, const Vector3& axis) const;
    Piece boss(const BossShape& shape) const;
    void addBolt(const std::string& stem, const Vector3& at, const Vector3& axis, double shank);
    /// Points along s at a place across that may vary.
    Line along(double from, double to, const std::function<Vector2(double s)>& place) const;

    /// Of several alike, one in four and never many lie at the gap, the first among them.
    static bool isNear(int i, int several) { return i % std::max(4, several / 3) == 0; }
    /// What others leave beyond the gap.
    double farther() { return design.room * random.between(0.25, 1); }
    double outerWall() const { return design.wallHalfWidth + design.skinThickness; }
    int count(double atRichnessOne) const { return metal.detail().count(atRichnessOne); }

    void addFloors();    ///< pans, rails below, seat rails
    void addWalls();     ///< skins, roof, front wall
    void addRibs();      ///< with flanges
    void addSupports();  ///< guides on the walls, mounts on the floor
    void addDuct();
    void addUnderbody();  ///< propeller shaft, exhaust, heat shield
    void addLines();      ///< pipes, hoses, cables and what holds them
    void addFasteners();  ///< straps, brackets, bolts, weld nuts
    void addStuds(int studs);
};

}  // namespace clearway::scenes
