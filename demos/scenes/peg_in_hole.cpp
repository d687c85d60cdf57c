#include <algorithm>
#include <cmath>

#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

namespace {

constexpr double kPegLeastClearance = 0.01, kPegMostClearance = 10;  // mm
constexpr double kPegEase = 0.08;  // extra gap beyond the clearance, as a share of it
constexpr std::size_t kLeastTriangles = 300;
constexpr double kPegRadius = 15, kShank = 40, kHeadRadius = 24, kHead = 12;
constexpr double kBlockHalf = 45, kBlock = 50, kBase = 12;
constexpr double kPegSlit = 0.2;  // mm between components
constexpr double kPegRoom = 80;   // mm around the path's positions that planners may use

/// Segments of a round solid with that many triangles; a multiple of 4.
int roundSegmentsFor(std::size_t triangles) {
    return 4 * std::max(3, static_cast<int>(std::sqrt(static_cast<double>(triangles)) / 8));
}

/// The peg, its foot at z = 0, and a drive with the remaining triangles.
Mesh peg(std::size_t triangles) {
    const int n = roundSegmentsFor(triangles);
    const std::size_t round = triangles - triangles / 10;
    constexpr std::size_t kCorners = 8;
    const std::size_t rows = std::max(round / static_cast<std::size_t>(2 * n), kCorners - 1);
    Polyline outline{{0, 0}, {kPegRadius - 3, 0}, {kPegRadius, 3}};
    const std::size_t along = rows + 2 - kCorners;  // rings between chamfer and head
    for (std::size_t i = 1; i <= along; ++i)
        outline.push_back(
            {kPegRadius, 3 + (kShank - 3) * static_cast<double>(i) / static_cast<double>(along + 1)});
    for (const Vector2& p :
         {Vector2(kPegRadius, kShank), Vector2(kHeadRadius, kShank), Vector2(kHeadRadius, kShank + kHead - 2),
          Vector2(kHeadRadius - 2, kShank + kHead), Vector2(0, kShank + kHead)})
        outline.push_back(p);
    Assembly assembly;
    assembly.add("peg", turned(outline, n));
    const double low = kShank + kHead + kPegSlit;
    assembly.add("drive", gridBox(Box(Vector3(-7, -7, low), Vector3(7, 7, low + 14)),
                                  triangles - assembly.triangleCount()));
    return assembly.mesh();
}

/// The block, its top at z = 0, and a base with the remaining triangles.
Mesh block(std::size_t triangles, double gap, const Vector2& at) {
    const int n = roundSegmentsFor(triangles);
    // The sides of the hole's polygon are nearer to its axis than its corners.
    const double radius = (kPegRadius + gap) / std::cos(M_PI / n);
    const std::size_t stations =
        std::max<std::size_t>(2, triangles * 8 / 10 / static_cast<std::size_t>(4 * n));
    std::vector<double> heights;
    for (std::size_t i = 0; i < stations; ++i)
        heights.push_back(-kBlock + kBlock * static_cast<double>(i) / static_cast<double>(stations - 1));
    Assembly assembly;
    assembly.add(
        "block",
        sweepAlongZ(ringSection(squareAround(at, kBlockHalf, n), circle(at, radius, n, M_PI_4)), heights));
    const double top = -kBlock - kPegSlit;
    assembly.add("base", gridBox(Box(Vector3(-150, -110, top - kBase), Vector3(150, 110, top)),
                                 triangles - assembly.triangleCount()));
    return assembly.mesh();
}

}  // namespace

GeneratedScene makePegInHole(const SceneOptions& options) {
    requireClearance(options.clearance, kPegLeastClearance, kPegMostClearance);
    requireTriangles(options.partTriangles, "part-triangles", kLeastTriangles);
    requireTriangles(options.environmentTriangles, "environment-triangles", kLeastTriangles);
    Random random(options.seed);
    const double x = std::floor(random.between(20, 41)), y = std::floor(random.between(-20, 21));
    const double side = random.next() % 2 == 0 ? 1 : -1;
    const double gap = options.clearance * (1 + kPegEase) + 0.001;  // the constant covers rounding to float

    GeneratedScene scene;
    scene.name = "peg-in-hole";
    scene.part = peg(options.partTriangles);
    scene.environment = block(options.environmentTriangles, gap, {x, y});

    const auto state = [](const Vector3& position, const Eigen::Quaterniond& turn) {
        PartState at;
        at.position = position;
        at.rotation = turn;
        return at;
    };
    const double foot = -(kShank - gap);  // the head as far above the block as the shank from the hole
    const Eigen::Quaterniond tilted(Eigen::AngleAxisd(0.9 * side, Vector3(1, 0.4, 0).normalized()));
    scene.path = {state({x - 90, y + 25 * side, 40}, tilted),
                  state({x, y, 16}, Eigen::Quaterniond::Identity()),
                  state({x, y, foot}, Eigen::Quaterniond::Identity())};
    statePathAsProblem(scene, kPegRoom);
    scene.problem.name = "peg-in-hole v1";
    scene.problem.fineness = (kBlockHalf - kPegRadius) / 4;
    return scene;
}

}  // namespace clearway::scenes
