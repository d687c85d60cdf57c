// The scene large-environment, version 1: an instrument carrier is brought into a car body.
#include <cmath>

#include "program/scenes/car_body.h"
#include "program/scenes/car_fittings.h"
#include "program/scenes/instrument_carrier.h"
#include "program/scenes/scenes.h"

namespace clearway::scenes {

namespace {

constexpr double kRoofHalf = 600;

/// A hat under the roof that follows its crown, flanges up.
Spine bowSpine(const CarBody& body, double x, double below) {
    std::vector<Vector3> points;
    for (double y = -545; y <= 546; y += 218) points.emplace_back(x, y, body.roofZ(x, y) - below);
    return Spine::through(points, 3000);
}

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

SheetMetal buildCarBody(const CarBody& body, const Detail& detail, Random random, int studs, bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    addFloor(body, metal, random);
    addUnderbody(body, metal);
    addSides(body, metal, random);
    addDash(body, metal, random);
    addMountings(body, metal);
    addFrontEnd(body, metal, random);
    addRoof(body, metal);
    addRear(body, metal, random);
    addFloorStuds(body, metal, studs);
    return metal;
}

constexpr double kThinnestSheet = 0.7;  // mm
constexpr double kRoom = 200;           // mm about the path's positions that planners may use

// Lines are 120 mm apart at fineness 1. The openings that the part passes keep their shape down to 0.4.
constexpr FinenessRange kPartFineness{120, 0.3}, kBodyFineness{120, 0.4};

/// From its place out of the car. Turns are about the vertical line through the carrier's middle.
std::vector<PartState> constructedPath(const CarBody& body) {
    const Vector3 middle(1160, 0, 0);
    const auto at = [&](const Vector3& moved, double turned) {
        PartState state;
        state.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(turned, Vector3::UnitZ()));
        state.position = middle + moved - state.rotation * middle;
        return state;
    };
    const double far = 400, up = std::tan(body.approach);
    std::vector<PartState> path;
    for (const double back : {0.0, 30.0, 100.0, 200.0, far}) path.push_back(at({back, 0, up * back}, 0));
    const Vector3 inside(far, 0, up * far), out(-std::sin(-body.entry), std::cos(body.entry), 0);
    path.push_back(at(inside, -body.entry));
    for (const double length : {500.0, 1000.0, 1500.0})
        path.push_back(at(inside + length * out, -body.entry));
    path.push_back(at(inside + 1700 * out + Vector3(150, 100, 60), 0.3));
    return {path.rbegin(), path.rend()};
}

}  // namespace

GeneratedScene makeLargeEnvironment(const SceneOptions& options) {
    const CarBody body = designCarBody(options.seed, options.clearance);
    const Random partRandom(options.seed ^ 0x1C0A12u), bodyRandom(options.seed ^ 0xB0D7u);
    GeneratedScene scene;
    scene.name = "large-environment";
    scene.part = sheetMetalTo(options.partTriangles, "part-triangles", kPartFineness,
                              [&](const Detail& detail, int studs, bool onlyCount) {
                                  return buildInstrumentCarrier(body, detail, partRandom, studs, onlyCount);
                              });
    scene.environment = sheetMetalTo(options.environmentTriangles, "environment-triangles", kBodyFineness,
                                     [&](const Detail& detail, int studs, bool onlyCount) {
                                         return buildCarBody(body, detail, bodyRandom, studs, onlyCount);
                                     });
    scene.path = constructedPath(body);
    statePathAsProblem(scene, kRoom);
    scene.problem.name = "large-environment v1";
    scene.problem.step = kThinnestSheet / 2;
    return scene;
}

}  // namespace clearway::scenes
