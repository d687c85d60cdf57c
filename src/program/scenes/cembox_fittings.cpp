// What version 2 of the scene cembox has beside version 1: bumper and grille before the radiator, subframe,
// steering and drive shafts below, sheets with holes behind the bulkhead and beside the wings, wipers.
#include <cmath>

#include "program/scenes/cembox_bay.h"
#include "program/scenes/loft.h"
#include "program/scenes/panel.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

void addPanel(Bay& bay, const std::string& name, const PanelShape& shape) {
    bay.add(name, Panel(shape, {bay.detail.step, std::max(2, bay.quarterFor(8))}).piece());
}

/// Hollow, its corners rounded, in the plane across x.
Section hollowBeam(const Bay& bay, double halfWidth, double halfHeight, double wall) {
    const int n = bay.quarterFor(9);
    return ringSection(roundedRectangle({-halfWidth, -halfHeight}, {halfWidth, halfHeight}, 9, n),
                       roundedRectangle({-halfWidth + wall, -halfHeight + wall},
                                        {halfWidth - wall, halfHeight - wall}, 9 - wall, n));
}

void addFrontEnd(Bay& bay) {
    const auto bowed = [](double y) {
        return [y](const Vector3& p) -> Vector3 {
            return {p.x(), p.y() + y + 55 * (p.x() / 600) * (p.x() / 600), p.z()};
        };
    };
    const Placement atBeam = [&](const Vector3& p) -> Vector3 {
        return bowed(-95)({p.x(), p.y(), p.z() + 230});
    };
    bay.add("bumper_beam", placed(sweep(hollowBeam(bay, 22, 48, 2.5), bay.stations(-590, 590)), atBeam));
    bay.add("bumper_foam",
            placed(sweep(fullSection(roundedRectangle({-64, -40}, {-24, 40}, 12, bay.quarterFor(12))),
                         bay.stations(-560, 560)),
                   atBeam));
    const int slats = bay.detail.count(6);
    for (int i = 0; i < slats; ++i) {
        const double z = 330 + 230 * (i + 0.5) / slats;
        const Polyline slat = bay.rounded({{-16, 6}, {-2, 0}, {16, -3}}, {6});
        bay.addNumbered("grille_slat", placed(sweep(sheetSection(slat, 2.2), bay.stations(-340, 340)),
                                              [&](const Vector3& p) -> Vector3 {
                                                  return bowed(14)({p.x(), p.y(), p.z() + z});
                                              }));
    }
    for (const double side : {1.0, -1.0}) {
        const Polyline horn =
            bay.rounded({{0, 0}, {38, 0}, {42, 8}, {42, 20}, {30, 26}, {12, 40}, {0, 40}}, {3, 3, 4, 5, 5});
        bay.addNumbered("horn",
                        placed(bay.turnedRound(horn), standingAt({side * 420, 46, 330}, -Vector3::UnitY())));
        const Section can = hollowBeam(bay, 30, 40, 2);
        bay.addNumbered("crash_can",
                        placed(sweep(can, {0.0, 35.0, 70.0}),
                               facing({side * 430, -35, 165}, Vector3::UnitY(), Vector3::UnitZ())));
        for (const double z : {130.0, 200.0}) bay.addBolt({side * 472, 10, z}, -Vector3::UnitY(), 3.5);
    }
}

/// Below the engine: a frame, the steering with its bellows, the shafts with their boots.
void addChassis(Bay& bay) {
    const Line frame = bent({{-380, 660, -20},
                             {-380, 200, -32},
                             {-300, 120, -32},
                             {300, 120, -32},
                             {380, 200, -32},
                             {380, 660, -20}},
                            60, bay.quarterFor(60));
    bay.add("subframe", pulled(hollowBeam(bay, 34, 22, 3), frame));
    bay.add("subframe_cross", placed(sweep(hollowBeam(bay, 40, 18, 3), bay.stations(-330, 330)),
                                     [](const Vector3& p) -> Vector3 { return p + Vector3(0, 560, -22); }));
    bay.addBoltRow({-260, 560, -3.5}, {260, 560, -3.5}, Vector3::UnitZ(), 4, 4);
    bay.add("steering_rack", bay.bar({{-250, 640, 26}, {250, 640, 26}}, 19));
    const double wave = 16 / std::sqrt(bay.detail.richness);
    for (const double side : {1.0, -1.0}) {
        const Line along = smooth({{side * 254, 640, 26}, {side * 330, 638, 26}, {side * 400, 634, 24}},
                                  bay.detail.step / 8);
        bay.addNumbered("steering_bellows", bay.wavyBar(along, 20, [wave](double at) {
            return 18 - at / 30 + 3 * std::sin(2 * M_PI * at / wave);
        }));
        bay.addNumbered("tie_rod", bay.bar({{side * 402, 634, 24}, {side * 585, 618, 18}}, 7));
        bay.addNumbered("drive_shaft", bay.bar({{side * 440, 372, 74}, {side * 560, 372, 66}}, 13));
        for (const double x : {395.0, 565.0}) {
            const Line boot =
                smooth({{side * x, 372, 77 - (x - 395) / 17}, {side * (x + 40), 372, 75 - (x - 395) / 17}},
                       bay.detail.step / 8);
            bay.addNumbered("shaft_boot", bay.wavyBar(boot, 34, [wave](double at) {
                return 32 - 0.3 * at + 3 * std::sin(2 * M_PI * at / wave);
            }));
        }
    }
    const Polyline joint =
        bay.rounded({{0, 0}, {24, 0}, {24, 34}, {14, 44}, {14, 120}, {0, 120}}, {3, 6, 4, 2});
    bay.add("steering_shaft",
            placed(bay.turnedRound(joint), standingAt({-150, 668, 40}, Vector3(0, 0.75, 0.66))));
}

