// Three walls, each with a window, of thin sheet or of thick slab. The two scenes differ in nothing else: in a thin wall a tree's groups
// of triangles hold both faces, in a thick one they do not.
#include "demos/scenes/scenes.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

namespace {

constexpr double kSheetsLeastClearance = 1, kSheetsMostClearance = 28;  // mm
constexpr double kSheet = 2, kSlab = 40;                                // mm thick
constexpr double kApart = 180;                                          // mm from wall to wall
constexpr double kSheetsRoom = 60;  // mm around the path's positions that planners may use
const Vector3 kPartHalf{20, 30, 12};
const Vector3 kWallHalf{260, 0, 210};
const Vector3 kWindows[] = {{-90, -kApart, -50}, {80, 0, 60}, {-60, kApart, 50}};  // their middles

/// Adds a wall as four boxes around its window. `triangles` are shared out by the boxes' sizes.
void addWall(Assembly& environment, const std::string& name, const Vector3& window, double clearance,
             double thickness, std::size_t triangles) {
    const Vector3 open = kPartHalf + Vector3::Constant(clearance);
    const double back = window.y() + thickness;  // the front stays where it is
    const auto box = [&](double x0, double x1, double z0, double z1) {
        return Box(Vector3(x0, window.y(), z0), Vector3(x1, back, z1));
    };
    const double left = window.x() - open.x(), right = window.x() + open.x(), low = window.z() - open.z(),
                 high = window.z() + open.z();
    const Box boxes[] = {box(-kWallHalf.x(), left, -kWallHalf.z(), kWallHalf.z()),
                         box(right, kWallHalf.x(), -kWallHalf.z(), kWallHalf.z()),
                         box(left, right, -kWallHalf.z(), low), box(left, right, high, kWallHalf.z())};
    const auto area = [](const Box& of) { return of.sizes().x() * of.sizes().z(); };
    double whole = 0;
    for (const Box& each : boxes) whole += area(each);
    std::size_t given = 0;
    for (const Box& each : boxes) {
        const auto share = static_cast<std::size_t>(static_cast<double>(triangles) * area(each) / whole);
        const std::size_t count = &each == std::end(boxes) - 1 ? triangles - given : share;
        environment.addNumbered(name, gridBox(each, count));
        given += share;
    }
}

GeneratedScene makeWalls(const SceneOptions& options, const char* name, double thickness) {
    requireClearance(options.clearance, kSheetsLeastClearance, kSheetsMostClearance);
    requireTriangles(options.partTriangles, "part-triangles", 12);
    requireTriangles(options.environmentTriangles, "environment-triangles", 1200);
    GeneratedScene scene;
    scene.name = name;
    Assembly part, environment;
    part.add("part", gridBox(Box(Vector3(-kPartHalf), kPartHalf), options.partTriangles));
    std::size_t left = options.environmentTriangles;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t triangles = left / (3 - i);
        addWall(environment, "wall_" + std::to_string(i + 1), kWindows[i], options.clearance * 1.01,
                thickness, triangles);
        left -= triangles;
    }
    scene.part = part.mesh();
    scene.environment = environment.mesh();
    PartState state;
    state.position = {0, -1.8 * kApart, 0};
    scene.path.push_back(state);
    for (const Vector3& window : kWindows) {
        for (const double y : {-0.3 * kApart, 0.55 * kApart}) {
            state.position = window + Vector3(0, y, 0);
            scene.path.push_back(state);
        }
    }
    state.position = {0, 1.9 * kApart, 0};
    scene.path.push_back(state);
    statePathAsProblem(scene, kSheetsRoom);
    scene.problem.name = std::string(name) + " v1";
    scene.problem.fineness = thickness / 2;
    return scene;
}

}  // namespace

GeneratedScene makeSheets(const SceneOptions& options) {
    return makeWalls(options, "sheets", kSheet);
}

GeneratedScene makeSlabs(const SceneOptions& options) {
    return makeWalls(options, "slabs", kSlab);
}

}  // namespace clearway::scenes
