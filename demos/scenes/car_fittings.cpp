// The front of the car body, and the fittings of the body.
#include "demos/scenes/car_body.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

/// A wheel house or its liner: half a tube about an axis parallel to y. u is the arc's length, v is y.
PanelShape wheelHouse(const Vector3& centre, double radius, double fromY, double toY, double thickness) {
    constexpr double kDish = 630;  // y from which the tube narrows to the outside
    PanelShape shape;
    shape.surface = [=](double u, double v) {
        const double angle = u / radius, dish = 25 * smoothStep(v, kDish, kDish + 60);
        return Vector3(centre.x() - (radius - dish) * std::cos(angle), v,
                       centre.z() + (radius - dish) * std::sin(angle));
    };
    shape.low = {0.12 * radius, fromY};
    shape.high = {(M_PI - 0.12) * radius, toY};
    shape.thickness = thickness;
    shape.vLines = {kDish, kDish + 15, kDish + 30, kDish + 45};
    for (const double angle : {0.8, 1.57, 2.34}) {
        shape.openings.push_back({{angle * radius, (fromY + toY) / 2 - 20}, {16, 16}, 2});
    }
    return shape;
}

/// The air conditioning unit: a hollow box with rounded edges across the car, closed by covers at its ends.
void addHvacUnit(SheetMetal& metal) {
    const int n = metal.detail().segmentsPerQuarter;
    const auto loop = [&](double inset, double radius) {
        return roundedRectangle({-1085 + inset, 605 + inset}, {-918 - inset, 795 - inset}, radius, n);
    };
    metal.beam("hvac_housing", across(-140, 140), ringSection(loop(0, 24), loop(2.5, 21.5)));
    for (const double side : {-1.0, 1.0}) {
        metal.beam(side < 0 ? "hvac_cover_left" : "hvac_cover_right",
                   across(142.0 * side - 1.5, 142.0 * side + 1.5), fullSection(loop(1, 23)));
    }
    for (const double y : {-90.0, -30.0, 30.0, 90.0}) {
        metal.beam("hvac_rib_" + std::to_string(static_cast<int>(y + 100)), across(y - 1.2, y + 1.2),
                   ringSection(loop(-3.5, 27.5), loop(-0.4, 24.4)));
    }
    const double r = 52;
    const Polyline fan{{0, 0}, {r, 0}, {r, 34}, {r - 20, 44}, {0, 44}};
    metal.turnedPart("hvac_fan", filleted(fan, {4, 8, 8}, n), {1000, 145, 700}, Vector3::UnitY());
}

struct Fittings {
    const CarBody& body;
    SheetMetal& metal;
    Random& random;

    int quarter() const { return metal.detail().segmentsPerQuarter; }
    int turn() const { return metal.detail().segmentsPerTurn; }
    double fine() const { return std::max(5.0, 0.7 * metal.detail().step); }

    void addSeat();
    void addBench();
    void addSuspension(const Vector3& wheel);
    void addExhaust();
    void addSteering();
    void addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double number);
    void addLines();
};

void Fittings::addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double number) {
    BoltShape shape;
    shape.length = 4;
    const int bolts = std::max(2, metal.detail().count(number));
    for (int i = 0; i < bolts; ++i) {
        const Vector3 at = from + (to - from) * ((i + 0.5) / bolts);
        metal.part("bolt", bolt(shape, turn()), at, axis, random.between(0, M_PI));
    }
}

