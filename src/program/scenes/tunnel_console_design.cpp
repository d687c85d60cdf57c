#include "program/scenes/tunnel_console_design.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kLeastClearance = 1,
                 kMostClearance = 25;  // mm; beyond, the duct does not fit under the cups

constexpr double kDiagonal = 900;  // mm, of the part's box

/// The gap is this much of the clearance wider than it must be: sampling planners need a little more than
/// nothing.
constexpr double kEase = 0.15;

/// Each sweep's chords may eat this much of the clearance.
constexpr double kChordShare = 0.08;

/// The room beyond the gap, in gaps; in mm no more than there is beside the tunnel, in version 3 no less than the last.
constexpr double kRoom = 2.5, kMostRoom = 28, kLeastRoom3 = 14;

/// The length along s that gives the bent console's box the diagonal kDiagonal.
double lengthFor(const TunnelConsoleDesign& design) {
    double low = 300, high = 1500;
    for (int i = 0; i < 50; ++i) {
        const double length = (low + high) / 2, angle = design.screw.angleAt(length),
                     radius = design.screw.radius;
        const Vector3 sizes(2 * radius * std::sin(angle / 2),
                            2 * design.flangeHalfWidth + std::abs(design.screw.drift) * angle,
                            radius - (radius - design.height) * std::cos(angle / 2));
        (sizes.norm() < kDiagonal ? low : high) = length;
    }
    return low;
}

}  // namespace

TunnelConsoleDesign designTunnelConsole(const SceneOptions& options, int version) {
    const double clearance = options.clearance;
    requireClearance(clearance, kLeastClearance, kMostClearance);
    Random random(options.seed);
    TunnelConsoleDesign design;
    design.clearance = clearance;
    design.screw.radius = random.between(860, 900);
    design.screw.drift = (random.next() % 2 == 0 ? 1 : -1) * random.between(90, 120);
    design.height = random.between(146, 154);
    design.footHalfWidth = random.between(90, 94);
    design.topHalfWidth = design.footHalfWidth - random.between(6, 10);
    design.flangeHalfWidth = design.footHalfWidth + random.between(24, 28);

    design.length = lengthFor(design);

    const double radius = design.screw.radius;
    design.longestStep = std::sqrt(8 * kChordShare * clearance * radius);
    // Chords lie on the axis' side of what they stand for: the part's come nearer to the roof, the floor's
    // nearer to the part, so a gap loses one share, a third more to the path's chords, and what rounding to
    // float takes. The rest is ease.
    const double inSpace = clearance * (1 + kEase + (1 + 1.0 / 3) * kChordShare) + 0.01;
    design.gap = inSpace * design.screw.obliquity(radius - design.height - inSpace);

    if (version >= 2) design.room = std::min(kRoom * design.gap, kMostRoom);
    if (version >= 3) design.room = std::max(design.room, kLeastRoom3);
    design.wallHalfWidth = design.flangeHalfWidth + design.gap + design.room + random.between(12, 20);
    design.roofHeight = design.height + design.gap + design.room + random.between(20, 30);
    design.startAt = 60;
    design.tunnelLength = design.startAt + design.length + 2 * design.gap + design.room + 10;
    design.exitAngle = design.screw.angleAt(design.startAt + design.length + 50);
    return design;
}

Placement rigidAt(const Screw& screw, const Vector3& straight) {
    const Pose X_worldAtStart = poseOf(screw.motion(screw.angleAt(straight.x())));
    const Vector3 at(0, straight.y(), straight.z());
    return [X_worldAtStart, at](const Vector3& p) -> Vector3 { return X_worldAtStart * (p + at); };
}

}  // namespace clearway::scenes
