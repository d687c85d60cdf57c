// The floor of the car body: the pan with what is laid on it and hung below it, cross members, seat rails,
// sills' inner boxes, longitudinals and lines.
#include <cmath>

#include "program/scenes/car_body.h"

namespace clearway::scenes {

namespace {

constexpr double kFloorHalf = 650;  // parameter v of the floor's edge

/// The floor as a surface: u is x, v is y but for the floor's narrowing ends.
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

/// A hat across the floor with its flanges on it.
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

}  // namespace

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
        const Spine line = Spine::through({{1000, 215.0 + 10 * i, 380},
                                           {1150, y, z},
                                           {1700, y, z},
                                           {1780, y + 12, z - 8},
                                           {2340, y + 12, z - 8},
                                           {2420, y + 30, z - 20}},
                                          40);
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

}  // namespace clearway::scenes
