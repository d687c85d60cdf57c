// The measures of the scene cembox, shared by the module and the bay: millimetres; part coordinates about the
// middle of the module's body, x across, y to the rear, z up.
#pragma once

#include "demos/scenes/assembly.h"
#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"

namespace clearway::scenes {

struct CemboxDesign {
    double clearance = 4;
    double gap = 4.5;  ///< of rails and buffers; leaves `clearance`

    // The module: its body hangs between two guide edges.
    double bodyHalf = 128;  ///< half its width
    double halfHeight = 100;
    double front = -46;  ///< front of the fins
    double lid = -32;
    double base = 30;  ///< back of the housing
    double back = 40;  ///< back of the ribs behind the housing
    double edgeHalf = 150;
    double edgeThickness = 2.5;
    double top = 134;  ///< top of connectors and lugs
    double topHalf = 122, topDepth = 26;

    Vector3 place{230, 725, 440};  ///< the module's middle in its rails, in the bay
    double railTop = 98;           ///< part coordinates, assembled
    double lift = 206;             ///< along the rails and out of them
    double tilt = 0.6;             ///< radians, about x
    double slide = 150;            ///< along the tilted module's own z

    double thinnestSheet = 1.2;

    /// Boxes that together hold the part.
    std::vector<Box> envelope() const;

    /// The path, for the part's coordinates before it is centred: out of the rails, then the rotations in
    /// short chords.
    std::vector<PartState> path() const;
};

/// Makes the measures. Throws std::invalid_argument for a clearance out of range.
CemboxDesign designCembox(const SceneOptions& options);

/// The module, with `studs` solder points inside it.
Assembly buildModule(const CemboxDesign& design, const Detail& detail, Random random, int studs);

}  // namespace clearway::scenes
