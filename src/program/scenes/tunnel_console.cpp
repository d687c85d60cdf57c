#include "program/scenes/tunnel_console.h"

#include <algorithm>
#include <cmath>

#include "program/scenes/path_to_problem.h"
#include "program/scenes/tunnel_body.h"
#include "program/scenes/tunnel_console_design.h"

namespace clearway::scenes {

namespace {

constexpr double kRoom = 120;  // mm about the path's positions that planners may use

/// The screw motion out of the tunnel in chords, then one motion through the free room.
std::vector<PartState> constructedPath(const TunnelConsoleDesign& design) {
    const double start = design.screw.angleAt(design.startAt + design.length / 2);
    // The chord of the part's origin, about the radius from the axis, keeps to a third of a sweep's share.
    const int chords = static_cast<int>(
        std::ceil(design.exitAngle * design.screw.radius / (design.longestStep / std::sqrt(3.0))));
    std::vector<PartState> path;
    for (int i = 0; i <= chords; ++i) {
        path.push_back(design.screw.motion(start - design.exitAngle * i / chords));
    }
    return path;
}

/// Away from the mouth, up, to the side to which the screw drifts, and turned about all axes: the rear end
/// sinks.
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

/// A mesh that counts its triangles before it is made. build(detail, studs, onlyCount): a SheetMetal.
template <class Build>
Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const Build& build) {
    const auto countAt = [&](const Detail& detail, int studs) {
        return build(detail, studs, true).triangleCount();
    };
    const Detail detail =
        finestDetail(triangles, option, range, [&](const Detail& tried) { return countAt(tried, 0); });
    const std::size_t without = countAt(detail, 0), stud = countAt(detail, 1) - without;
    return build(detail, static_cast<int>((triangles - without) / stud), false).assembly().mesh();
}

/// Versions 1 and 2 share their build.
void buildMeshes(GeneratedScene& scene, const TunnelConsoleDesign& design, int version,
                 const SceneOptions& options) {
    const Random partRandom(options.seed ^ 0xC0501Eu), tunnelRandom(options.seed ^ 0x7A22E1u);
    const FinenessRange range{design.longestStep};
    const char *const part = "part-triangles", *const environment = "environment-triangles";
    if (version >= 3) {
        scene.part = sheetMetalTo(options.partTriangles, part, range,
                                  [&](const Detail& detail, int studs, bool onlyCount) {
                                      return buildConsoleBody(design, detail, partRandom, studs, onlyCount);
                                  });
        scene.environment =
            sheetMetalTo(options.environmentTriangles, environment, range,
                         [&](const Detail& detail, int studs, bool onlyCount) {
                             return buildTunnelBody(design, detail, tunnelRandom, studs, onlyCount);
                         });
        return;
    }
    scene.part = buildTo(options.partTriangles, part, range, [&](const Detail& detail, int studs) {
        return buildConsole(design, detail, partRandom, studs);
    });
    scene.environment = buildTo(
        options.environmentTriangles, environment, range,
        [&](const Detail& detail, int studs) { return buildTunnel(design, detail, tunnelRandom, studs); });
}

GeneratedScene makeVersion(int version, const SceneOptions& options) {
    const TunnelConsoleDesign design = designTunnelConsole(options, version);
    GeneratedScene scene;
    scene.name = "tunnel-console";
    buildMeshes(scene, design, version, options);
    scene.path = constructedPath(design);
    centrePart(scene);
    scene.path.push_back(outside(scene.path.back(), design.screw.drift));

    setProblem(scene, kRoom);
    scene.problem.name = "tunnel-console v" + std::to_string(version);
    scene.problem.step = design.thinnestSheet() / 2;
    return scene;
}

}  // namespace

GeneratedScene makeTunnelConsole1(const SceneOptions& options) {
    return makeVersion(1, options);
}

GeneratedScene makeTunnelConsole2(const SceneOptions& options) {
    return makeVersion(2, options);
}

GeneratedScene makeTunnelConsole3(const SceneOptions& options) {
    return makeVersion(3, options);
}

}  // namespace clearway::scenes
