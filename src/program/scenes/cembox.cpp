#include "program/scenes/cembox.h"

#include "program/scenes/cembox_design.h"
#include "program/scenes/path_to_problem.h"

namespace clearway::scenes {

namespace {

constexpr double kRoom = 120;  // mm about the path's positions that planners may use
constexpr FinenessRange kFineness{60, 0.1};

}  // namespace

GeneratedScene makeCembox(const SceneOptions& options) {
    const CemboxDesign design = designCembox(options);
    const KeptFree keptFree = design.keptFree();
    const Random partRandom(options.seed ^ 0xCE3B0Cu), bayRandom(options.seed ^ 0xE36B4Eu);
    GeneratedScene scene;
    scene.name = "cembox";
    scene.part = buildTo(
        options.partTriangles, "part-triangles", kFineness,
        [&](const Detail& detail, int studs) { return buildModule(design, detail, partRandom, studs); });
    scene.environment = buildTo(options.environmentTriangles, "environment-triangles", kFineness,
                                [&](const Detail& detail, int studs) {
                                    return buildEngineBay(design, keptFree, detail, bayRandom, studs, false);
                                });
    scene.path = design.path();
    statePathAsProblem(scene, kRoom);
    scene.problem.name = "cembox v1";
    scene.problem.step = design.thinnestSheet / 2;
    return scene;
}

GeneratedScene makeCembox2(const SceneOptions& options) {
    const CemboxDesign design = designCembox(options);
    const KeptFree keptFree = design.keptFree();
    const Random partRandom(options.seed ^ 0xCE3B0Cu), bayRandom(options.seed ^ 0xE36B4Eu);
    GeneratedScene scene;
    scene.name = "cembox";
    scene.part = buildTo(
        options.partTriangles, "part-triangles", kFineness,
        {"housing", "guide_edge", "connector_shroud", "solder_point"},
        [&](const Detail& detail, int studs) { return buildModule(design, detail, partRandom, studs); });
    scene.environment =
        buildTo(options.environmentTriangles, "environment-triangles", kFineness,
                {"guide_rail", "buffer", "wiper_tube", "strut_brace", "bulkhead", "weld_stud"},
                [&](const Detail& detail, int studs) {
                    return buildEngineBay(design, keptFree, detail, bayRandom, studs, true);
                });
    scene.path = design.path();
    statePathAsProblem(scene, kRoom);
    scene.problem.name = "cembox v2";
    scene.problem.step = design.thinnestSheet / 2;
    return scene;
}

}  // namespace clearway::scenes
