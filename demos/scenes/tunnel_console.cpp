#include "demos/scenes/tunnel_console.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/console.h"
#include "demos/scenes/random.h"
#include "demos/scenes/tunnel_body.h"

namespace clearway::scenes {

namespace {

constexpr double kTunnelLeastClearance = 1,
                 kTunnelMostClearance = 25;  // mm; with more, the duct does not fit under the cups

constexpr double kDiagonal = 900;  // mm; of the part's bounding box

/// Extra gap beyond the clearance, as a share of it: sampling planners need some room.
constexpr double kTunnelEase = 0.15;

/// The share of the clearance that each sweep's chords may use up.
constexpr double kChordShare = 0.08;

/// The room beyond the gap, in gaps, and its limits in mm; more does not fit beside the tunnel.
constexpr double kTunnelRoom = 2.5, kLeastRoom = 14, kMostRoom = 28;

/// The length along s at which the bent console's bounding box has the diagonal kDiagonal.
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

/// Half of a rib's opening: from the floor to the hat's top on the right, with the radii of its three
/// corners.
struct HalfOpening {
    Polyline line;
    std::vector<double> radii;
};

HalfOpening halfOpening(const TunnelConsoleDesign& design, double beside, double over, double floor) {
    const double flange = design.flangeHalfWidth + beside, ledge = design.shellThickness + beside;
    // Three quarters of the part's own rounding plus the gap, which leaves room for the chords of the fillet.
    // The ledge's nose is rounded more than the part's foot fillet plus the gap needs.
    const double nose = std::max(design.footRadius - beside, 0.0) + 3;
    return {{{flange, floor},
             {flange, ledge},
             {design.footHalfWidth + beside, ledge},
             {design.topHalfWidth + beside, design.height + over}},
            {0.75 * beside, nose, 0.75 * (design.topRadius + std::min(beside, over))}};
}

constexpr double kPlanningRoom = 120;  // mm around the path's positions that planners may use

/// The screw motion out of the tunnel in chords, then one motion through the free room.
std::vector<PartState> constructedConsolePath(const TunnelConsoleDesign& design) {
    const double start = design.screw.angleAt(design.startAt + design.length / 2);
    // The chord of the part's origin, which is about the radius from the axis, keeps to a third of a sweep's
    // share.
    const int chords = static_cast<int>(
        std::ceil(design.exitAngle * design.screw.radius / (design.longestStep / std::sqrt(3.0))));
    std::vector<PartState> path;
    for (int i = 0; i <= chords; ++i) {
        path.push_back(design.screw.motion(start - design.exitAngle * i / chords));
    }
    return path;
}

/// The goal: away from the mouth, up, to the side opposite to the screw's drift, and turned about all axes so
/// that the rear end sinks.
PartState outside(const PartState& exit, double drift) {
    const double side = drift < 0 ? 1 : -1;
    const Eigen::Quaterniond turn = Eigen::AngleAxisd(-0.35, Vector3::UnitY()) *
                                    Eigen::AngleAxisd(0.3 * side, Vector3::UnitX()) *
                                    Eigen::AngleAxisd(0.3 * side, Vector3::UnitZ());
    PartState goal = exit;
    goal.rotation = turn * exit.rotation;
    goal.position += Vector3(-110, 40 * side, 160);
    return goal;
}

}  // namespace

TunnelConsoleDesign designTunnelConsole(const SceneOptions& options) {
    const double clearance = options.clearance;
    requireClearance(clearance, kTunnelLeastClearance, kTunnelMostClearance);
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
    // Chords lie on the axis' side of their curves: the part's come nearer to the roof, the floor's nearer to
    // the part. So a gap loses one share, another third to the path's chords, and a little to rounding to
    // float. The rest is ease.
    const double inSpace = clearance * (1 + kTunnelEase + (1 + 1.0 / 3) * kChordShare) + 0.01;
    design.gap = inSpace * design.screw.obliquity(radius - design.height - inSpace);

    design.room = std::clamp(kTunnelRoom * design.gap, kLeastRoom, kMostRoom);
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

Polyline ribOpening(const TunnelConsoleDesign& design, const RibGaps& gaps, double floor,
                    int segmentsPerQuarter) {
    const auto [right, left, over] = gaps.sides;
    HalfOpening opening = halfOpening(design, right, over, floor);
    const HalfOpening other = halfOpening(design, left, over, floor);
    for (std::size_t i = other.line.size(); i-- > 0;)
        opening.line.push_back({-other.line[i].x(), other.line[i].y()});
    opening.radii.insert(opening.radii.end(), other.radii.rbegin(), other.radii.rend());
    return filleted(opening.line, opening.radii, segmentsPerQuarter);
}

GeneratedScene makeTunnelConsole3(const SceneOptions& options) {
    const TunnelConsoleDesign design = designTunnelConsole(options);
    const Random partRandom(options.seed ^ 0xC0501Eu), tunnelRandom(options.seed ^ 0x7A22E1u);
    const FinenessRange range{design.longestStep};
    GeneratedScene scene;
    scene.name = "tunnel-console";
    scene.part = sheetMetalTo(options.partTriangles, "part-triangles", range,
                              [&](const Detail& detail, int studs, bool onlyCount) {
                                  return buildConsoleBody(design, detail, partRandom, studs, onlyCount);
                              });
    scene.environment =
        sheetMetalTo(options.environmentTriangles, "environment-triangles", range,
                     [&](const Detail& detail, int studs, bool onlyCount) {
                         return buildTunnelBody(design, detail, tunnelRandom, studs, onlyCount);
                     });
    scene.path = constructedConsolePath(design);
    centrePart(scene);
    scene.path.push_back(outside(scene.path.back(), design.screw.drift));

    setProblem(scene, kPlanningRoom);
    scene.problem.name = "tunnel-console v3";
    scene.problem.fineness = design.thinnestSheet() / 2;
    return scene;
}

}  // namespace clearway::scenes
