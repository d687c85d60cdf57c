// Scenes: one rigid part, the static obstacles around it, and the margins to keep.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"

#pragma GCC visibility push(default)

namespace clearway {

/// The insides of the closed components of a mesh. Immutable, shared by copies of a scene.
class Solids;

/// The result of makeSolids.
struct MadeSolids {
    std::shared_ptr<const Solids> solids;  ///< never null; without closed components it holds nothing
    std::vector<std::string>
        refusals;  ///< one line for each component that encloses nothing, with the reason
    std::vector<std::string> turnedOver;  ///< names of components whose triangles all faced inwards
};

/// Makes the solids of a mesh for Obstacle::solids or Scene::partSolids. Give it the mesh of the model.
/// Within a component, shells that face the other way bound cavities. Throws ArgumentError as
/// Model::build does.
MadeSolids makeSolids(const Mesh& mesh);

/// A part that is shrunk so that obstacles may reach a little way into it (see shrink()).
struct ShrunkModel {
    Model model;                           ///< in the part's mesh coordinates
    std::shared_ptr<const Solids> solids;  ///< the insides of the model's mesh
    double overlap = 0;                    ///< ShrinkOptions::overlap; mesh units

    /// For each triangle of the model the one of the part's mesh that it comes from. Reports name these.
    std::vector<std::uint32_t> partTriangles;
};

/// Meshes that share a margin and count at equal poses, as one model.
struct Obstacle {
    /// Throws ArgumentError unless the margin is finite and >= 0.
    Obstacle(Model theModel, double theMargin = 0);

    Model model;    ///< its mesh coordinates are the environment's frame
    double margin;  ///< environment units, >= 0; a pose is valid when the distance is larger

    /// For each of the model's components, the position of its first triangle in the component's file; with shrunkBy,
    /// for each triangle its own one. Reports name triangles by these positions. Empty: the positions in the model's
    /// own mesh.
    std::vector<std::uint32_t> fileTriangles = {};

    /// With solids, a pose is also invalid when a piece of the part is inside a closed component of the
    /// obstacle, or a piece of the obstacle is inside a closed component of the part. Null: only surfaces
    /// count.
    std::shared_ptr<const Solids> solids = nullptr;

    bool isIgnoredAtStart = false;  ///< while the part is within Scene::startContact
    bool isIgnoredAtGoal = false;   ///< while the part is within Scene::goalContact

    /// Stands for the part toward this obstacle: a pose is then invalid when the obstacle touches the shrunk
    /// part or, with solids, one holds a piece of the other. Distances, clearances and the margin are the
    /// shrunk part's. Null: the part itself.
    std::shared_ptr<const ShrunkModel> shrunk = nullptr;

    /// Above 0: the model and the solids are those of an obstacle that was shrunk by this overlap (see shrink()), in
    /// place of a part that is open. Environment units.
    double shrunkBy = 0;

    /// How deep one may reach into the other: by `shrunk` the obstacle into the part, or by `shrunkBy` the part into the
    /// obstacle; environment units; 0: they may not touch.
    double overlap() const { return shrunk ? shrunk->overlap : shrunkBy; }
};

/// A zone around an assembled pose, in which given obstacles are ignored because assembled parts touch. The
/// part is within the zone while Model::displacement from the assembled pose is at most the distance. Beyond
/// it the obstacles count fully.
struct ContactZone {
    /// Throws ArgumentError unless the distance is finite and > 0.
    ContactZone(const Pose& pose, double theDistance);

    Pose X_environmentPart;  ///< the assembled pose
    double distance;         ///< environment units, finite, > 0
};

/// One part among obstacles. Obstacles may be added, changed and removed one by one without building the
/// others again. Without obstacles every pose is valid and clearances are infinite.
struct Scene {
    /// A part without obstacles.
    explicit Scene(Model thePart) : part(std::move(thePart)) {}
    /// A part and one obstacle. The margin is in environment units. Throws as Obstacle does.
    Scene(Model thePart, Model environment, double margin = 0)
        : part(std::move(thePart)), obstacles{{std::move(environment), margin}} {}

    Model part;                                ///< the moving part; built without a range
    std::vector<Obstacle> obstacles;           ///< reports name an obstacle by its position here
    std::shared_ptr<const Solids> partSolids;  ///< needed when an obstacle has solids
    std::optional<ContactZone> startContact;   ///< needed when an obstacle is ignored at the start
    std::optional<ContactZone> goalContact;    ///< needed when an obstacle is ignored at the goal

    /// The box of obstacles that were left out, and of those that were shrunk, as they were. It counts only for environmentBox(), from which a problem's
    /// bounds are taken.
    Box ignoredBox;

    /// Stands after lengths in messages, such as "mm"; empty: no unit is shown.
    std::string unit;

    /// The model that stands for the part toward an obstacle.
    const Model& partFor(const Obstacle& obstacle) const {
        return obstacle.shrunk ? obstacle.shrunk->model : part;
    }

    /// The obstacles' largest margin, in environment units; 0 without obstacles.
    double largestMargin() const {
        double largest = 0;
        for (const Obstacle& obstacle : obstacles) largest = std::max(largest, obstacle.margin);
        return largest;
    }

    /// The box of all obstacles, including triangles beyond their range.
    Box environmentBox() const {
        Box box = ignoredBox;
        for (const Obstacle& obstacle : obstacles) box.extend(obstacle.model.box());
        return box;
    }
};

/// The distance to one of a scene's obstacles. Witness::environmentComponent is an index into that
/// obstacle's model; Witness::environmentTriangle is the position in the component's file (see Obstacle::fileTriangles).
struct SceneDistance : DistanceResult {
    std::optional<std::size_t> obstacle;  ///< index into Scene::obstacles; none without obstacles
};

}  // namespace clearway

#pragma GCC visibility pop
