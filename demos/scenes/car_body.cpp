#include "demos/scenes/car_body.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/scenes.h"

namespace clearway::scenes {

namespace {

constexpr double kCarBodyLeastClearance = 1,
                 kCarBodyMostClearance = 12;  // mm; with more, the cowl is nearer than the pads

/// Extra gap beyond the clearance, as a share of it: sampling planners need some room.
constexpr double kCarBodyEase = 0.1;

double squared(double x) {
    return x * x;
}

constexpr double kFloorHalf = 650;  // parameter v of the floor's edge

/// The floor as a surface: u is x, v is y except at the floor's narrowing ends.
std::function<Vector3(double, double)> floorSurface(const CarBody& body) {
    return [&body](double u, double v) {
        const double y = v * (body.halfWidth(u, 250) - 140) / kFloorHalf;
        return Vector3(u, y, body.floorZ(u, y));
    };
}

std::vector<double> beadLines() {
    std::vector<double> lines;
    for (const double middle : {280.0, 380.0, 480.0, 580.0}) {
        for (const double edge : {-40.0, -29.0, -18.0, 18.0, 29.0, 40.0}) {
            lines.push_back(middle + edge);
            lines.push_back(-middle - edge);
        }
    }
    return lines;
}

/// Round holes between the beads, one row for each x.
std::vector<Opening> drainHoles() {
    std::vector<Opening> holes;
    for (const double x : {1310.0, 1660.0, 2050.0}) {
        for (const double y : {330.0, 530.0}) {
            holes.push_back({{x, y}, {14, 14}, 2});
            holes.push_back({{x, -y}, {14, 14}, 2});
        }
    }
    return holes;
}

/// A hat profile across the floor, its flanges on the floor.
void addCrossMember(const CarBody& body, SheetMetal& metal, const std::string& name, double x) {
    const double foot = body.floorZ(x, 230) + 2.2;
    for (const double nested : {0.0, 1.0}) {
        Polyline hat = hatLine(70 - 16 * nested, 52 - 6 * nested, 22 - 20 * nested);
        for (Vector2& p : hat) p += Vector2(-x, foot + 2.4 * nested);
        metal.beam(name + (nested > 0 ? "_reinforcement" : ""), across(205 + 30 * nested, 590 - 30 * nested),
                   sheetSection(metal.rounded(hat, 7), nested > 0 ? 1.2 : 1.5));
    }
}

void addSeatRail(const CarBody& body, SheetMetal& metal, const std::string& name, double y) {
    const double low = body.floorZ(1500, 330) + 66;
    Pose start;
    start.translation = {1390, y, low};
    Spine spine(start);
    spine.straight(540);
    const Polyline channel{{18, 20}, {18, 0}, {-18, 0}, {-18, 20}, {-10, 20}};
    metal.beam(name, spine, sheetSection(metal.rounded(channel, 3), 2));
}

const Opening kFrontDoor{{1540, 815}, {455, 468}, 7}, kRearDoor{{2472, 822}, {387, 462}, 7};
const Opening kQuarterWindow{{3180, 1080}, {170, 110}, 5};

struct Layer {
    const char* name;
    Vector2 low, high;
    double offset;
    double thickness;
};

/// The reinforcements within pillars and sill, from the skin inwards.
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

/// The inner sheet's openings: doors, window, and rows of lightening holes where there is room.
std::vector<Opening> innerOpenings() {
    std::vector<Opening> openings{kFrontDoor, kRearDoor, kQuarterWindow};
    for (const double z : {470.0, 640.0, 810.0}) openings.push_back({{1000, z}, {24, 34}, 2});
    for (const double x : {3100.0, 3320.0, 3540.0, 3740.0}) openings.push_back({{x, 800}, {42, 42}, 2});
    return openings;
}

}  // namespace

CarBody designCarBody(std::uint64_t seed, double clearance) {
    requireClearance(clearance, kCarBodyLeastClearance, kCarBodyMostClearance);
    Random random(seed);
    CarBody body;
    body.clearance = clearance;
    body.gap = clearance * (1 + kCarBodyEase) + 0.01;  // faces at the gap are plane: only rounding reduces it
    body.beadDepth = random.between(5, 8);
    body.tunnelHeight = random.between(130, 145);
    return body;
}

double CarBody::halfWidth(double x, double z) const {
    const double ends = 90 * squared((x - 2000) / 2000), up = 2.2e-4 * squared(std::max(z - 600, 0.0));
    return 800 - ends - up - 2e-4 * squared(std::max(400 - z, 0.0));
}

double CarBody::floorZ(double x, double y) const {
    const double rear = smoothStep(x, 2360, 2560);
    const double tunnel = tunnelHeight * (1 - smoothStep(std::abs(y), 80, 190)) * (1 - rear);
    const double well = 170 * (1 - smoothStep(std::hypot(x - 3250, y), 210, 330));
    double beads = 0;  // along the car in front, pressed down
    for (const double middle : {280.0, 380.0, 480.0, 580.0}) beads += beadAt(std::abs(y), middle, 18, 22);
    beads *= smoothStep(x, 1180, 1230) * (1 - smoothStep(x, 2250, 2300));
    double cross = 0;  // across the car in the rear
    for (const double middle : {2680.0, 2780.0, 3620.0, 3700.0}) cross += beadAt(x, middle, 16, 22);
    cross *= 1 - smoothStep(std::abs(y), 420, 460);
    return 250 + tunnel + 130 * rear - well - beadDepth * (beads + cross);
}

double CarBody::bonnetZ(double x, double y) const {
    const double along = std::clamp((x - 90) / 760, 0.0, 1.0);
    return 700 + 190 * std::sin(M_PI_2 * along) - 60 * squared(y / 650) + 12 * beadAt(y, 0, 120, 90) * along;
}

double CarBody::sideLowerEdge(double u) const {
    const double fromWheel = std::min(std::abs(u - kFrontWheel), std::abs(u - kRearWheel));
    return 200 + std::sqrt(std::max(0.0, squared(kWheelArch) - squared(fromWheel)));
}

Vector3 CarBody::side(double u, double v) const {
    // v from 200 to 1330 covers the height that the arch leaves.
    const double top = 1330, edge = sideLowerEdge(u);
    const double z = top - (top - v) * (top - edge) / (top - 200);
    const double lean = 0.9 * std::max(0.0, z - 900) * smoothStep(z, 860, 1000);
    const double x = u + lean * (1 - smoothStep(u, 1080, 2000)) * smoothStep(u, 700, 900);
    return {x, halfWidth(x, z), z};
}

Spine CarBody::dashProfile() const {
    return Spine::through({{1118, 0, 266}, {985, 0, 440}, {905, 0, 570}, {890, 0, 905}}, 70,
                          Vector3::UnitY());
}

Vector3 CarBody::dash(double u, double v) const {
    static const Spine profile = dashProfile();
    // The lower edge rises over the tunnel.
    const double edge = 245 * (1 - smoothStep(std::abs(u), 100, 215));
    const double length = edge + v * (1 - edge / profile.length());
    Vector3 point = profile.frameAt(length).translation;
    const double across = beadAt(u, 330, 45, 20) + beadAt(u, -330, 45, 20);
    point.x() -= 8 * squared(u / 620) + beadDepth * across * beadAt(length, 420, 90, 30);
    return {point.x(), u, point.z()};
}

void addFloorStuds(const CarBody& body, SheetMetal& metal, int studs) {
    const Polyline dome = domeOutline(4, 5, metal.detail().segmentsPerQuarter);
    for (int i = 0; i < studs; ++i) {
        // Rows between the underlay and the sills.
        const double side = i % 2 == 0 ? 1 : -1, x = 1190 + 12 * (i / 2 % 90) + 6 * (i / 360 % 2),
                     y = 623 + 9 * (i / 180 % 2);
        metal.turnedPart("stud", dome, {x, side * y, body.floorZ(x, y) + 0.9}, Vector3::UnitZ());
    }
}

void addFloor(const CarBody& body, SheetMetal& metal, Random& random) {
    const auto surface = floorSurface(body);
    const auto patch = [&](const std::string& name, const Vector2& low, const Vector2& high, double thickness,
                           double offset, const std::vector<Opening>& openings = {}) {
        metal.panel(name,
                    {surface, low, high, thickness, offset, openings, {1180, 1230, 2250, 2300}, beadLines()});
    };
    patch("floor_pan", {1130, -kFloorHalf}, {2372, kFloorHalf}, 1, 0, drainHoles());
    patch("tunnel_front", {960, -190}, {1127, 190}, 1, 0);
    patch("tunnel_reinforcement", {1150, -75}, {2340, 75}, 1.2, 3.5);
    patch("tunnel_heat_shield", {1140, -200}, {2350, 200}, 0.8, -9);

    const double wells[][2] = {{1160, 1378}, {1522, 1778}, {1922, 2178}};
    for (int i = 0; i < 3; ++i) {
        const std::string number = std::to_string(i + 1);
        const double from = wells[i][0], to = wells[i][1];
        metal.onBothSides([&] {
            patch("damping_mat_" + number, {from, 205}, {to, 590}, 1.8, 3);
            patch("underlay_" + number, {from + 4, 210}, {to - 4, 586}, 5, 9,
                  {{{(from + to) / 2, 400}, {30, 22}, 4}});
        });
    }
    const auto below = [&](double u, double v) { return Vector3(u, v, 226 + 6 * beadAt(v, 420, 120, 30)); };
    metal.onBothSides([&] {
        const std::vector<Opening> holes{{{1400, 420}, {40, 60}, 2}, {{1900, 420}, {40, 60}, 2}};
        metal.panel("underbody_shield",
                    {below, {1200, 225}, {2300, 610}, 2, 0, holes, {}, {270, 300, 540, 570}});
    });
    metal.onBothSides([&] {
        int number = 0;
        for (const double x : {1450.0, 1850.0, 2250.0}) {
            addCrossMember(body, metal, "cross_member_" + std::to_string(++number), x);
        }
        addSeatRail(body, metal, "seat_rail_inner", 270);
        addSeatRail(body, metal, "seat_rail_outer", 530);
    });

    const int plugs = metal.detail().count(3);
    for (int i = 0; i < plugs; ++i) {
        const double x = 1250 + 1000.0 * (i + 0.5) / plugs, side = i % 2 == 0 ? 1 : -1;
        const Polyline plug = domeOutline(random.between(9, 12), 3, metal.detail().segmentsPerQuarter);
        metal.turnedPart("plug", plug, {x, side * 430, 220}, -Vector3::UnitZ());
    }
}

void addUnderbody(const CarBody& body, SheetMetal& metal) {
    metal.onBothSides([&] {
        const double n = metal.detail().segmentsPerQuarter;
        const auto box = [&](double wide, double high, double wall) {
            return ringSection(roundedRectangle({-wide, -high}, {wide, high}, 12, static_cast<int>(n)),
                               roundedRectangle({-wide + wall, -high + wall}, {wide - wall, high - wall},
                                                12 - wall, static_cast<int>(n)));
        };
        // From the front end under the dash panel and the floor.
        const Spine front = Spine::through(
            {{130, 430, 430}, {800, 430, 430}, {1080, 415, 175}, {1500, 405, 175}, {2300, 410, 175}}, 140);
        metal.beam("longitudinal_front", front, box(32, 42, 2));
        metal.beam("longitudinal_front_reinforcement", front, box(28.4, 38.4, 1.6));
        const Spine rear =
            Spine::through({{2360, 470, 190}, {2480, 470, 190}, {2680, 500, 300}, {3780, 500, 300}}, 120);
        metal.beam("longitudinal_rear", rear, box(30, 35, 2));
        std::vector<Vector3> sill;
        for (double x = 1060; x <= 2665; x += 400) sill.emplace_back(x, body.halfWidth(x, 270) - 62, 272);
        const Spine sillSpine = Spine::through(sill, 2000);
        metal.beam("sill_box", sillSpine, box(38, 52, 1.6));
        metal.beam("sill_box_reinforcement", sillSpine, box(34.4, 48.4, 1.8));
    });
    const double radius[] = {5, 4, 4, 6};
    for (int i = 0; i < 4; ++i) {
        const double y = 228 + 14 * i, z = 205;
        const Line rail{{1000, 215.0 + 10 * i, 380}, {1150, y, z},          {1700, y, z},
                        {1780, y + 12, z - 8},       {2340, y + 12, z - 8}, {2420, y + 30, z - 20}};
        const Spine line = Spine::through(rail, 40);
        metal.beam("line_" + std::to_string(i + 1), line,
                   fullSection(circle(Vector2::Zero(), radius[i], 3 * metal.detail().segmentsPerQuarter)));
    }
    for (const double x : {2620.0, 3640.0}) {
        Polyline hat = hatLine(80, 45, 24);
        for (Vector2& p : hat) p = Vector2(p.x() - x, 364 - p.y());  // below the rear floor
        metal.beam(x < 3000 ? "rear_cross_member_1" : "rear_cross_member_2", across(-440, 440),
                   sheetSection(metal.rounded(hat, 8), 1.4));
    }
}

void addSides(const CarBody& body, SheetMetal& metal, Random& random) {
    const auto surface = [&body](double u, double v) { return body.side(u, v); };
    const double swage = random.between(620, 680), depth = random.between(5, 8);
    // A swage line along the skin, pressed outwards.
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

void addRear(const CarBody& body, SheetMetal& metal, Random& random) {
    const auto floor = [&body](double u, double v) {
        const double y = v * (body.halfWidth(u, 250) - 250) / 540;
        return Vector3(u, y, body.floorZ(u, y));
    };
    const std::vector<double> beads{2642, 2653, 2664, 2696, 2707, 2718, 2742, 2753, 2764, 2796, 2807, 2818,
                                    3582, 3593, 3604, 3636, 3647, 3658, 3662, 3673, 3684, 3716, 3727, 3738};
    metal.panel("rear_floor",
                {floor,
                 {2378, -540},
                 {3790, 540},
                 0.9,
                 0,
                 {{{3250, 0}, {24, 24}, 2}, {{2500, 330}, {20, 20}, 2}, {{2500, -330}, {20, 20}, 2}},
                 beads,
                 {}});
    metal.panel("rear_damping_1", {floor, {2600, -440}, {2880, 440}, 2, 2.5, {}, beads, {}});
    metal.panel("rear_damping_2", {floor, {3150, -90}, {3350, 90}, 2, 2.5});
    metal.panel("rear_carpet", {floor, {2610, -430}, {2870, 430}, 4, 7, {}, beads, {}});

    const auto bulkhead = [](double u, double v) {
        return Vector3(2905 + 0.25 * v + 6 * beadAt(u, 0, 25, 15) + 6 * beadAt(std::abs(u), 300, 60, 15), u,
                       400 + v);
    };
    std::vector<Opening> holes;
    for (const double y : {-450.0, -150.0, 150.0, 450.0}) holes.push_back({{y, 250}, {70, 110}, 5});
    const std::vector<double> lines{-40, -25, 25, 40, 225, 240, 360, 375, -225, -240, -360, -375};
    metal.panel("rear_bulkhead", {bulkhead, {-530, 5}, {530, 480}, 0.8, 0, holes, lines, {}});
    metal.panel("rear_bulkhead_damping", {bulkhead, {-520, 375}, {520, 470}, 2.4, 3, {}, lines, {}});

    const auto shelf = [](double u, double v) {
        return Vector3(u, v, 900 + 8 * beadAt(std::abs(v), 360, 90, 20));
    };
    metal.panel("parcel_shelf",
                {shelf,
                 {3050, -540},
                 {3420, 540},
                 0.8,
                 0,
                 {{{3230, 360}, {80, 80}, 2}, {{3230, -360}, {80, 80}, 2}, {{3230, 0}, {90, 60}, 4}}});
    metal.panel(
        "parcel_shelf_cover",
        {shelf, {3060, -530}, {3410, 530}, 3, 5, {{{3230, 360}, {80, 80}, 2}, {{3230, -360}, {80, 80}, 2}}});

    const auto rear = [](double u, double v) {
        return Vector3(3840 + 25 * (1 - std::pow(u / 600, 2)) + 10 * beadAt(v, 600, 60, 30), u, v);
    };
    metal.panel(
        "rear_panel_outer",
        {rear, {-600, 330}, {600, 820}, 0.8, 0, {{{0, 470}, {150, 50}, 4}}, {}, {510, 540, 660, 690}});
    std::vector<Opening> lamps{{{450, 690}, {90, 70}, 4}, {{-450, 690}, {90, 70}, 4}};
    for (const double y : {-300.0, -100.0, 100.0, 300.0}) lamps.push_back({{y, 440}, {40, 28}, 2});
    metal.panel("rear_panel_inner", {rear, {-560, 340}, {560, 810}, 1, -22, lamps, {}, {510, 540, 660, 690}});
    metal.panel("rear_panel_reinforcement", {rear, {-540, 520}, {540, 600}, 1.2, -26});
    const int studs = metal.detail().count(4);
    for (int i = 0; i < studs; ++i) {
        const double y = -480 + 960.0 * (i + 0.5) / studs;
        metal.turnedPart("lamp_stud",
                         domeOutline(random.between(4, 5), 14, metal.detail().segmentsPerQuarter),
                         {3790, y, 770}, -Vector3::UnitX());
    }
}

}  // namespace clearway::scenes
