// The measures of the scene cembox, shared by its part and its environment: millimetres; part coordinates
// about the middle of the module's body, x across, y to the rear, z up.
#pragma once

#include "program/scenes/detail.h"
#include "program/scenes/kept_free.h"
#include "program/scenes/random.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

struct CemboxDesign {
    double clearance = 4;
    double gap = 4.5;  ///< of rails and buffers, so that `clearance` is left

    // The module: its body hangs between two guide edges.
    double bodyHalf = 128;  ///< of its width
    double halfHeight = 100;
    double front = -46;  ///< of the fins
    double lid = -32;
    double base = 30;  ///< back of the housing
    double back = 40;  ///< of the ribs behind it
    double edgeHalf = 150;
    double edgeThickness = 2.5;
    double top = 134;  ///< of connectors and lugs
    double topHalf = 122, topDepth = 26;

    Vector3 place{230, 725, 440};  ///< of the module's middle in its rails, in the bay
    double railTop = 98;           ///< part coordinates, assembled
    double lift = 206;             ///< along the rails and out of them
    double tilt = 0.6;             ///< radians, about x
    double slide = 150;            ///< along the tilted module's own up

    double thinnestSheet = 1.2;

    /// Hold all of the part.
    std::vector<Box> envelope() const;

    /// Of the part's coordinates before it is centred: out of the rails, then the turned rest in short
    /// chords.
    std::vector<PartState> path() const;

    /// What everything but rails and buffers stays out of.
    KeptFree keptFree() const;
};

/// Throws std::invalid_argument for a clearance that cannot be.
CemboxDesign designCembox(const SceneOptions& options);

/// The module, with `studs` solder points inside it.
Assembly buildModule(const CemboxDesign& design, const Detail& detail, Random random, int studs);

/// Everything around it, with `studs` weld studs on the bulkhead. withFittings: what version 2 adds.
Assembly buildEngineBay(const CemboxDesign& design, const KeptFree& keptFree, const Detail& detail,
                        Random random, int studs, bool withFittings);

}  // namespace clearway::scenes
