// Radiator, its fans and their shroud, at the front of the engine bay.
#include <algorithm>
#include <cmath>

#include "program/scenes/cembox_bay.h"
#include "program/scenes/loft.h"
#include "program/scenes/plate.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

constexpr double kHalf = 360, kLow = 165, kHigh = 600;  // of the core
constexpr double kFront = 84, kRear = 108;              // y of the core

/// Upright flat tubes with a folded sheet between each two.
void addCore(Bay& bay) {
    const int tubes = std::clamp(bay.detail.count(9), 9, 60);
    const double pitch = 2 * kHalf / tubes;
    const int folds = 2 * tubes;
    for (int i = 0; i <= tubes; ++i) {
        const double x = pitch * i - kHalf;
        const Polyline outline =
            roundedRectangle({x - 1.5, kFront}, {x + 1.5, kRear}, 1.2, bay.quarterFor(1.2));
        bay.addNumbered("radiator_tube", sweepAlongZ(fullSection(outline), {kLow, kHigh}));
        if (i == tubes) break;
        Polyline fold;
        for (int k = 0; k <= folds; ++k) {
            fold.push_back({x + (k % 2 == 0 ? 2.2 : pitch - 2.2), kLow + 3 + (kHigh - kLow - 6) * k / folds});
        }
        bay.addNumbered("radiator_fin", sweepAlongY(sheetSection(fold, 0.4), {kFront + 2, kRear - 2}));
    }
    for (const double z : {kLow - 46, kHigh + Bay::kSlit}) {
        const bool isUpper = z > kLow;
        bay.add(isUpper ? "radiator_tank_upper" : "radiator_tank_lower",
                bay.box({-kHalf - 12, kFront - 8, z}, {kHalf + 12, kRear + 10, isUpper ? z + 26 : z + 45.5},
                        14, 9));
    }
}

/// A blade is a strip, twisted as it goes outwards.
Piece blade(const Bay& bay, double from, double to) {
    const double width = 0.34 * to;
    const Section strip = sheetSection(
        {{-width / 2, 0}, {-width / 6, 0.05 * width}, {width / 6, 0.05 * width}, {width / 2, 0}}, 2);
    return placed(sweep(strip, stationsBetween(from, to, std::max(4.0, bay.detail.step / 3))),
                  [&](const Vector3& p) {
                      const double twist = 0.9 - 0.4 * (p.x() - from) / (to - from);
                      const Vector2 q = Eigen::Rotation2Dd(twist) * Vector2(p.y(), p.z());
                      return Vector3(p.x(), q.x(), q.y());
                  });
}

void addFan(Bay& bay, double side) {
    const Vector3 at(side * 170, 148, 385);
    const Polyline hub = bay.rounded({{0, -22}, {42, -22}, {46, -18}, {46, 14}, {0, 20}}, {2, 3, 8});
    const std::string name = side > 0 ? "fan_left" : "fan_right";
    bay.add(name + "_hub", placed(bay.turnedRound(hub), standingAt(at, Vector3::UnitY())));
    constexpr int kBlades = 7;
    for (int i = 0; i < kBlades; ++i) {
        bay.addNumbered(
            name + "_blade",
            placed(blade(bay, 47, 136), standingAt(at, Vector3::UnitY(), 2 * M_PI * i / kBlades + 0.3)));
    }
    const Polyline band{{137, -12}, {140, -12}, {140, 12}, {137, 12}};
    bay.add(name + "_band", placed(bay.turnedRing(band), standingAt(at, Vector3::UnitY())));
    const Polyline motor = bay.rounded({{0, 0}, {34, 0}, {34, 30}, {0, 30}}, {3, 8});
    bay.add(name + "_motor",
            placed(bay.turnedRound(motor), standingAt(at + Vector3(0, 21, 0), Vector3::UnitY())));
    for (int i = 0; i < 3; ++i) {
        const double angle = 0.5 + 2 * M_PI * i / 3;
        const Vector3 out(std::cos(angle), 0, std::sin(angle));
        bay.addNumbered(name + "_strut",
                        bay.bar({at + 36 * out + Vector3(0, 34, 0), at + 152 * out + Vector3(0, 30, 0)}, 5));
        bay.addBolt(at + 28 * out + Vector3(0, 51.5, 0), Vector3::UnitY(), 2.5);
    }
}

}  // namespace

void addCooling(Bay& bay) {
    addCore(bay);
    const auto hole = [](std::size_t, std::size_t) { return 146.0; };
    bay.add("fan_shroud",
            sweepAlongY(holedSection({-338, 0, 338}, {225, 545}, hole, bay.segmentsFor(146)), {126, 129}));
    for (const double side : {1.0, -1.0}) {
        addFan(bay, side);
        bay.addBoltRow({side * 330, 129.3, 240}, {side * 330, 129.3, 530}, Vector3::UnitY(), 3, 3);
    }
}

}  // namespace clearway::scenes