/// A seat: a frame of bent tubes on side plates, with wires across and a padded cushion.
void Fittings::addSeat() {
    const double y = 400, low = 348;
    const Vector3 foot(1850, y, low + 90), head(2010, y, 1010);
    const auto back = [&](double share, double side) -> Vector3 {
        return foot + (head - foot) * share + Vector3(0, side * (215 - 40 * share * share), 0);
    };
    metal.part("seat_back_tube",
               pipe(bent({back(0, -1), back(0.6, -1), back(1, -1), back(1, 1), back(0.6, 1), back(0, 1)}, 60,
                         quarter()),
                    13, 2, turn()));
    for (int i = 0; i < 5; ++i) {
        const double share = 0.15 + 0.15 * i;
        Line wire;
        for (int k = 0; k <= 12; ++k) {
            Vector3 p = back(share, (k / 6.0 - 1) * 0.9);
            p.x() += k % 2 == 0 ? 3 : -3;
            wire.push_back(p);
        }
        metal.part("seat_wire", rod(smooth(wire, fine()), 2, turn() / 2));
    }
    for (const double side : {-1.0, 1.0}) {
        const Piece plate =
            sweepAlongY(holedSection(
                            stationsBetween(1430, 1880, 75), {low, low + 75},
                            [](std::size_t i, std::size_t) { return i % 2 == 0 ? 0.0 : 22.0; }, turn()),
                        {y + side * 226 - 1.2, y + side * 226 + 1.2});
        metal.part("seat_side", plate);
        addBoltRow({1440, y + side * 227.5, low + 60}, {1870, y + side * 227.5, low + 60}, {0, side, 0}, 2);
        metal.part("head_rest_post",
                   rod({{2004, y + side * 60, 1026}, {2028, y + side * 60, 1114}}, 6, turn()));
    }
    metal.part("head_rest", roundedBox({2002, y - 120, 1121}, {2066, y + 120, 1190}, 28, 18, quarter()));
    const auto cushion = [=](double u, double v) {
        const double edge = smoothStep(std::abs(v - y), 150, 205) * 22,
                     front = smoothStep(1520 - u, 0, 110) * 24;
        return Vector3(u, v,
                       low + 86 + 24 * edge / 22 - front + 3 * std::cos((u - 1640) / 14) * (1 - edge / 22));
    };
    metal.panel("seat_pan",
                {cushion,
                 {1422, y - 210},
                 {1830, y + 210},
                 1.2,
                 0,
                 {{{1560, y - 90}, {30, 40}, 3}, {{1560, y + 90}, {30, 40}, 3}, {{1720, y}, {40, 60}, 3}}});
    metal.panel("seat_foam", {cushion, {1426, y - 206}, {1826, y + 206}, 34, 22});
}

void Fittings::addBench() {
    const auto back = [](double u, double v) {
        return Vector3(2700 + 0.32 * v + 14 * beadAt(std::abs(u), 210, 120, 60), u, 520 + v);
    };
    const std::vector<double> lines{-390, -330, -90, -30, 30, 90, 330, 390};
    metal.panel("bench_back_frame", {back,
                                     {-480, 0},
                                     {480, 470},
                                     1,
                                     0,
                                     {{{-210, 240}, {80, 120}, 4}, {{210, 240}, {80, 120}, 4}},
                                     lines});
    metal.panel("bench_back_foam", {back, {-476, 6}, {476, 464}, 40, -24, {}, lines});
    const auto seat = [](double u, double v) {
        return Vector3(u, v, 490 + 0.1 * (2650 - u) - 12 * beadAt(std::abs(v), 210, 130, 60));
    };
    metal.panel("bench_seat_foam", {seat, {2180, -480}, {2640, 480}, 60, 0, {}, {}, lines});
    metal.panel("bench_seat_pan", {seat,
                                   {2190, -475},
                                   {2630, 475},
                                   1,
                                   -33,
                                   {{{2400, 210}, {70, 70}, 3}, {{2400, -210}, {70, 70}, 3}},
                                   {},
                                   lines});
}

/// A wheel's spring, damper, brake disc and arm.
void Fittings::addSuspension(const Vector3& wheel) {
    const Vector3 foot = wheel + Vector3(0, -105, 20);
    Line coil;
    const int around = std::max(8, turn()), turns = 6;
    for (int i = 0; i <= turns * around; ++i) {
        const double angle = 2 * M_PI * i / around;
        coil.push_back(foot +
                       Vector3(52 * std::cos(angle), 52 * std::sin(angle), 60 + 26 * angle / (2 * M_PI)));
    }
    metal.part("spring", rod(coil, 6, turn() / 2));
    metal.part("damper", rod({foot - Vector3(0, 0, 50), foot + Vector3(0, 0, 50)}, 22, turn()));
    metal.part("damper_rod", rod({foot + Vector3(0, 0, 50.5), foot + Vector3(0, 0, 290)}, 9, turn()));
    const Polyline disc =
        filleted({{40, 0}, {130, 0}, {130, 9}, {70, 9}, {62, 34}, {40, 34}}, {1, 1, 3, 3}, quarter());
    Polyline closed{{40, 0}};
    closed.insert(closed.end(), disc.begin() + 1, disc.end());
    metal.part("brake_disc", ring(closed, 2 * turn()), wheel + Vector3(0, -36, 0), -Vector3::UnitY());
    metal.part("hub", turned(filleted({{0, 0}, {34, 0}, {34, 30}, {0, 30}}, {3, 5}, quarter()), turn()),
               wheel + Vector3(0, -50, 0), Vector3::UnitY());
    metal.part("caliper",
               roundedBox(wheel + Vector3(80, -60, -50), wheel + Vector3(150, -47, 50), 12, 4, quarter()));
    metal.part("lower_arm", rod(smooth({wheel + Vector3(0, -100, -60), wheel + Vector3(10, -130, -74),
                                        wheel + Vector3(40, -270, -70)},
                                       fine()),
                                14, turn()));
}

