// The equipment around the engine, and its hoses, pipes and cables.
#include "demos/scenes/cembox_bay.h"

#include <algorithm>
#include <cmath>

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
        bay.addNumbered("battery_pole", bay.turnedRound(pole), at, Vector3::UnitZ());
        const Polyline clamp{{9.6, 2}, {15, 2}, {15, 15}, {9.6, 15}};
        bay.addNumbered("battery_clamp", bay.turnedRing(clamp), at, Vector3::UnitZ());
        bay.addBolt(at + Vector3(20, 0, 12), Vector3::UnitX(), 3);
    }
    const int caps = std::max(3, bay.detail.count(3));
    for (int i = 0; i < caps; ++i) {
        const double y = low.y() + 60 + (high.y() - low.y() - 120) * i / (caps - 1.0);
        const Polyline cap = bay.rounded({{0, 0}, {11, 0}, {11, 4}, {0, 4}}, {0.5, 1.5});
        bay.addNumbered("battery_cap", bay.turnedRound(cap), {low.x() + 50, y, high.z() + 14.3},
                        Vector3::UnitZ());
    }
    const double middle = 0.5 * (low.y() + high.y());
    const Polyline strap{{low.x() - 14, 240},           {low.x() - 6, 290},  {low.x() - 6, high.z() + 18},
                         {high.x() + 6, high.z() + 18}, {high.x() + 6, 290}, {high.x() + 14, 240}};
    bay.add("battery_strap", sweepAlongY(bay.sheet(strap, 12, 1.6), {middle - 14, middle + 14}));
}

/// The air filter: two halves with clips, and a bellows that leads to the throttle.
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
    const Line bends{{288, 300, 462}, {240, 330, 520}, {190, 420, 560},
                     {150, 520, 530}, {144, 536, 502}, {136, 536, 500}};
    const Line duct = smooth(bends, bay.detail.step / 6);
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
    bay.add(name + "_cap", bay.turnedRound(cap), neck, Vector3::UnitZ());
    const int grips = bay.detail.count(8);
    for (int i = 0; i < grips; ++i) {
        const Piece grip = bay.box({capRadius + 0.2, -1, 16}, {capRadius + 1.8, 1, 29}, 0.6, 0.3);
        bay.addNumbered(name + "_grip", grip, neck, Vector3::UnitZ(), 2 * M_PI * i / grips);
    }
    bay.addBolt({high.x() + 9, neck.y(), seam}, Vector3::UnitX(), 3);
}

void addBrakes(Bay& bay) {
    const Vector3 booster(-400, 842, 520);
    const Polyline corners{{0, 0},    {112, 0},  {120, 26}, {120, 40}, {125, 40},
                           {125, 46}, {118, 46}, {84, 92},  {30, 98},  {0, 98}};
    const Polyline can = bay.rounded(corners, {8, 8, 0, 1, 1, 0, 18, 8});
    bay.add("brake_booster", bay.turnedRound(can), booster, -Vector3::UnitY());
    const Polyline master =
        bay.rounded({{0, 0}, {26, 0}, {26, 10}, {19, 12}, {19, 140}, {0, 146}}, {2, 2, 2, 5});
    bay.add("brake_master", bay.turnedRound(master), booster - Vector3(0, 98.4, 0), -Vector3::UnitY());
    addTank(bay, "brake_reservoir", {-438, 610, 546}, {-362, 730, 600}, 24);
    const Vector3 low(470, 440, 250), high(590, 540, 340);
    bay.add("pressure_unit", bay.box(low, high, 8, 3));
    bay.add("pressure_unit_cover", bay.box({low.x() + 6, low.y() - 34, low.z() + 8},
                                           {high.x() - 6, low.y() - Bay::kSlit, high.z() - 8}, 8, 5));
    const Polyline motor = bay.rounded({{0, 0}, {36, 0}, {36, 62}, {0, 62}}, {3, 8});
    bay.add("pressure_unit_motor", bay.turnedRound(motor), {530, 540.4, 296}, Vector3::UnitY());
    const int valves = bay.detail.count(4);
    for (int i = 0; i < valves; ++i) {
        const Polyline valve =
            bay.rounded({{0, 0}, {8, 0}, {8, 12}, {5, 16}, {5, 26}, {0, 26}}, {1, 2, 2, 1});
        const double x = low.x() + 15 + 90.0 * (i + 0.5) / valves;
        bay.addNumbered("pressure_valve", bay.turnedRound(valve), {x, low.y() + 26, high.z() + Bay::kSlit},
                        Vector3::UnitZ());
    }
}

