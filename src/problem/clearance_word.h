// Names clearances for people and for JSON. Where overlaps are allowed, bodies may overlap at a clearance above 0: it is the distance between
// them as they are shrunk, and tells how much more they may move.
#pragma once

#include <algorithm>

#include "clearway/scene.h"

namespace clearway {

/// Whether the scene allows an overlap.
inline bool mayOverlap(const Scene& scene) {
    return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [](const Obstacle& obstacle) { return obstacle.overlap() > 0; });
}

/// "clearance", or "slack" in a scene that allows an overlap.
inline const char* clearanceWord(const Scene& scene) {
    return mayOverlap(scene) ? "slack" : "clearance";
}

}  // namespace clearway