void Fittings::addExhaust() {
    const double z = 268;
    metal.part("exhaust_pipe",
               pipe(bent({{1000, 30, 250}, {1150, 20, z}, {1500, 0, z}}, 120, quarter()), 27, 2, turn()));
    metal.part("silencer_front",
               turned(filleted({{0, 0}, {30, 0}, {62, 18}, {62, 330}, {30, 350}, {0, 350}}, {4, 14, 14, 4},
                               quarter()),
                      2 * turn()),
               {1510, 0, z}, Vector3::UnitX());
    metal.part(
        "exhaust_pipe",
        pipe(bent({{1868, 0, z}, {2200, 0, z - 8}, {2420, 20, z - 20}, {2700, 60, 290}, {2990, 100, 180}},
                  120, quarter()),
             25, 2, turn()));
    metal.part("fuel_tank", roundedBox({2490, -430, 196}, {2880, -30, 310}, 50, 28, quarter()));
    metal.part("fuel_tank_strap", sweep(sheetSection({{-434, 318}, {-434, 192}, {-26, 192}, {-26, 318}}, 1.5),
                                        {2700.0, 2740.0}));
    metal.part("rear_silencer", roundedBox({3600, -330, 200}, {3760, 330, 296}, 54, 26, quarter()));
    for (int i = 0; i < 6; ++i)
        metal.part("silencer_rib", roundedBox({3620, -270.0 + 108 * i, 296.4}, {3740, -266.0 + 108 * i, 301},
                                              1.5, 1, quarter()));
}

void Fittings::addSteering() {
    const Vector3 hub(1395, -340, 770), axis = Vector3(0.92, 0, 0.38).normalized();
    metal.part("steering_wheel", ring(circle({178, 0}, 14, turn()), 3 * turn()), hub, axis);
    for (int i = 0; i < 3; ++i) {
        const Placement there = standingAt(hub, axis, 2 * M_PI * i / 3);
        metal.part("steering_spoke", rod({there({40, 0, -6}), there({163, 0, 0})}, 8, turn()));
    }
    metal.part("steering_boss",
               turned(filleted({{0, -30}, {36, -30}, {40, 8}, {0, 16}}, {6, 10}, quarter()), turn()), hub,
               axis);
}

/// A harness along each sill.
void Fittings::addLines() {
    const int cables = std::min(metal.detail().count(2), 6);
    for (int i = 0; i < cables; ++i) {
        Line line;
        for (double x = 1180; x <= 2340; x += 145)
            line.push_back({x, 606 + 3.0 * random.between(-1, 1), body.floorZ(x, 606) + 20 + 9.0 * i});
        const double wave = 8 / std::sqrt(metal.detail().richness), radius = 3.4;
        metal.part("sill_cable",
                   variedRod(
                       smooth(line, std::max(3.0, 0.4 * metal.detail().step)),
                       [=](double at) { return radius + 0.5 * std::sin(2 * M_PI * at / wave); }, turn() / 2));
    }
}

}  // namespace

