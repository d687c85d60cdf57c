// What stands around the engine: battery, air filter, fluid tanks, fuse box, brake booster and pressure unit.
#include <algorithm>
#include <cmath>

#include "program/scenes/cembox_bay.h"
#include "program/scenes/loft.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

void addBattery(Bay& bay) {
    const Vector3 low(-618, 205, 262), high(-445, 455, 430);
    bay.add("battery_tray", tray(low - Vector3(9, 9, 5), Vector3(high.x() + 9, high.y() + 9, low.z() + 42),
                                 16, 2.5, bay.quarterFor(16)));
    bay.add("battery", bay.box(low, high, 7, 3));
    bay.add("battery_lid", bay.box({low.x() + 4, low.y() + 4, high.z() + Bay::kSlit},
                                   {high.x() - 4, high.y() - 4, high.z() + 14}, 9, 4));
    for (int i = 0; i < 2; ++i) {
        const Vector3 at(high.x() - 38, i == 0 ? low.y() + 40 : high.y() - 40, high.z() + 14.3);
        const Polyline pole = bay.rounded({{0, 0}, {9, 0}, {8, 17}, {0, 17}}, {1, 2});
        bay.addNumbered("battery_pole", placed(bay.turnedRound(pole), standingAt(at, Vector3::UnitZ())));
        const Polyline clamp{{9.6, 2}, {15, 2}, {15, 15}, {9.6, 15}};
        bay.addNumbered("battery_clamp", placed(bay.turnedRing(clamp), standingAt(at, Vector3::UnitZ())));
        bay.addBolt(at + Vector3(20, 0, 12), Vector3::UnitX(), 3);
    }
    const int caps = std::max(3, bay.detail.count(3));
    for (int i = 0; i < caps; ++i) {
        const double y = low.y() + 60 + (high.y() - low.y() - 120) * i / (caps - 1.0);
        const Polyline cap = bay.rounded({{0, 0}, {11, 0}, {11, 4}, {0, 4}}, {0.5, 1.5});
        bay.addNumbered(
            "battery_cap",
            placed(bay.turnedRound(cap), standingAt({low.x() + 50, y, high.z() + 14.3}, Vector3::UnitZ())));
    }
    const double middle = 0.5 * (low.y() + high.y());
    const Polyline strap{{low.x() - 14, 240},           {low.x() - 6, 290},  {low.x() - 6, high.z() + 18},
                         {high.x() + 6, high.z() + 18}, {high.x() + 6, 290}, {high.x() + 14, 240}};
    bay.add("battery_strap", sweepAlongY(bay.sheet(strap, 12, 1.6), {middle - 14, middle + 14}));
}

/// Two halves with clips, and a bellows that leads to the throttle.
void addAirFilter(Bay& bay) {
    const Vector3 low(290, 165, 330), high(540, 350, 505);
    const double joint = 430;
    bay.add("air_filter_lower", bay.box(low, {high.x(), high.y(), joint - Bay::kSlit}, 30, 16));
    bay.add("air_filter_seal",
            bay.box(low + Vector3(-7, -7, joint - low.z()), {high.x() + 7, high.y() + 7, joint + 6}, 34, 2));
    bay.add("air_filter_upper", bay.box({low.x(), low.y(), joint + 6.3}, high, 30, 22));
    const int ribs = bay.detail.count(5);
    for (int i = 0; i < ribs; ++i) {
        const double x = low.x() + 40 + (high.x() - low.x() - 80) * (i + 0.5) / ribs;
        const Polyline over =
            bay.rounded({{x + 1.6, 0}, {x + 1.6, 6}, {x - 1.6, 6}, {x - 1.6, 0}}, {1.4, 1.4});
        Polyline loop;
        for (const Vector2& p : over) loop.push_back({p.x(), high.z() + Bay::kSlit + p.y()});
        bay.addNumbered("air_filter_rib", sweepAlongY(fullSection(loop), {low.y() + 30, high.y() - 30}));
    }
    for (int i = 0; i < 4; ++i) {
        const double x = i % 2 == 0 ? low.x() + 60 : high.x() - 60, y = i < 2 ? low.y() - 11 : high.y() + 11;
        const double out = i < 2 ? -1 : 1;
        const Polyline clip{
            {y - 8 * out, joint - 22}, {y, joint - 12}, {y, joint + 14}, {y - 9 * out, joint + 20}};
        bay.addNumbered("air_filter_clip", sweep(bay.sheet(clip, 4, 1), {x - 8, x + 8}));
    }
    const Line duct = smooth({{288, 300, 462},
                              {240, 330, 520},
                              {190, 420, 560},
                              {150, 520, 530},
                              {144, 536, 502},
                              {136, 536, 500}},
                             bay.detail.step / 6);
    const double wave = 14 / std::sqrt(bay.detail.richness);
    bay.add("air_duct", bay.wavyBar(duct, 36, [wave](double along) {
        return 36 + 3 * std::sin(2 * M_PI * along / wave);
    }));
    const Line snorkel =
        smooth({{420, 158, 380}, {400, 140, 420}, {330, 135, 560}, {250, 128, 622}}, bay.detail.step / 2);
    bay.add("air_snorkel", bay.tube(snorkel, 30, 2.5));
}

