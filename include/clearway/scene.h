// What a planner asks about: one rigid part, the static obstacles around it, and the margins to keep.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"

namespace clearway {

/// What the closed components of a mesh enclose. Immutable, shared by copies of a scene.
class Solids;

struct MadeSolids {
    std::shared_ptr<const Solids> solids;
    std::vector<std::string> refusals;    ///< of components that enclose nothing: which, and why
    std::vector<std::string> turnedOver;  ///< names of components whose triangles all faced inwards
};

/// For Obstacle::solids and Scene::partSolids, of the meshes that their models were built from. Shells that
/// face the other way within a component bound cavities. Throws std::invalid_argument as Model::build does.
MadeSolids makeSolids(const Mesh& mesh);

/// Meshes that share a margin and count at the same poses, as one model.
struct Obstacle {
    Model model;
    double margin = 0;  ///< environment units; a pose is valid when the distance is larger. >= 0

    /// Of each of the model's components the position of its first triangle in the file it came from, by
    /// which reports name triangles. Empty: they are those of the model's own mesh.
    std::vector<std::uint32_t> fileTriangles = {};

    /// A pose is invalid when a piece of the part is inside a closed component of the obstacle, or a piece of
    /// the obstacle inside one of the part. Null: surfaces alone count.
    std::shared_ptr<const Solids> solids = nullptr;

    bool isIgnoredAtStart = false;  ///< while the part is within Scene::startContact
    bool isIgnoredAtGoal = false;   ///< while the part is within Scene::goalContact
};

/// Assembled parts touch: obstacles that are ignored at a pose are so while no vertex of the part is further
/// than the distance from where it is at the assembled pose (by Model::displacement). Beyond it they count in
/// full.
struct ContactZone {
    Pose X_environmentPart;  ///< the part assembled
    double distance = 0;     ///< environment units, finite, > 0
};

/// Obstacles may be added, changed and taken away one by one; the others are not built again. Without any,
/// every pose is valid and clearances are infinite.
struct Scene {
    explicit Scene(Model thePart) : part(std::move(thePart)) {}
    Scene(Model thePart, Model environment, double margin = 0)
        : part(std::move(thePart)), obstacles{{std::move(environment), margin}} {}

    Model part;
    std::vector<Obstacle> obstacles;
    std::shared_ptr<const Solids> partSolids;  ///< needed when an obstacle has solids
    std::optional<ContactZone> startContact, goalContact;

    /// Of obstacles that were left out: it counts for environmentBox() alone, from which a problem's bounds
    /// are taken.
    Box ignoredBox;

    double largestMargin() const;  ///< 0 without obstacles
    Box environmentBox() const;    ///< of all obstacles, triangles out of reach included
};

/// The distance to one of a scene's obstacles, in whose model the component is to be looked up. The
/// obstacle's triangle is named by its position in the file (see Obstacle::fileTriangles).
struct SceneDistance : DistanceResult {
    int obstacle = -1;  ///< index into Scene::obstacles; -1 without obstacles
};

}  // namespace clearway
