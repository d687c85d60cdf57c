#include "bench/bench_scenes.h"

#include <string_view>

#include "bench/linked_rings.h"
#include "core/number.h"
#include "core/text.h"
#include "demos/scenes/scenes.h"

namespace clearway::testing {

using namespace scenes;

/// K's poses stay where the console is in the tunnel; those of L go on into the free room. Letters are never
/// used again, so that older results stay readable.
const std::vector<BenchScene>& benchScenes() {
    static const std::vector<BenchScene> kScenes = {
        {"F", "boxes-1", {100, 700}, {100, 700}, 0.1, 0, 0, 1, false},
        {"I", "cembox-2", {30000, 500000}, {4000, 42000}, 0.1, 0, 0, 1, true},
        {"J", "large-environment-2", {120000, 1700000}, {10000, 80000}, 0.1, 0, 0, 1, true},
        {"K", "tunnel-console-3", {73425, 300401}, {15000, 50000}, 0.75, 0, 0, 0.75, true},
        {"L", "tunnel-console-3", {73425, 300401}, {15000, 50000}, 0, 1e-3, 0.1, 1, true},
        {"M", kLinkedRings, {500000, 500000}, {8000, 8000}, 0, 1e-3, 0.1, 1, true},
        {"N", "puzzle-2", {2000, 2000}, {2000, 2000}, 0.1, 0, 0, 1, true},
    };
    return kScenes;
}

const BenchScene& benchSceneNamed(const std::string& name) {
    return rowNamed(benchScenes(), "the scene", name);
}

BenchTask makeTask(const BenchScene& scene, const BenchSize& size, int poses, std::uint64_t seed) {
    if (std::string_view(scene.scene) == kLinkedRings) {
        return {scene.name,
                kLinkedRings,
                std::string(kLinkedRings) + ", none colliding",
                ring(size.partTriangles),
                ring(size.environmentTriangles),
                linkedRingPoses(poses)};
    }
    const std::string name = scene.scene;
    const NamedScene& row = sceneNamed(name);
    SceneOptions options = row.defaults;
    options.partTriangles = size.partTriangles;
    options.environmentTriangles = size.environmentTriangles;
    GeneratedScene made = row.make(options);

    BenchTask task;
    task.name = scene.name;
    task.sceneName = scene.scene;
    const PoseTask poseTask{Model::build(made.part), Model::build(made.environment),
                            beginningOf(made.path, scene.pathEnd)};
    if (scene.collidingShare > 0) {
        task.poses = posesColliding(poseTask, scene.collidingShare, poses, seed, scene.turns);
        task.about =
            std::string(scene.scene) + ", " + shortNumber(100 * scene.collidingShare) + " % colliding";
    } else {
        task.poses = posesFree(poseTask, scene.leastFree, scene.mostFree, poses, seed);
        task.about = std::string(scene.scene) + ", none colliding";
    }
    task.part = std::move(made.part);
    task.environment = std::move(made.environment);
    return task;
}

}  // namespace clearway::testing