/// An open fuse box with fuses and relays in rows.
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

/// A rubber hose through the points with a clamp near either end.
void addHose(Bay& bay, const std::string& name, const Line& points, double radius) {
    const Line line = smooth(points, bay.detail.step / 2);
    bay.add(name, bay.tube(line, radius, 3));
    const Polyline band{
        {radius + Bay::kSlit, -5}, {radius + 1.8, -5}, {radius + 1.8, 5}, {radius + Bay::kSlit, 5}};
    for (const bool isFirst : {true, false}) {
        const Vector3 end = isFirst ? line.front() : line.back();
        const Vector3 inwards =
            (isFirst ? Vector3(line[1] - end) : Vector3(line[line.size() - 2] - end)).normalized();
        const Placement there = standingAt(end + 10 * inwards, inwards, bay.random.between(0, 2 * M_PI));
        bay.addNumbered("hose_clamp", placed(bay.turnedRing(band), there));
        const Piece lock = bay.box({radius + 2, -6, -5.5}, {radius + 9, 6, 5.5}, 3, 1);
        bay.addNumbered("clamp_lock", placed(lock, there));
    }
}

/// A metal pipe with bends and a nut at either end.
void addPipe(Bay& bay, const std::string& name, const Line& points, double radius, double bend) {
    const Line line = bent(points, bend, bay.quarterFor(bend));
    bay.add(name, bay.bar(line, radius));
    const Polyline nut = bay.rounded({{radius + Bay::kSlit, 0},
                                      {2 * radius, 0},
                                      {2 * radius, 4 * radius},
                                      {radius + Bay::kSlit, 4 * radius}},
                                     {0.6, 0.6});
    bay.addNumbered("pipe_nut", ring(nut, 6), line.front(), line[1] - line[0]);
    bay.addNumbered("pipe_nut", ring(nut, 6), line.back(), line[line.size() - 2] - line.back());
}

/// A cable in a corrugated conduit with a plug at its end.
void addCable(Bay& bay, const std::string& stem, const Line& points, double radius) {
    const Line line = smooth(points, bay.detail.step / 8);
    const double wave = 9 / std::sqrt(bay.detail.richness);
    bay.addNumbered(stem, bay.wavyBar(line, 0.7 * radius, [=](double along) {
        return radius * (1 + 0.12 * std::cos(2 * M_PI * along / wave));
    }));
    const Vector3 end = line.back(), onward = end - line[line.size() - 2];
    const double r = 1.6 * radius;
    bay.addNumbered("plug", bay.box({-1.3 * r, -r, 0.5}, {1.3 * r, r, 5 * r}, 0.5 * r, 0.3 * r), end, onward);
}

void addCoolantHoses(Bay& bay) {
    addHose(bay, "radiator_hose_upper",
            {{-250, 120, 612}, {-250, 165, 605}, {-262, 215, 520}, {-270, 262, 448}, {-270, 300, 424}}, 19);
    addHose(bay, "radiator_hose_lower",
            {{255, 118, 140}, {258, 160, 140}, {235, 205, 170}, {150, 216, 190}, {60, 236, 200}}, 19);
    for (int i = 0; i < 2; ++i) {
        const double x = bay.design.place.x() + 190 + 30 * i;  // to the left of the module
        const Line hose{{x + 30, 848, 470}, {x + 28, 800, 474},         {x + 22, 690, 500 + 22.0 * i},
                        {x - 60, 600, 470}, {100 + 30.0 * i, 540, 440}, {90 + 30.0 * i, 505, 400}};
        addHose(bay, i == 0 ? "heater_hose_in" : "heater_hose_out", hose, 11);
    }
    addHose(bay, "overflow_hose", {{480, 380, 540}, {440, 330, 560}, {380, 220, 590}, {340, 125, 612}}, 7);
    addHose(bay, "booster_vacuum",
            {{-400, 742, 590}, {-385, 690, 610}, {-320, 620, 590}, {-240, 575, 540}, {-225, 560, 518}}, 8);
}

