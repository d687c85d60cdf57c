// What holds the module, and what it has to be turned around once it is out: rails, buffers, carrier, the
// wiper's tube above and the strut brace before it.
#include <algorithm>
#include <cmath>

#include "program/scenes/cembox_bay.h"
#include "program/scenes/plate.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

constexpr double kRailWall = 3;
constexpr double kBufferHeight = 7;

/// A channel around the guide edge at the gap, in the module's (x, y). Its inner corners are rounded by half
/// of it: even a single chord then keeps the gap from the edge's corner.
Section railSection(const Bay& bay, double side) {
    const CemboxDesign& design = bay.design;
    const double lip = design.bodyHalf + 1.6 * design.gap, outer = design.edgeHalf + design.gap;
    const double half = design.edgeThickness / 2 + design.gap, corner = 0.5 * design.gap;
    Polyline inside =
        bay.rounded({{lip, half}, {outer, half}, {outer, -half}, {lip, -half}}, {corner, corner});
    if (side < 0) {
        std::reverse(inside.begin(), inside.end());
        for (Vector2& p : inside) p.x() = -p.x();
    }
    return bandSection(offsetLine(inside, kRailWall), inside);
}

/// The only things nearer to the module than the room that is kept free.
void addRailsAndBuffers(Bay& bay) {
    const CemboxDesign& design = bay.design;
    const Placement inBay = [&](const Vector3& p) -> Vector3 { return p + design.place; };
    for (const double side : {1.0, -1.0}) {
        const Piece rail =
            sweepAlongZ(railSection(bay, side), bay.stations(-design.halfHeight - 5, design.railTop));
        bay.assembly.add(side > 0 ? "guide_rail_left" : "guide_rail_right", placed(rail, inBay));
        const Vector3 below(0.7 * side * design.bodyHalf, 0, -design.halfHeight - design.gap - kBufferHeight);
        const Piece buffer = bay.turnedRound(domeOutline(9, kBufferHeight, bay.quarterFor(9)));
        bay.assembly.add(side > 0 ? "buffer_left" : "buffer_right",
                         placed(buffer, standingAt(design.place + below, Vector3::UnitZ())));
    }
}

void addCarrier(Bay& bay) {
    const CemboxDesign& design = bay.design;
    const Vector3& place = design.place;
    const double behind = place.y() + design.back + 1.5 * design.clearance + 4;
    const double floor = place.z() - design.halfHeight - design.gap - kBufferHeight - Bay::kSlit;
    const double half = design.edgeHalf + design.gap + kRailWall + Bay::kSlit;
    std::vector<double> xs, zs;
    for (int i = 0; i <= 9; ++i) xs.push_back(place.x() + half * (2.0 * i / 9 - 1));
    for (int i = 0; i <= 5; ++i) zs.push_back(floor + 0.85 * design.halfHeight * 2 * i / 5.0);
    const auto hole = [](std::size_t column, std::size_t row) { return (column + row) % 3 == 1 ? 9.0 : 0.0; };
    bay.add("carrier_plate",
            sweepAlongY(holedSection(xs, zs, hole, bay.segmentsFor(9)), {behind, behind + 2}));
    bay.add("carrier_shelf", bay.box({place.x() - half, place.y() - 34, floor - 2.5},
                                     {place.x() + half, behind - Bay::kSlit, floor}, 6, 0.8));
    for (const double side : {1.0, -1.0}) {
        const double inner = place.x() + side * (half + 1.2 + 0.6 * design.clearance),
                     z = place.z() - design.halfHeight;
        for (const double height : {20.0, 120.0}) {
            // An angle: along the rail's outside, then along the bulkhead.
            const Polyline line{{inner, place.y() - 14}, {inner, 838}, {inner + side * 30, 838}};
            const Section angle = bay.sheet(line, 5, 1.8);
            bay.addNumbered("rail_bracket", sweepAlongZ(angle, {z + height, z + height + 36}));
            bay.addBolt({inner + side * 18, 836.8, z + height + 18}, -Vector3::UnitY(), 3);
            bay.addBolt({inner + side * 1.2, place.y(), z + height + 18}, side * Vector3::UnitX(), 2.5);
        }
    }
}

/// They leave the module a way, but only a tilted one.
void addGate(Bay& bay) {
    const CemboxDesign& design = bay.design;
    const double free = 3 * design.clearance + 3;  // a little more than is kept free
    const Vector3& place = design.place;
    constexpr double kTube = 12, kBrace = 13;
    const double tubeZ = place.z() + design.lift + design.top + 10 + free + kTube;
    bay.add("wiper_tube", bay.tube(bent({{-420, 835, tubeZ - 60},
                                         {-300, place.y() + 22, tubeZ},
                                         {560, place.y() + 22, tubeZ},
                                         {610, 835, tubeZ - 60}},
                                        40, bay.quarterFor(40)),
                                   kTube, 2));
    // Before the front of the tilted module, seen from its middle after it was tilted.
    const Vector3 middle = place + Vector3(0, -25, design.lift + 15);
    const double z = place.z() + 262,
                 ahead = -design.front + kBrace + free + 6 + std::sin(design.tilt) * (z - middle.z());
    const double y = middle.y() - ahead / std::cos(design.tilt);
    bay.add("strut_brace", bay.tube(bent({{-Bay::kTowerX, Bay::kTowerY, Bay::kTowerTop + 16},
                                          {-Bay::kTowerX + 120, y, z},
                                          {Bay::kTowerX - 90, y, z},
                                          {Bay::kTowerX, Bay::kTowerY, Bay::kTowerTop + 16}},
                                         50, bay.quarterFor(50)),
                                    kBrace, 2));
}

}  // namespace

void addSlot(Bay& bay) {
    addRailsAndBuffers(bay);
    addCarrier(bay);
    addGate(bay);
}

}  // namespace clearway::scenes
