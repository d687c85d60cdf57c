// Hoses, pipes and cables of the engine bay.
#include <algorithm>
#include <cmath>

#include "program/scenes/cembox_bay.h"
#include "program/scenes/loft.h"

namespace clearway::scenes {

namespace {

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

/// A metal pipe with bends, a nut at either end.
void addPipe(Bay& bay, const std::string& name, const Line& points, double radius, double bend) {
    const Line line = bent(points, bend, bay.quarterFor(bend));
    bay.add(name, bay.bar(line, radius));
    const Polyline nut = bay.rounded({{radius + Bay::kSlit, 0},
                                      {2 * radius, 0},
                                      {2 * radius, 4 * radius},
                                      {radius + Bay::kSlit, 4 * radius}},
                                     {0.6, 0.6});
    bay.addNumbered("pipe_nut", placed(ring(nut, 6), standingAt(line.front(), line[1] - line[0])));
    bay.addNumbered("pipe_nut",
                    placed(ring(nut, 6), standingAt(line.back(), line[line.size() - 2] - line.back())));
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
    bay.addNumbered("plug", placed(bay.box({-1.3 * r, -r, 0.5}, {1.3 * r, r, 5 * r}, 0.5 * r, 0.3 * r),
                                   standingAt(end, onward)));
}

void addCoolantHoses(Bay& bay) {
    addHose(bay, "radiator_hose_upper",
            {{-250, 120, 612}, {-250, 165, 605}, {-262, 215, 520}, {-270, 262, 448}, {-270, 300, 424}}, 19);
    addHose(bay, "radiator_hose_lower",
            {{255, 118, 140}, {258, 160, 140}, {235, 205, 170}, {150, 216, 190}, {60, 236, 200}}, 19);
    for (int i = 0; i < 2; ++i) {
        const double x = bay.design.place.x() + 190 + 30 * i;  // to the left of the module
        addHose(bay, i == 0 ? "heater_hose_in" : "heater_hose_out",
                {{x + 30, 848, 470},
                 {x + 28, 800, 474},
                 {x + 22, 690, 500 + 22.0 * i},
                 {x - 60, 600, 470},
                 {100 + 30.0 * i, 540, 440},
                 {90 + 30.0 * i, 505, 400}},
                11);
    }
    addHose(bay, "overflow_hose", {{480, 380, 540}, {440, 330, 560}, {380, 220, 590}, {340, 125, 612}}, 7);
    addHose(bay, "booster_vacuum",
            {{-400, 742, 590}, {-385, 690, 610}, {-320, 620, 590}, {-240, 575, 540}, {-225, 560, 518}}, 8);
}

void addPipes(Bay& bay) {
    const int brakes = std::clamp(bay.detail.count(5), 5, 8);
    for (int i = 0; i < brakes; ++i) {
        const double x = 480 + 13.0 * i, shift = 11.0 * i, y = 826 - 0.5 * shift;
        addPipe(bay, "brake_pipe_" + std::to_string(i + 1),
                {{x, 480, 342},
                 {x, 480, 372 + shift},
                 {x, 560 + shift, 372 + shift},
                 {x, y, 300 - shift},
                 {-360 + 6.0 * i, y, 300 - shift},
                 {-400 + 9.0 * i, y, 430},
                 {-400 + 9.0 * i, 700, 470 + 0.2 * shift}},
                2.4, 14);
    }
    addPipe(bay, "aircon_pipe_high",
            {{-300, 190, 205},
             {-300, 150, 230},
             {-300, 150, 480},
             {-560, 180, 500},
             {-580, 700, 520},
             {-480, 838, 560}},
            8, 35);
    addPipe(bay, "aircon_pipe_low",
            {{-300, 178, 180},
             {-335, 140, 200},
             {-335, 138, 510},
             {-540, 190, 540},
             {-545, 690, 560},
             {-440, 838, 610}},
            11, 40);
    addPipe(bay, "fuel_pipe",
            {{-290, 522, 440}, {-340, 560, 440}, {-340, 800, 400}, {-340, 838, 300}, {-340, 838, 90}}, 4, 25);
    addPipe(bay, "vapour_pipe",
            {{-300, 560, 500}, {-355, 580, 470}, {-355, 790, 420}, {-355, 836, 310}, {-355, 836, 90}}, 4, 25);
}

/// The trunk along the bulkhead and what branches off to the engine; the module's own plugs hang aside.
void addHarness(Bay& bay) {
    const double z = 548;
    Line trunk;
    for (int i = 0; i <= 12; ++i)
        trunk.push_back({-262 + 59.0 * i, 830 + 4 * std::sin(1.3 * i), z + bay.random.between(-5, 5)});
    bay.add("harness_trunk", bay.bar(smooth(trunk, bay.detail.step / 2), 13));
    for (std::size_t i = 1; i < trunk.size(); i += 2) {
        const Polyline tie{{13.6, -4}, {16, -4}, {16, 4}, {13.6, 4}};
        bay.addNumbered("harness_tie",
                        placed(bay.turnedRing(tie), standingAt(trunk[i], trunk[i + 1] - trunk[i - 1])));
    }
    const int branches = bay.detail.count(4);
    for (int i = 0; i < branches; ++i) {
        const double x = -250 + 290 * (i + bay.random.between(0.2, 0.8)) / branches,
                     end = std::clamp(0.42 * x - 70, -300.0, 130.0);
        const double radius = bay.random.between(4, 7), sag = bay.random.between(-25, 25);
        addCable(bay, "cable",
                 {{x, 818, z},
                  {x - 6, 795, z + 5},
                  {0.7 * x + 0.3 * end, 690, 570 + sag},
                  {end, 560, 560 + sag},
                  {end, 480, 512},
                  {end, 440 + sag, 500}},
                 radius);
    }
    const Vector3& place = bay.design.place;
    for (int i = 0; i < 3; ++i) {
        const double x = place.x() + 204 + 26 * i;
        addCable(bay, "module_cable",
                 {{x, 822, z},
                  {x + 4, 800, z + 30},
                  {x + 2, 770, z + 60},
                  {x - 4, 740, z + 45},
                  {x - 6, 725, z + 5.0 * i}},
                 9);
    }
    const int sensors = bay.detail.count(2);
    for (int i = 0; i < sensors; ++i) {
        const double y = 100 + 370 * (i + bay.random.between(0.2, 0.8)) / sensors,
                     radius = bay.random.between(3.5, 5);
        addCable(bay, "wing_cable",
                 {{-640, y, 655},
                  {-600, y + 10, 660},
                  {-560, y + 40, 600},
                  {-500, y + 60, 560},
                  {-480, y + 64, 530}},
                 radius);
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

void addLines(Bay& bay) {
    addCoolantHoses(bay);
    addPipes(bay);
    addHarness(bay);
}

}  // namespace clearway::scenes
