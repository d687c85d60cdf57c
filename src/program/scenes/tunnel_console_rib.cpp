// The opening of a rib: the console's hat grown by a gap of its own on the right, on the left and over it.
#include <algorithm>

#include "program/scenes/tunnel_console_design.h"

namespace clearway::scenes {

namespace {

/// From the floor to the hat's top on the right, with the radii of its three corners.
struct HalfOpening {
    Polyline line;
    std::vector<double> radii;
};

HalfOpening halfOpening(const TunnelConsoleDesign& design, double beside, double over, double floor) {
    const double flange = design.flangeHalfWidth + beside, ledge = design.shellThickness + beside;
    // Three quarters of the part's own rounding grown by the gap, which the chords of the fillet bear too;
    // the ledge's nose is rounded more than the part's foot fillet grown by the gap needs.
    const double nose = std::max(design.footRadius - beside, 0.0) + 3;
    return {{{flange, floor},
             {flange, ledge},
             {design.footHalfWidth + beside, ledge},
             {design.topHalfWidth + beside, design.height + over}},
            {0.75 * beside, nose, 0.75 * (design.topRadius + std::min(beside, over))}};
}

}  // namespace

Polyline ribOpening(const TunnelConsoleDesign& design, const RibGaps& gaps, double floor,
                    int segmentsPerQuarter) {
    const auto [right, left, over] = gaps.sides;
    HalfOpening opening = halfOpening(design, right, over, floor);
    const HalfOpening other = halfOpening(design, left, over, floor);
    for (std::size_t i = other.line.size(); i-- > 0;)
        opening.line.push_back({-other.line[i].x(), other.line[i].y()});
    opening.radii.insert(opening.radii.end(), other.radii.rbegin(), other.radii.rend());
    return filleted(opening.line, opening.radii, segmentsPerQuarter);
}

}  // namespace clearway::scenes
