#include <cmath>

#include "program/scenes/car_body.h"
#include "program/scenes/large_environment.h"
#include "program/scenes/path_to_problem.h"
#include "program/scenes/roof_slot.h"

namespace clearway::scenes {

namespace {

constexpr double kThinnestSheet = 0.7;  // mm
constexpr double kRoom = 150;           // mm about the path's positions that planners may use

constexpr FinenessRange kFineness{120, 0.15};

/// The body, with the instrument carrier of version 1 in its place.
SheetMetal buildBody(const CarBody& body, const RoofSlot& roof, const Detail& detail, Random random,
                     int studs, bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    addRoofLayers(roof, metal, random);
    addFloor(body, metal, random);
    addUnderbody(body, metal);
    addSides(body, metal, random);
    addDash(body, metal, random);
    addMountings(body, metal);
    addFrontEnd(body, metal, random);
    addRear(body, metal, random);
    addFittings(body, metal, random);
    metal.include("carrier_", buildInstrumentCarrier(body, detail, random, 0, onlyCount));
    addFloorStuds(body, metal, studs);
    return metal;
}

}  // namespace

GeneratedScene makeLargeEnvironment2(const SceneOptions& options) {
    const CarBody body = designCarBody(options.seed, options.clearance);
    const RoofSlot roof = designRoofSlot(options);
    const Random partRandom(options.seed ^ 0x700F7Au), bodyRandom(options.seed ^ 0xB0D2u);
    GeneratedScene scene;
    scene.name = "large-environment";
    scene.part = sheetMetalTo(options.partTriangles, "part-triangles", kFineness,
                              {"upper_sheet", "lower_sheet", "spot_weld"},
                              [&](const Detail& detail, int studs, bool onlyCount) {
                                  return buildRoofTray(roof, detail, partRandom, studs, onlyCount);
                              });
    scene.environment = sheetMetalTo(options.environmentTriangles, "environment-triangles", kFineness,
                                     {"roof_inner_sheet", "lining_carrier", "side_guide", "stud"},
                                     [&](const Detail& detail, int studs, bool onlyCount) {
                                         return buildBody(body, roof, detail, bodyRandom, studs, onlyCount);
                                     });
    scene.path = roof.path();
    statePathAsProblem(scene, kRoom);
    scene.problem.name = "large-environment v2";
    scene.problem.step = kThinnestSheet / 2;
    return scene;
}

}  // namespace clearway::scenes