void addPipes(Bay& bay) {
    const int brakes = std::clamp(bay.detail.count(5), 5, 8);
    for (int i = 0; i < brakes; ++i) {
        const double x = 480 + 13.0 * i, shift = 11.0 * i, y = 826 - 0.5 * shift;
        const Line pipe{{x, 480, 342},
                        {x, 480, 372 + shift},
                        {x, 560 + shift, 372 + shift},
                        {x, y, 300 - shift},
                        {-360 + 6.0 * i, y, 300 - shift},
                        {-400 + 9.0 * i, y, 430},
                        {-400 + 9.0 * i, 700, 470 + 0.2 * shift}};
        addPipe(bay, "brake_pipe_" + std::to_string(i + 1), pipe, 2.4, 14);
    }
    const Line high{{-300, 190, 205}, {-300, 150, 230}, {-300, 150, 480},
                    {-560, 180, 500}, {-580, 700, 520}, {-480, 838, 560}};
    addPipe(bay, "aircon_pipe_high", high, 8, 35);
    const Line low{{-300, 178, 180}, {-335, 140, 200}, {-335, 138, 510},
                   {-540, 190, 540}, {-545, 690, 560}, {-440, 838, 610}};
    addPipe(bay, "aircon_pipe_low", low, 11, 40);
    addPipe(bay, "fuel_pipe",
            {{-290, 522, 440}, {-340, 560, 440}, {-340, 800, 400}, {-340, 838, 300}, {-340, 838, 90}}, 4, 25);
    addPipe(bay, "vapour_pipe",
            {{-300, 560, 500}, {-355, 580, 470}, {-355, 790, 420}, {-355, 836, 310}, {-355, 836, 90}}, 4, 25);
}

/// The harness: a trunk along the bulkhead, branches to the engine, and the module's own cables, which hang
/// aside.
void addHarness(Bay& bay) {
    const double z = 548;
    Line trunk;
    for (int i = 0; i <= 12; ++i)
        trunk.push_back({-262 + 59.0 * i, 830 + 4 * std::sin(1.3 * i), z + bay.random.between(-5, 5)});
    bay.add("harness_trunk", bay.bar(smooth(trunk, bay.detail.step / 2), 13));
    for (std::size_t i = 1; i < trunk.size(); i += 2) {
        const Polyline tie{{13.6, -4}, {16, -4}, {16, 4}, {13.6, 4}};
        bay.addNumbered("harness_tie", bay.turnedRing(tie), trunk[i], trunk[i + 1] - trunk[i - 1]);
    }
    const int branches = bay.detail.count(4);
    for (int i = 0; i < branches; ++i) {
        const double x = -250 + 290 * (i + bay.random.between(0.2, 0.8)) / branches,
                     end = std::clamp(0.42 * x - 70, -300.0, 130.0);
        const double radius = bay.random.between(4, 7), sag = bay.random.between(-25, 25);
        const Line points{{x, 818, z},           {x - 6, 795, z + 5}, {0.7 * x + 0.3 * end, 690, 570 + sag},
                          {end, 560, 560 + sag}, {end, 480, 512},     {end, 440 + sag, 500}};
        addCable(bay, "cable", points, radius);
    }
    const Vector3& place = bay.design.place;
    for (int i = 0; i < 3; ++i) {
        const double x = place.x() + 204 + 26 * i;
        const Line points{{x, 822, z},
                          {x + 4, 800, z + 30},
                          {x + 2, 770, z + 60},
                          {x - 4, 740, z + 45},
                          {x - 6, 725, z + 5.0 * i}};
        addCable(bay, "module_cable", points, 9);
    }
    const int sensors = bay.detail.count(2);
    for (int i = 0; i < sensors; ++i) {
        const double y = 100 + 370 * (i + bay.random.between(0.2, 0.8)) / sensors,
                     radius = bay.random.between(3.5, 5);
        const Line right{{-640, y, 655},
                         {-600, y + 10, 660},
                         {-560, y + 40, 600},
                         {-500, y + 60, 560},
                         {-480, y + 64, 530}};
        addCable(bay, "wing_cable", right, radius);
        addCable(
            bay, "wing_cable",
            {{642, y, 652}, {610, y - 10, 660}, {590, y - 30, 610}, {520, y - 50, 560}, {505, y - 54, 540}},
            radius);
    }
    addCable(bay, "battery_cable",
             {{-460, 250, 452}, {-420, 250, 460}, {-390, 280, 400}, {-372, 300, 330}, {-350, 330, 300}}, 8);
    addCable(bay, "starter_cable",
             {{-460, 410, 452}, {-430, 400, 470}, {-200, 210, 480}, {60, 175, 300}, {40, 185, 190}}, 8);
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

void addLines(Bay& bay) {
    addCoolantHoses(bay);
    addPipes(bay);
    addHarness(bay);
}

}  // namespace clearway::scenes
