#include "program/scenes/apartment.h"

#include <cmath>

#include "program/scenes/apartment_rooms.h"
#include "program/scenes/path_to_problem.h"

namespace clearway::scenes {

namespace {

constexpr double kLeastClearance = 5, kMostClearance = 70;  // mm
constexpr double kEase = 0.08;                              // of the clearance that is left beyond it
constexpr double kLift = 160;                               // mm off the floor while it is carried
constexpr double kAbove = 600;                              // mm that planners may lift it further
constexpr FinenessRange kFineness{400, 0.2};

PartState standing(double x, double y, double turned) {
    PartState state;
    state.position = {x, y, kLift};
    state.rotation = Eigen::AngleAxisd(turned, Vector3::UnitZ());
    return state;
}

}  // namespace

GeneratedScene makeApartment(const SceneOptions& options) {
    requireClearance(options.clearance, kLeastClearance, kMostClearance);
    Apartment apartment;
    Random random(options.seed);
    apartment.firstDoor += std::floor(random.between(-100, 101));
    apartment.secondDoor += std::floor(random.between(-150, 151));
    apartment.doorHalf = apartment.pianoDepth / 2 + options.clearance * (1 + kEase) + 0.01;

    GeneratedScene scene;
    scene.name = "apartment";
    scene.part =
        buildTo(options.partTriangles, "part-triangles", kFineness,
                [&](const Detail& detail, int studs) { return buildPiano(apartment, detail, studs); });
    scene.environment = buildTo(
        options.environmentTriangles, "environment-triangles", kFineness,
        [&](const Detail& detail, int studs) { return buildApartment(apartment, detail, random, studs); });

    const double corridor = (apartment.corridorLow + apartment.corridorHigh) / 2;
    const double first = apartment.firstDoor, second = apartment.secondDoor;
    scene.path = {standing(2100, 4700, 0.8),          standing(2350, first, 0),
                  standing(corridor, first, 0),       standing(corridor, first, M_PI_2),
                  standing(corridor, second, M_PI_2), standing(corridor, second, 0),
                  standing(8050, second, 0),          standing(8050, second + 100, -0.4)};
    statePathAsProblem(scene, 0);
    // The piano's middle may go anywhere within the walls, but not over them.
    const double low = scene.path[0].position.z();
    scene.problem.volume =
        Box(Vector3(0, 0, low - kLift), Vector3(apartment.width, apartment.depth, low + kAbove));
    scene.problem.name = "apartment v1";
    scene.problem.step = apartment.leaf / 2;
    return scene;
}

}  // namespace clearway::scenes
