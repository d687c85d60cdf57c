// Proves that there is no path out of a closed surface, or into it.
#include "clearway/scene_clearance.h"
#include "model/winding_surface.h"

namespace clearway {

std::optional<ShutIn> provedShutIn(const Scene& scene, const Pose& start, const std::optional<Pose>& goal) {
    const PointAtEnds ends{anyPointOf(scene.part), start, goal};
    for (const Obstacle& obstacle : scene.obstacles) {
        if (obstacle.isIgnoredAtStart || obstacle.isIgnoredAtGoal || obstacle.overlap() > 0) continue;
        if (const auto found = surfaceThatParts(obstacle.model, ends))
            return ShutIn{found->name, found->isAroundStart};
    }
    return std::nullopt;
}

}  // namespace clearway
