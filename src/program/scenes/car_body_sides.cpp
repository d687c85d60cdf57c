// The sides of the car body: outer and inner sheets around the door openings, reinforcements between them
// that follow the skin in layers, fenders and rear quarters.
#include "program/scenes/car_body.h"

namespace clearway::scenes {

namespace {

const Opening kFrontDoor{{1540, 815}, {455, 468}, 7}, kRearDoor{{2472, 822}, {387, 462}, 7};
const Opening kQuarterWindow{{3180, 1080}, {170, 110}, 5};

struct Layer {
    const char* name;
    Vector2 low, high;
    double offset;
    double thickness;
};

/// Within the pillars and the sill, from the skin inwards.
const Layer kReinforcements[] = {
    {"hinge_pillar_reinforcement", {915, 230}, {1072, 880}, 4, 1.5},
    {"hinge_pillar_reinforcement_inner", {922, 260}, {1066, 860}, 8, 1.8},
    {"hinge_pillar_closing_plate", {918, 240}, {1070, 870}, 122, 1.2},
    {"windscreen_pillar_reinforcement", {912, 905}, {1070, 1315}, 5, 1.5},
    {"windscreen_pillar_closing_plate", {914, 905}, {1066, 1310}, 118, 1.2},
    {"b_pillar_reinforcement", {2001, 345}, {2079, 1280}, 3.5, 1.8},
    {"b_pillar_patch", {2008, 420}, {2072, 1000}, 7.5, 2},
    {"b_pillar_closing_plate", {2003, 345}, {2077, 1270}, 122, 1.2},
    {"sill_reinforcement", {1078, 212}, {2690, 338}, 4, 1.5},
    {"sill_closing_plate", {1078, 215}, {2680, 335}, 122, 1.2},
    {"cantrail_reinforcement", {1150, 1296}, {2850, 1324}, 4, 1.5},
    {"c_pillar_reinforcement", {2870, 560}, {2960, 1300}, 4, 1.2},
    {"quarter_inner", {2990, 620}, {3850, 930}, 30, 0.8},
    {"quarter_damping", {3420, 640}, {3780, 920}, 4.5, 2},
};

/// Lightening holes in rows, as many as the sheet between the openings has room for.
std::vector<Opening> innerOpenings() {
    std::vector<Opening> openings{kFrontDoor, kRearDoor, kQuarterWindow};
    for (const double z : {470.0, 640.0, 810.0}) openings.push_back({{1000, z}, {24, 34}, 2});
    for (const double x : {3100.0, 3320.0, 3540.0, 3740.0}) openings.push_back({{x, 800}, {42, 42}, 2});
    return openings;
}

}  // namespace

void addSides(const CarBody& body, SheetMetal& metal, Random& random) {
    const auto surface = [&body](double u, double v) { return body.side(u, v); };
    const double swage = random.between(620, 680), depth = random.between(5, 8);
    // A swage line along the skin, outwards.
    const auto skin = [&body, swage, depth](double u, double v) {
        Vector3 point = body.side(u, v);
        point.y() += depth * beadAt(v, swage, 6, 45);
        return point;
    };
    const std::vector<double> swageLines{swage - 51, swage - 28, swage - 6,
                                         swage + 6,  swage + 28, swage + 51};
    metal.onBothSides([&] {
        metal.panel("bodyside_outer", {skin,
                                       {905, 200},
                                       {3900, 1330},
                                       0.8,
                                       0,
                                       {kFrontDoor, kRearDoor, kQuarterWindow, {{3480, 800}, {75, 75}, 3}},
                                       {},
                                       swageLines});
        metal.panel("bodyside_inner", {surface, {960, 205}, {3850, 1318}, 0.9, 130, innerOpenings()});
        for (const Layer& layer : kReinforcements) {
            metal.panel(layer.name, {surface, layer.low, layer.high, layer.thickness, layer.offset});
        }
        metal.panel("fender", {skin, {95, 205}, {896, 870}, 0.8, 0, {}, {}, swageLines});
        metal.panel("fender_reinforcement",
                    {surface,
                     {140, 700},
                     {880, 860},
                     1,
                     16,
                     {{{300, 780}, {40, 30}, 2}, {{500, 780}, {40, 30}, 2}, {{700, 780}, {40, 30}, 2}}});
        metal.panel("fender_brace", {surface, {160, 720}, {860, 850}, 0.8, 20.5});
    });
    // Door seals lie around the openings; nuts sit on the inner sheet.
    metal.onBothSides([&] {
        const int nuts = metal.detail().count(6);
        const Polyline outline =
            filleted({{0, 0}, {7, 0}, {7, 6}, {4, 9}, {0, 9}}, {0, 1, 1}, metal.detail().segmentsPerQuarter);
        for (int i = 0; i < nuts; ++i) {
            const double u = 2900 + 900.0 * (i + 0.5) / nuts;
            metal.turnedPart("weld_nut", outline, body.side(u, 690) - Vector3(0, 134, 0), -Vector3::UnitY());
        }
    });
}

}  // namespace clearway::scenes
