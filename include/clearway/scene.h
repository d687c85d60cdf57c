// What a planner asks about: one rigid part, the static obstacles around it, and the margins to keep.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"

namespace clearway {

/// Meshes that share a margin, as one model.
struct Obstacle {
    Model model;
    double margin = 0;  ///< environment units; a pose is valid when the distance is larger. >= 0

    /// Of each of the model's components the position of its first triangle in the file it came from, by
    /// which reports name triangles. Empty: they are those of the model's own mesh.
    std::vector<std::uint32_t> fileTriangles = {};
};

/// Obstacles may be added, changed and taken away one by one; the others are not built again. Without any,
/// every pose is valid and clearances are infinite.
struct Scene {
    explicit Scene(Model thePart) : part(std::move(thePart)) {}
    Scene(Model thePart, Model environment, double margin = 0)
        : part(std::move(thePart)), obstacles{{std::move(environment), margin}} {}

    Model part;
    std::vector<Obstacle> obstacles;

    double largestMargin() const;  ///< 0 without obstacles
    Box environmentBox() const;    ///< of all obstacles, triangles out of reach included
};

/// The distance to one of a scene's obstacles, in whose model the component is to be looked up. The
/// obstacle's triangle is named by its position in the file (see Obstacle::fileTriangles).
struct SceneDistance : DistanceResult {
    int obstacle = -1;  ///< index into Scene::obstacles; -1 without obstacles
};

}  // namespace clearway