/// Behind the bulkhead: insulation in two layers with grommets in its holes.
void addInsulation(Bay& bay) {
    const auto behind = [](double y) {
        return [y](double u, double v) -> Vector3 {
            const double bead = beadAt(v, 230, 26, 22) + beadAt(v, 330, 26, 22) + beadAt(v, 520, 30, 24);
            return {u, y + 22 * (u / 700) * (u / 700) + 6 * bead, v};
        };
    };
    std::vector<Opening> openings{{{-380, 520}, {70, 62}, 2}, {{-150, 200}, {44, 44}, 2},
                                  {{0, 420}, {95, 60}, 4},    {{300, 260}, {34, 34}, 2},
                                  {{480, 480}, {52, 26}, 3},  {{-520, 300}, {30, 30}, 2}};
    const std::vector<double> beads{182, 204, 256, 278, 282, 304, 356, 378, 466, 490, 550, 574};
    // Its upper side looks to -y.
    addPanel(bay, "insulation_heavy_layer",
             {behind(862), {-600, 150}, {600, 610}, 3, 0, openings, {}, beads});
    addPanel(bay, "insulation_foam", {behind(874), {-590, 160}, {590, 600}, 12, 0, openings, {}, beads});
    for (const Opening& opening : openings) {
        const double radius = opening.half.minCoeff() - 6;
        const double y = 858 + 22 * std::pow(opening.centre.x() / 700, 2);
        const Polyline lip = bay.rounded(
            {{radius - 12, 0}, {radius, 0}, {radius, 26}, {radius - 4, 30}, {radius - 12, 30}}, {2, 4, 3});
        bay.addNumbered("grommet",
                        placed(bay.turnedRing(lip),
                               standingAt({opening.centre.x(), y, opening.centre.y()}, Vector3::UnitY())));
    }
}

/// Sheets with lightening holes beside the inner wings, screwed to their flanges.
void addWingBraces(Bay& bay, double side) {
    const double x = side * (Bay::kHalfWidth + 74);
    const auto surface = [x, side](double u, double v) -> Vector3 {
        return {x + side * 7 * beadAt(v, 610, 14, 12) - side * 26 * smoothStep(v, 655, 690), u, v};
    };
    std::vector<Opening> openings;
    for (double y = 90; y < 800; y += 88) openings.push_back({{y, 545}, {28, 28}, 2});
    for (double y = 134; y < 780; y += 88) openings.push_back({{y, 640}, {12, 8}, 2});
    addPanel(
        bay, side > 0 ? "wing_brace_left" : "wing_brace_right",
        {surface, {30, 490}, {820, 688}, 1.2, 0, openings, {}, {584, 596, 624, 636, 655, 664, 673, 682}});
}

/// Behind the cowl's edge: a tray with drain holes, and in it the motor that drives both arms.
void addWipers(Bay& bay) {
    const auto tray = [](double u, double v) -> Vector3 {
        return {u, v,
                640 + 20 * smoothStep(v, 985, 1010) + 8 * beadAt(std::abs(u), 300, 120, 40) +
                    14 * (u / 600) * (u / 600)};
    };
    std::vector<Opening> drains;
    for (const double x : {-480.0, -160.0, 0.0, 160.0, 480.0}) drains.push_back({{x, 940}, {14, 14}, 2});
    addPanel(bay, "cowl_tray",
             {tray,
              {-600, 905},
              {600, 1020},
              1,
              0,
              drains,
              {-460, -420, -180, -140, 140, 180, 420, 460},
              {985, 993, 1002}});
    const Polyline motor =
        bay.rounded({{0, 0}, {30, 0}, {30, 70}, {18, 76}, {18, 96}, {0, 96}}, {4, 6, 4, 3});
    bay.add("wiper_motor", placed(bay.turnedRound(motor), standingAt({-60, 950, 692}, Vector3::UnitX())));
    for (const double x : {-400.0, 180.0}) {
        const Polyline pivot =
            bay.rounded({{0, 0}, {14, 0}, {14, 40}, {9, 46}, {9, 62}, {0, 62}}, {2, 2, 2, 2});
        bay.addNumbered("wiper_pivot",
                        placed(bay.turnedRound(pivot), standingAt({x, 955, 706}, Vector3(0, -0.2, 1))));
        bay.addNumbered("wiper_link", bay.bar({{x, 975, 700}, {x < 0 ? -66.0 : 46.0, 988, 694}}, 6));
        bay.addNumbered(
            "wiper_arm",
            bay.bar(
                smooth({{x + 2, 938, 776}, {x + 30, 980, 786}, {x + 250, 1010, 800}, {x + 420, 1016, 806}},
                       bay.detail.step / 2),
                6));
    }
    bay.addBoltRow({-560, 1014, 675}, {560, 1014, 675}, Vector3::UnitZ(), 3, 5);
}

}  // namespace

void addBayFittings(Bay& bay) {
    addFrontEnd(bay);
    addChassis(bay);
    addInsulation(bay);
    for (const double side : {1.0, -1.0}) addWingBraces(bay, side);
    addWipers(bay);
}

}  // namespace clearway::scenes
