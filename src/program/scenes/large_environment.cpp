#include "program/scenes/large_environment.h"

#include <cmath>

#include "program/scenes/car_body.h"
#include "program/scenes/path_to_problem.h"

namespace clearway::scenes {

namespace {

constexpr double kThinnestSheet = 0.7;  // mm
constexpr double kRoom = 200;           // mm about the path's positions that planners may use

// Lines are 120 mm apart at fineness 1. The openings that the part passes keep their shape down to 0.4.
constexpr FinenessRange kPartFineness{120, 0.3}, kBodyFineness{120, 0.4};

template <class Build>
Mesh meshOf(std::size_t triangles, const std::string& option, const FinenessRange& range,
            const Build& build) {
    const auto countAt = [&](const Detail& detail, int studs) {
        return build(detail, studs, true).triangleCount();
    };
    const Detail detail =
        finestDetail(triangles, option, range, [&](const Detail& tried) { return countAt(tried, 0); });
    const std::size_t without = countAt(detail, 0), stud = countAt(detail, 1) - without;
    return build(detail, static_cast<int>((triangles - without) / stud), false).assembly().mesh();
}

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
    scene.part = meshOf(options.partTriangles, "part-triangles", kPartFineness,
                        [&](const Detail& detail, int studs, bool onlyCount) {
                            return buildInstrumentCarrier(body, detail, partRandom, studs, onlyCount);
                        });
    scene.environment = meshOf(options.environmentTriangles, "environment-triangles", kBodyFineness,
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
