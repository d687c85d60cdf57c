// The sheet metal of the engine bay, and the chassis below it.
#include "demos/scenes/cembox_bay.h"

#include <cmath>

#include "demos/scenes/sheet_metal.h"

namespace clearway::scenes {

namespace {

/// A line up a wall with evenly spaced beads that stand `depth` to its left.
Polyline beadedWall(const Vector2& from, const Vector2& to, int beads, double depth) {
    const Vector2 along = (to - from).normalized(), left(-along.y(), along.x());
    const double spacing = (to - from).norm() / beads, flat = 0.3 * spacing, slope = 1.2 * std::abs(depth);
    Polyline line{from};
    for (int i = 0; i < beads; ++i) {
        const Vector2 middle = from + along * (spacing * (i + 0.5));
        line.push_back(middle - along * (flat / 2 + slope));
        line.push_back(middle - along * (flat / 2) + left * depth);
        line.push_back(middle + along * (flat / 2) + left * depth);
        line.push_back(middle + along * (flat / 2 + slope));
    }
    line.push_back(to);
    return line;
}

/// The y of a point of the arched bulkhead that lies at `y` in its middle.
double archedBack(double y, double x) {
    return y + 22 * (x / 700) * (x / 700);
}

/// The bulkhead and the cowl's front edge above it, arched slightly to the rear.
void addBulkhead(Bay& bay) {
    const double y = Bay::kBulkhead, half = Bay::kHalfWidth - 25;
    const Placement arched = [](const Vector3& p) { return Vector3(p.x(), archedBack(p.y(), p.x()), p.z()); };
    Polyline lower = beadedWall({y, 130}, {y, 380}, 3, -7);
    lower.insert(lower.begin(), {y + 70, 60});
    const std::vector<double> along = bay.stations(-half, half);
    bay.add("bulkhead_lower", placed(sweep(bay.sheet(lower, 6, 1.4), along), arched));
    Polyline upper = beadedWall({y, 381}, {y, 600}, 2, -6);
    upper.push_back({y, 655});
    upper.push_back({y - 14, 664});
    bay.add("bulkhead_upper", placed(sweep(bay.sheet(upper, 6, 1.2), along), arched));
    const Polyline cowl{{y + 30, 667}, {y - 22, 667}, {y - 27, 690}, {y - 12, 722}, {y + 40, 732}};
    bay.add("cowl_edge", placed(sweep(bay.sheet(cowl, 7, 1.2), along), arched));
    const Polyline gasket = circle({y - 27, 728}, 5, bay.segmentsFor(5));
    bay.add("cowl_seal", placed(sweep(fullSection(gasket), along), arched));
    bay.addBoltRow({-half + 20, y - 2, 630}, {half - 20, y - 2, 630}, -Vector3::UnitY(), 3, 5);
}

/// An inner wing, with the wheel arch bulging inwards.
void addInnerWing(Bay& bay, double side) {
    const double x = Bay::kHalfWidth;
    Polyline line = beadedWall({x, 180}, {x, 620}, 3, 8);
    line.insert(line.begin(), {x - 46, 176});
    line.push_back({x, 690});
    line.push_back({x + 48, 694});
    if (side < 0) {
        for (Vector2& p : line) p.x() = -p.x();
    }
    const Placement bulged = [side](const Vector3& p) {
        const double y = (p.y() - Bay::kTowerY) / 150, z = (p.z() - 250) / 220;
        return Vector3(p.x() - side * 45 * std::exp(-y * y - z * z), p.y(), p.z());
    };
    const char* const name = side > 0 ? "inner_wing_left" : "inner_wing_right";
    bay.add(name, placed(sweepAlongY(bay.sheet(line, 7, 1.2), bay.stations(20, 835)), bulged));
    bay.addBoltRow({side * (x + 28), 40, 695}, {side * (x + 28), 810, 695}, Vector3::UnitZ(), 3, 5);
}

void addStrutTower(Bay& bay, double side) {
    const double top = Bay::kTowerTop, t = 2;
    const Polyline corners{{0, top - t}, {52, top - t}, {80, top - 26},     {88, 420}, {125, 380},
                           {127, 382},   {88 + t, 421}, {80 + t, top - 25}, {53, top}, {0, top}};
    const Polyline outline = bay.rounded(corners, {6, 12, 14, 0, 0, 15, 13, 7});
    const Vector3 foot(side * Bay::kTowerX, Bay::kTowerY, 0);
    const Vector3 lean(-0.06 * side, 0.05, 1);
    bay.add(side > 0 ? "strut_tower_left" : "strut_tower_right", bay.turnedRound(outline),
            foot + Vector3(35 * side, -30, 0), lean);
    const Vector3 head = foot + Vector3(0, 0, top + 3);
    for (int i = 0; i < 3; ++i) {
        const double angle = 0.4 + 2 * M_PI * i / 3;
        bay.addBolt(head + 34 * Vector3(std::cos(angle), std::sin(angle), 0), lean, 4);
    }
    const Polyline bearing = bay.rounded({{0, 0}, {24, 0}, {24, 5}, {9, 9}, {9, 22}, {0, 22}}, {2, 3, 2, 3});
    bay.add(side > 0 ? "strut_bearing_left" : "strut_bearing_right", bay.turnedRound(bearing), head, lean);
}

/// A hollow side member with rounded edges.
void addRail(Bay& bay, double side) {
    const int n = bay.quarterFor(9);
    const double x = side * 430;
    const auto outline = [&](double in) {
        return roundedRectangle({x - 34 + in, 110 + in}, {x + 34 - in, 220 - in}, 9 - in, n);
    };
    const Placement dropping = [](const Vector3& p) {
        const double behind = std::max(0.0, p.y() - 600) / 250;
        return Vector3(p.x(), p.y(), p.z() - 45 * behind * behind);
    };
    const Section section = ringSection(outline(0), outline(2));
    bay.add(side > 0 ? "side_member_left" : "side_member_right",
            placed(sweepAlongY(section, bay.stations(15, 840)), dropping));
    for (const double y : {90.0, 300.0, 520.0}) {
        bay.addBoltRow({x + side * 34.3, y, 165}, {x + side * 34.3, y + 110, 165}, {side, 0, 0}, 4, 2);
    }
}

/// A hat section across the bay with its closing plate.
void addCrossMember(Bay& bay, const std::string& name, const Vector2& middle, const Vector2& size,
                    double half) {
    const double w = size.x() / 2, low = middle.y(), high = middle.y() + size.y();
    const Polyline hat{{middle.x() - w - 22, low},   {middle.x() - w, low}, {middle.x() - 0.8 * w, high},
                       {middle.x() + 0.8 * w, high}, {middle.x() + w, low}, {middle.x() + w + 22, low}};
    const std::vector<double> along = bay.stations(-half, half);
    bay.add(name, sweep(bay.sheet(hat, 8, 2), along));
    const Section plate =
        rectangleSection({middle.x() - w - 22, low - 3.5}, {middle.x() + w + 22, low - 1.5});
    bay.add(name + "_plate", sweep(plate, {-half, half}));
    bay.addBoltRow({-half + 15, middle.x() + w + 12, low + 1.2}, {half - 15, middle.x() + w + 12, low + 1.2},
                   Vector3::UnitZ(), 3, 6);
}

void addHeadlight(Bay& bay, double side) {
    const double x = side * 500;
    const Piece shell = tray({-85, -50, 0}, {85, 50, 95}, 24, 2.5, bay.quarterFor(24));
    const Placement forward = facing({x, 118, 555}, Vector3::UnitX(), -Vector3::UnitY());
    bay.add(side > 0 ? "headlight_left" : "headlight_right", placed(shell, forward));
    const Piece reflector = bay.turnedRound(
        bay.rounded({{0, 9}, {15, 9}, {39.5, 60}, {38, 60}, {14, 12}, {0, 12}}, {4, 0, 0, 2}));
    for (const double at : {-40.0, 40.0})
        bay.addNumbered("reflector",
                        placed(reflector, facing({x + at, 114, 555}, Vector3::UnitX(), -Vector3::UnitY())));
    bay.addBoltRow({x - 90, 119, 612}, {x + 90, 119, 612}, Vector3::UnitY(), 3, 2);
}

/// A plate with lightening holes between the inner wing and the side member.
void addApron(Bay& bay, double side) {
    std::vector<double> xs, ys;
    for (int i = 0; i <= 3; ++i) xs.push_back(470 + 170 * i / 3.0);
    const int cells = std::max(5, bay.detail.count(3));
    for (int i = 0; i <= cells; ++i) ys.push_back(130 + 320.0 * i / cells);
    const double room = 0.5 * std::min(xs[1] - xs[0], ys[1] - ys[0]);
    const auto hole = [room](std::size_t column, std::size_t row) {
        return (column + row) % 2 == 0 ? 0.62 * room : 0.0;
    };
    Section plate = holedSection(xs, ys, hole, bay.segmentsFor(0.62 * room));
    Piece apron = sweepAlongZ(plate, {172, 173.6});
    if (side < 0) apron = placed(apron, [](const Vector3& p) { return Vector3(-p.x(), 580 - p.y(), p.z()); });
    bay.add(side > 0 ? "apron_left" : "apron_right", apron);
}

void addPanel(Bay& bay, const std::string& name, const PanelShape& shape) {
    bay.add(name, Panel(shape, {bay.detail.step, std::max(2, bay.quarterFor(8))}).piece());
}

/// A hollow beam with rounded corners, for sweeps along x.
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
        bay.addNumbered("horn", bay.turnedRound(horn), {side * 420, 46, 330}, -Vector3::UnitY());
        const Section can = hollowBeam(bay, 30, 40, 2);
        bay.addNumbered("crash_can",
                        placed(sweep(can, {0.0, 35.0, 70.0}),
                               facing({side * 430, -35, 165}, Vector3::UnitY(), Vector3::UnitZ())));
        for (const double z : {130.0, 200.0}) bay.addBolt({side * 472, 10, z}, -Vector3::UnitY(), 3.5);
    }
}