void addDash(const CarBody& body, SheetMetal& metal, Random& random) {
    const auto surface = [&body](double u, double v) { return body.dash(u, v); };
    const double top = body.dashProfile().length() - 12;
    std::vector<Opening> openings;
    for (const double y : {-430.0, -240.0, 240.0, 430.0}) openings.push_back({{y, 560}, {26, 26}, 2});
    openings.push_back({{330, 420}, {22, 22}, 2});
    const std::vector<double> beads{265, 285, 375, 395, -265, -285, -375, -395}, rows{300, 330, 510, 540};
    metal.panel("dash_panel", {surface, {-620, 8}, {620, top}, 1, 0, openings, beads, rows});
    metal.panel("dash_insulation_cabin", {surface, {-590, 60}, {590, top - 40}, 5, 6, openings, beads, rows});
    metal.panel("dash_insulation_engine",
                {surface, {-570, 250}, {570, top - 60}, 3, -4.5, openings, beads, rows});
    metal.panel("dash_reinforcement", {surface, {-600, 430}, {600, 520}, 1.4, -9, {}, beads, {}});

    // The plenum in front of the windscreen, open above.
    const Polyline plenum{{-770, 905}, {-770, 835}, {-868, 828}, {-878, 918}, {-936, 924}, {-942, 906}};
    metal.beam("cowl_lower", across(-625, 625), sheetSection(metal.rounded(plenum, 12), 1));
    const Polyline cover{{-776, 909}, {-790, 842}, {-858, 835}, {-866, 905}};
    metal.beam("cowl_upper", across(-600, 600), sheetSection(metal.rounded(cover, 10), 0.9));
    addHvacUnit(metal);

    const int n = 3 * metal.detail().segmentsPerQuarter;
    const double z = random.between(818, 826);
    const Line harness{{927, -600, z},   {929, -380, z + 8}, {925, -170, z - 6},
                       {929, 60, z + 7}, {926, 330, z},      {928, 600, z - 5}};
    const double step = std::max(6.0, 0.7 * metal.detail().step);
    metal.part("harness", rod(smooth(harness, step), 7, n));
    const Line branch{
        {958, -250, 525}, {985, -255, 490}, {1020, -260, 440}, {1090, -280, 360}, {1165, -330, 300}};
    metal.part("harness", rod(smooth(branch, step), 5, n));
    const Polyline pedal{{-975, 520}, {-990, 485}, {-1040, 478}};
    metal.beam("pedal_bracket", across(-400, -290), sheetSection(metal.rounded(pedal, 8), 2.5));
}

/// Pads for the carrier: plane faces perpendicular to y, x and z at the gap from its end plates, mounting
/// plates and feet.
void addMountings(const CarBody& body, SheetMetal& metal) {
    BossShape boss;
    boss.radius = 13;
    boss.foot = 5;
    const int n = metal.detail().segmentsPerQuarter;
    metal.onBothSides([&] {
        const double foot = 611, face = body.carrierHalf + body.gap;
        for (const auto& [x, z] :
             {std::pair(1030.0, 730.0), std::pair(1060.0, 650.0), std::pair(1060.0, 820.0)}) {
            boss.height = foot - face;
            metal.turnedPart("side_mount", bossOutline(boss, n), {x, foot, z}, -Vector3::UnitY());
        }
        metal.beam("side_mount_plate", across(foot + 0.5, foot + 3.5),
                   rectangleSection({-1084, 615}, {-1000, 855}));
    });
    for (const double y : {-420.0, -180.0, 180.0, 420.0}) {
        const std::string side = std::to_string(static_cast<int>(y + 500));
        const double face = body.carrierFront - body.gap, back = face - 6;
        metal.beam("front_mount_bracket_" + side, across(y - 24, y + 24),
                   sheetSection({{-back + 1.5, 852}, {-back + 1.5, 894}}, 2.4));
        boss.height = 5.5;
        boss.radius = 9;
        boss.foot = 1;
        boss.rounding = 0;
        metal.turnedPart("front_mount", bossOutline(boss, n), {face - 5.5, y, 880}, Vector3::UnitX());
    }
    for (const double y : {-80.0, 80.0}) {
        const double top = body.carrierFoot - body.gap, base = body.floorZ(1185, y) + 6.5;
        Polyline hat = hatLine(60, top - base, 14);
        for (Vector2& p : hat) p += Vector2(-1185, base);
        metal.beam(y < 0 ? "tunnel_mount_left" : "tunnel_mount_right", across(y - 20, y + 20),
                   bandSection(offsetLine(metal.rounded(hat, 4), 1.8), metal.rounded(hat, 4)));
    }
}

