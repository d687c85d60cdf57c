// Roof and rear of the car body: skin, bows and lining in layers, headers, rear floor with its well, parcel
// shelf, bulkhead and rear panel.
#include <cmath>

#include "program/scenes/car_body.h"

namespace clearway::scenes {

namespace {

constexpr double kRoofHalf = 600;

/// A hat under the roof that follows its crown, flanges up.
Spine bowSpine(const CarBody& body, double x, double below) {
    std::vector<Vector3> points;
    for (double y = -545; y <= 546; y += 218) points.emplace_back(x, y, body.roofZ(x, y) - below);
    return Spine::through(points, 3000);
}

}  // namespace

void addRoof(const CarBody& body, SheetMetal& metal) {
    const auto surface = [&body](double u, double v) {
        const double swage = 5 * beadAt(std::abs(v), 330, 30, 25);
        return Vector3(u, v, body.roofZ(u, v) - swage);
    };
    const auto plain = [&body](double u, double v) { return Vector3(u, v, body.roofZ(u, v)); };
    const std::vector<double> swages{275, 300, 360, 385, -275, -300, -360, -385};
    metal.panel("roof_skin", {surface, {1470, -kRoofHalf}, {2960, kRoofHalf}, 0.8, 0, {}, {}, swages});
    metal.panel("front_header",
                {plain,
                 {1480, -580},
                 {1560, 580},
                 1,
                 -12,
                 {{{1520, 0}, {20, 60}, 4}, {{1520, 300}, {18, 18}, 2}, {{1520, -300}, {18, 18}, 2}}});
    metal.panel("front_header_inner", {plain, {1485, -560}, {1555, 560}, 1.2, -17});
    metal.panel("rear_header", {plain, {2880, -570}, {2950, 570}, 1, -12});
    metal.panel("rear_header_inner", {plain, {2885, -550}, {2945, 550}, 1.2, -17});
    const double bows[] = {1690, 1950, 2210, 2470, 2730};
    for (int i = 0; i < 5; ++i) {
        Polyline hat = hatLine(44, 22, 16);
        for (Vector2& p : hat) p.y() = -p.y();
        metal.beam("roof_bow_" + std::to_string(i + 1), bowSpine(body, bows[i], 10),
                   sheetSection(metal.rounded(hat, 5), 1));
        if (i == 4) break;
        metal.panel("roof_damping_" + std::to_string(i + 1),
                    {surface, {bows[i] + 60, -520}, {bows[i + 1] - 60, 520}, 2, -2.5, {}, {}, swages});
    }
    metal.panel("headliner", {plain,
                              {1500, -540},
                              {2930, 540},
                              4,
                              -48,
                              {{{1600, 0}, {45, 70}, 4},
                               {{1800, 430}, {40, 25}, 3},
                               {{1800, -430}, {40, 25}, 3},
                               {{2500, 430}, {40, 25}, 3},
                               {{2500, -430}, {40, 25}, 3}},
                              {},
                              {}});
    metal.onBothSides([&] {
        std::vector<Vector3> rail;
        for (double x = 1500; x <= 2910; x += 235) rail.emplace_back(x, 572, body.roofZ(x, 572) - 34);
        const int n = metal.detail().segmentsPerQuarter;
        metal.beam("roof_rail", Spine::through(rail, 3000),
                   ringSection(roundedRectangle({-16, -14}, {16, 14}, 6, n),
                               roundedRectangle({-14, -12}, {14, 12}, 4, n)));
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
