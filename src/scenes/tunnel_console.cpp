#include "scenes/tunnel_console.h"

#include <algorithm>
#include <cmath>

#include "scenes/path_to_problem.h"
#include "scenes/tunnel_console_design.h"

namespace clearway {

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

GeneratedScene makeVersion(int version, const SceneOptions& options) {
    const TunnelConsoleDesign design = designTunnelConsole(options, version >= 2);
    const Random partRandom(options.seed ^ 0xC0501Eu), tunnelRandom(options.seed ^ 0x7A22E1u);
    GeneratedScene scene;
    scene.name = "tunnel-console";
    scene.part = buildTo(
        options.partTriangles, "part-triangles", {design.longestStep},
        [&](const Detail& detail, int studs) { return buildConsole(design, detail, partRandom, studs); });
    scene.environment = buildTo(
        options.environmentTriangles, "environment-triangles", {design.longestStep},
        [&](const Detail& detail, int studs) { return buildTunnel(design, detail, tunnelRandom, studs); });

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

}  // namespace clearway
