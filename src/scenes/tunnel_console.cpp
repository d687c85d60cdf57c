#include "scenes/tunnel_console.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "scenes/tunnel_console_design.h"

namespace clearway {

namespace {

constexpr std::size_t kMostTriangles = 4000000;
constexpr double kFineness = 40;  // the greatest, see detailFor
constexpr double kRoom = 120;     // mm about the path's positions that planners may use

using Build = std::function<Assembly(const TunnelConsoleDetail&, int studs)>;

/// One number says how fine everything is: 1 is the coarsest.
TunnelConsoleDetail detailFor(double fineness, double longestStep) {
    TunnelConsoleDetail detail;
    detail.segmentsPerQuarter = std::max(2, static_cast<int>(std::pow(fineness, 0.75)));
    detail.segmentsPerTurn = 4 * static_cast<int>(std::ceil(1.5 * std::pow(fineness, 0.75) + 0.5));
    detail.step = longestStep / fineness;
    detail.richness = std::pow(fineness, 0.7);
    return detail;
}

/// The finest build that has no more triangles than asked for, filled up with studs.
Mesh buildTo(std::size_t triangles, const std::string& option, double longestStep, const Build& build) {
    const auto countAt = [&](double fineness) {
        return build(detailFor(fineness, longestStep), 0).triangleCount();
    };
    double low = 1, high = kFineness;
    const std::size_t least = countAt(low);
    if (triangles < least || triangles > kMostTriangles) {
        throw std::invalid_argument(option + " is " + std::to_string(triangles) + ", expected " +
                                    std::to_string(least) + " to " + std::to_string(kMostTriangles) +
                                    " at this clearance and seed");
    }
    for (int i = 0; i < 24; ++i) {
        const double middle = (low + high) / 2;
        (countAt(middle) <= triangles ? low : high) = middle;
    }
    const TunnelConsoleDetail detail = detailFor(low, longestStep);
    const std::size_t missing = triangles - countAt(low);
    return build(detail, static_cast<int>(missing / studTriangles(detail))).mesh();
}

/// Turns the path of the part's own frame into that of the part moved by `shift`.
PartState followingShift(PartState state, const Vector3& shift) {
    state.position -= state.rotation * shift;
    return state;
}

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

Box roomFor(const std::vector<PartState>& path) {
    Box room;
    for (const PartState& state : path) room.extend(state.position);
    const Vector3 margin = Vector3::Constant(kRoom);
    return {(room.min() - margin).array().floor().matrix(), (room.max() + margin).array().ceil().matrix()};
}

}  // namespace

GeneratedScene makeTunnelConsole(const SceneOptions& options) {
    const TunnelConsoleDesign design = designTunnelConsole(options);
    const Random partRandom(options.seed ^ 0xC0501Eu), tunnelRandom(options.seed ^ 0x7A22E1u);
    GeneratedScene scene;
    scene.name = "tunnel-console";
    scene.part = buildTo(options.partTriangles, "part-triangles", design.longestStep,
                         [&](const TunnelConsoleDetail& detail, int studs) {
                             return buildConsole(design, detail, partRandom, studs);
                         });
    scene.environment = buildTo(options.environmentTriangles, "environment-triangles", design.longestStep,
                                [&](const TunnelConsoleDetail& detail, int studs) {
                                    return buildTunnel(design, detail, tunnelRandom, studs);
                                });

    // The mean of the vertices becomes the part's origin, about which planners turn it.
    Vector3 mean = Vector3::Zero();
    for (const Vector3& vertex : scene.part.vertices) mean += vertex;
    mean = (mean / static_cast<double>(scene.part.vertices.size())).array().round();
    for (Vector3& vertex : scene.part.vertices) vertex = (vertex - mean).cast<float>().cast<double>();
    for (PartState& state : constructedPath(design)) scene.path.push_back(followingShift(state, -mean));
    scene.path.push_back(outside(scene.path.back(), design.screw.drift));

    Problem& problem = scene.problem;
    problem.name = "tunnel-console v1";
    problem.start = scene.path.front();
    problem.goal = scene.path.back();
    problem.volume = roomFor(scene.path);
    problem.step = design.thinnestSheet() / 2;
    return scene;
}

}  // namespace clearway