void addTank(Bay& bay, const std::string& name, const Vector3& low, const Vector3& high, double capRadius) {
    const double seam = 0.5 * (low.z() + high.z());
    bay.add(name + "_lower", bay.box(low, {high.x(), high.y(), seam - 1.3}, 22, 14));
    bay.add(name + "_seam", bay.box(low + Vector3(-4, -4, seam - 1 - low.z()),
                                    {high.x() + 4, high.y() + 4, seam + 1}, 24, 0.5));
    bay.add(name + "_upper", bay.box({low.x(), low.y(), seam + 1.3}, high, 22, 18));
    const Vector3 neck(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), high.z() + Bay::kSlit);
    const Polyline cap = bay.rounded(
        {{0, 0}, {0.8 * capRadius, 0}, {0.8 * capRadius, 14}, {capRadius, 14}, {capRadius, 32}, {0, 34}},
        {0, 0, 1, 4});
    bay.add(name + "_cap", placed(bay.turnedRound(cap), standingAt(neck, Vector3::UnitZ())));
    const int grips = bay.detail.count(8);
    for (int i = 0; i < grips; ++i) {
        const Piece grip = bay.box({capRadius + 0.2, -1, 16}, {capRadius + 1.8, 1, 29}, 0.6, 0.3);
        bay.addNumbered(name + "_grip",
                        placed(grip, standingAt(neck, Vector3::UnitZ(), 2 * M_PI * i / grips)));
    }
    bay.addBolt({high.x() + 9, neck.y(), seam}, Vector3::UnitX(), 3);
}

void addBrakes(Bay& bay) {
    const Vector3 booster(-400, 842, 520);
    const Polyline can = bay.rounded({{0, 0},
                                      {112, 0},
                                      {120, 26},
                                      {120, 40},
                                      {125, 40},
                                      {125, 46},
                                      {118, 46},
                                      {84, 92},
                                      {30, 98},
                                      {0, 98}},
                                     {8, 8, 0, 1, 1, 0, 18, 8});
    bay.add("brake_booster", placed(bay.turnedRound(can), standingAt(booster, -Vector3::UnitY())));
    const Polyline master =
        bay.rounded({{0, 0}, {26, 0}, {26, 10}, {19, 12}, {19, 140}, {0, 146}}, {2, 2, 2, 5});
    bay.add("brake_master",
            placed(bay.turnedRound(master), standingAt(booster - Vector3(0, 98.4, 0), -Vector3::UnitY())));
    addTank(bay, "brake_reservoir", {-438, 610, 546}, {-362, 730, 600}, 24);
    const Vector3 low(470, 440, 250), high(590, 540, 340);
    bay.add("pressure_unit", bay.box(low, high, 8, 3));
    bay.add("pressure_unit_cover", bay.box({low.x() + 6, low.y() - 34, low.z() + 8},
                                           {high.x() - 6, low.y() - Bay::kSlit, high.z() - 8}, 8, 5));
    const Polyline motor = bay.rounded({{0, 0}, {36, 0}, {36, 62}, {0, 62}}, {3, 8});
    bay.add("pressure_unit_motor",
            placed(bay.turnedRound(motor), standingAt({530, 540.4, 296}, Vector3::UnitY())));
    const int valves = bay.detail.count(4);
    for (int i = 0; i < valves; ++i) {
        const Polyline valve =
            bay.rounded({{0, 0}, {8, 0}, {8, 12}, {5, 16}, {5, 26}, {0, 26}}, {1, 2, 2, 1});
        const double x = low.x() + 15 + 90.0 * (i + 0.5) / valves;
        bay.addNumbered("pressure_valve",
                        placed(bay.turnedRound(valve),
                               standingAt({x, low.y() + 26, high.z() + Bay::kSlit}, Vector3::UnitZ())));
    }
}

/// Open, its fuses and relays in rows.
void addFuseBox(Bay& bay) {
    const Vector3 low(-625, 470, 470), high(-500, 512, 535);
    const Vector3 far(high.x(), low.y() + 165, high.z());
    bay.add("fuse_box", tray({low.x(), low.y() - 70, low.z()}, {far.x(), far.y() - 130, far.z()}, 12, 3,
                             bay.quarterFor(12)));
    const int columns = std::clamp(bay.detail.count(4), 4, 14), rows = std::clamp(bay.detail.count(3), 3, 8);
    const double width = (far.x() - low.x() - 24) / columns, depth = 80.0 / rows;
    for (int i = 0; i < columns * rows; ++i) {
        const Vector3 at(low.x() + 12 + width * (i % columns), low.y() - 56 + depth * (i / columns),
                         low.z() + 3.3);
        const double tall = bay.random.between(14, 40);
        const Piece fuse = bay.box(at + Vector3(0.1 * width, 0.15 * depth, 0),
                                   at + Vector3(0.9 * width, 0.85 * depth, tall), 2, 1);
        bay.addNumbered(tall > 30 ? "relay" : "fuse", fuse);
    }
}

}  // namespace

void addAggregates(Bay& bay) {
    addBattery(bay);
    addAirFilter(bay);
    addTank(bay, "coolant_tank", {470, 385, 520}, {615, 470, 640}, 30);
    addTank(bay, "washer_tank", {-625, 60, 330}, {-500, 165, 470}, 26);
    addBrakes(bay);
    addFuseBox(bay);
}

}  // namespace clearway::scenes