/// The chassis below the engine: a frame, the steering with its bellows, the shafts with their boots.
void addChassis(Bay& bay) {
    const Line corners{{-380, 660, -20}, {-380, 200, -32}, {-300, 120, -32},
                       {300, 120, -32},  {380, 200, -32},  {380, 660, -20}};
    const Line frame = bent(corners, 60, bay.quarterFor(60));
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
    bay.add("steering_shaft", bay.turnedRound(joint), {-150, 668, 40}, Vector3(0, 0.75, 0.66));
}

/// Insulation behind the bulkhead, in two layers, with grommets in its holes.
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
    // The upper side of the sheet faces -y.
    addPanel(bay, "insulation_heavy_layer",
             {behind(862), {-600, 150}, {600, 610}, 3, 0, openings, {}, beads});
    addPanel(bay, "insulation_foam", {behind(874), {-590, 160}, {590, 600}, 12, 0, openings, {}, beads});
    for (const Opening& opening : openings) {
        const double radius = opening.half.minCoeff() - 6;
        const double y = 858 + 22 * std::pow(opening.centre.x() / 700, 2);
        const Polyline lip = bay.rounded(
            {{radius - 12, 0}, {radius, 0}, {radius, 26}, {radius - 4, 30}, {radius - 12, 30}}, {2, 4, 3});
        bay.addNumbered("grommet", bay.turnedRing(lip), {opening.centre.x(), y, opening.centre.y()},
                        Vector3::UnitY());
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

/// A tray with drain holes behind the cowl's edge, and in it the motor that drives both wiper arms.
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
    bay.add("wiper_motor", bay.turnedRound(motor), {-60, 950, 692}, Vector3::UnitX());
    for (const double x : {-400.0, 180.0}) {
        const Polyline pivot =
            bay.rounded({{0, 0}, {14, 0}, {14, 40}, {9, 46}, {9, 62}, {0, 62}}, {2, 2, 2, 2});
        bay.addNumbered("wiper_pivot", bay.turnedRound(pivot), {x, 955, 706}, Vector3(0, -0.2, 1));
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

void addBody(Bay& bay) {
    addBulkhead(bay);
    for (const double side : {1.0, -1.0}) {
        addInnerWing(bay, side);
        addStrutTower(bay, side);
        addRail(bay, side);
        addHeadlight(bay, side);
        addApron(bay, side);
    }
    addCrossMember(bay, "front_member", {60, 85}, {70, 55}, 460);
    addCrossMember(bay, "rear_member", {690, 40}, {120, 60}, 460);
    addCrossMember(bay, "radiator_support", {62, 630}, {34, 26}, 600);
    const Polyline latch{{0, 0}, {16, 0}, {16, 30}, {9, 42}, {0, 42}};
    bay.add("hood_latch", bay.turnedRound(bay.rounded(latch, {2, 6, 3})),
            {bay.random.between(-30, 30), 62, 657.5}, Vector3::UnitZ());
}

/// Rows of domes on the flat strip of the bulkhead above its beads, out of the module's way.
void addWeldStuds(Bay& bay, int studs) {
    constexpr double kRadius = 3, kPitch = 7.5,
                     kRows[] = {602, 609, 616, 644};  // mm; the bolts lie between the rows
    constexpr int kColumns = 158;
    const Piece dome = turned(domeOutline(kRadius, 2.5, bay.quarterFor(8) + 2), 2 * bay.segmentsFor(15));
    for (int i = 0; i < studs; ++i) {
        const double x = kPitch * (i % kColumns - 0.5 * (kColumns - 1)), z = kRows[i / kColumns % 4];
        const double y = archedBack(Bay::kBulkhead, x) - 0.6 - Bay::kSlit;
        bay.assembly.addNumbered("weld_stud", placed(dome, standingAt({x, y, z}, -Vector3::UnitY())));
    }
}

void addBayFittings(Bay& bay) {
    addFrontEnd(bay);
    addChassis(bay);
    addInsulation(bay);
    for (const double side : {1.0, -1.0}) addWingBraces(bay, side);
    addWipers(bay);
}

}  // namespace clearway::scenes