void addFrontEnd(const CarBody& body, SheetMetal& metal, Random& random) {
    const auto bonnet = [&body](double u, double v) { return Vector3(u, v, body.bonnetZ(u, v)); };
    std::vector<Opening> lightening;
    for (const double x : {260.0, 450.0, 640.0}) {
        for (const double y : {-420.0, -140.0, 140.0, 420.0}) lightening.push_back({{x, y}, {62, 95}, 5});
    }
    metal.panel("bonnet_outer", {bonnet, {95, -640}, {760, 640}, 0.8, 0});
    metal.panel("bonnet_inner", {bonnet, {120, -610}, {750, 610}, 0.7, -14, lightening});
    metal.panel("bonnet_insulation", {bonnet, {150, -560}, {700, 560}, 6, -22, {}, {}, {}});
    metal.onBothSides([&] {
        const Vector3 front(kFrontWheel, 0, kWheelHeight), rear(kRearWheel, 0, kWheelHeight);
        metal.panel("wheel_house_front", wheelHouse(front, 330, 480, 690, 0.9));
        metal.panel("wheel_house_liner_front", wheelHouse(front, 324, 484, 694, 2));
        metal.panel("wheel_house_rear", wheelHouse(rear, 336, 555, 700, 0.8));
        metal.panel("wheel_house_rear_damping", wheelHouse(rear, 341, 560, 625, 2.2));
        metal.panel("wheel_house_liner_rear", wheelHouse(rear, 330, 558, 702, 1.6));
        const Polyline tower{{0, 0}, {95, 0}, {88, 60}, {60, 66}, {30, 60}, {0, 60}};
        metal.turnedPart("strut_tower", filleted(tower, {0, 14, 10, 8}, metal.detail().segmentsPerQuarter),
                         {kFrontWheel, 560, 560}, Vector3::UnitZ());
        const int n = metal.detail().segmentsPerQuarter;
        metal.beam("crash_can", Spine::through({{92, 430, 430}, {122, 430, 430}}, 10),
                   ringSection(roundedRectangle({-36, -46}, {36, 46}, 12, n),
                               roundedRectangle({-33, -43}, {33, 43}, 9, n)));
    });
    std::vector<Vector3> bow;
    for (double y = -620; y <= 620; y += 155) bow.emplace_back(30 + 60 * (y / 620) * (y / 620), y, 430);
    const int n = metal.detail().segmentsPerQuarter;
    metal.beam("bumper_beam", Spine::through(bow, 3000),
               ringSection(roundedRectangle({-14, -55}, {14, 55}, 8, n),
                           roundedRectangle({-11, -52}, {11, 52}, 5, n)));
    for (const double z : {320.0, 640.0}) {
        Polyline hat = hatLine(60, 40, 20);
        for (Vector2& p : hat) p += Vector2(-200, z);
        metal.beam(z < 400 ? "radiator_support_lower" : "radiator_support_upper", across(-380, 380),
                   sheetSection(metal.rounded(hat, 6), 1.5));
    }
    const int hoses = metal.detail().count(2);
    for (int i = 0; i < hoses; ++i) {
        const double apart = 660.0 / hoses, sway = 0.2 * apart;
        const double y = -330 + apart * (i + 0.5), z = random.between(520, 600);
        const Line hose{{250, y, z},
                        {380, y + random.between(-sway, sway), z - 60},
                        {620, y + random.between(-sway, sway), z - 30},
                        {800, y + random.between(-sway, sway), z + 40}};
        metal.part("hose", rod(smooth(hose, std::max(8.0, metal.detail().step)), random.between(8, 14),
                               2 * metal.detail().segmentsPerQuarter + 4));
    }
}

void addFittings(const CarBody& body, SheetMetal& metal, Random& random) {
    Fittings fittings{body, metal, random};
    metal.onBothSides([&] {
        fittings.addSeat();
        fittings.addSuspension({kFrontWheel, 690, kWheelHeight});
        fittings.addSuspension({kRearWheel, 700, kWheelHeight});
        fittings.addLines();
        for (const double x : {1450.0, 1850.0}) {
            const double z = body.floorZ(x, 230) + 4.2;
            fittings.addBoltRow({x - 53, 245, z}, {x - 53, 560, z}, Vector3::UnitZ(), 3);
            fittings.addBoltRow({x + 53, 245, z}, {x + 53, 560, z}, Vector3::UnitZ(), 3);
        }
        fittings.addBoltRow({300, 640, 880}, {860, 640, 880}, Vector3::UnitZ(), 3);
    });
    fittings.addBench();
    fittings.addExhaust();
    fittings.addSteering();
}

}  // namespace clearway::scenes
