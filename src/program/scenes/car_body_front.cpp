// The front of the car body: dash panel with its layers and what is mounted on it, cowl, the pads the carrier
// comes to rest at, wheel houses, bonnet and front end.
#include <cmath>

#include "program/scenes/car_body.h"
#include "program/scenes/curve.h"

namespace clearway::scenes {

namespace {

/// Half a tube about an axis parallel to y: a wheel house or its liner. u is the arc's length, v is y.
PanelShape wheelHouse(const Vector3& centre, double radius, double fromY, double toY, double thickness) {
    constexpr double kDish = 630;  // y from which it narrows to the outside
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

/// A hollow box with rounded edges, lying across the car, closed by covers at its ends.
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

    // The plenum before the windscreen, open above.
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

/// Plane faces square to y, x and z at the gap from the carrier's end plates, mounting plates and feet.
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

}  // namespace clearway::scenes
