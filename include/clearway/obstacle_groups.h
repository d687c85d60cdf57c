// From an environment's meshes and the rules for them to the obstacles of a scene.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/obstacle_rules.h"
#include "clearway/scene.h"

namespace clearway {

/// Meshes of several files as one. Of more than one file the components are called FILE/NAME, after the
/// file's name without its ending, or with as much of its path as tells it from others of that name; equal
/// names get #2, #3, ...
Mesh joinedEnvironment(const std::vector<Mesh>& files);

/// Components that share a margin and count alike: what an Obstacle is built from.
struct ObstacleGroup {
    Mesh mesh;
    double margin = 0;
    std::shared_ptr<const Solids> solids;  ///< null unless solid
    bool isIgnoredAtStart = false, isIgnoredAtGoal = false;
    std::vector<std::uint32_t> fileTriangles;  ///< see Obstacle
};

struct ObstacleGroups {
    std::vector<ObstacleGroup> groups;
    std::vector<std::string> ignored;  ///< names of the components left out
    Box ignoredBox;                    ///< of them
    std::vector<std::string> notes;    ///< one line each: solids that were turned over

    double largestMargin() const;  ///< 0 without groups
    bool hasSolids() const;
};

/// Each component of the files is in one group, or ignored. margin: of those that no rule names. Throws
/// std::invalid_argument that says which rule names no obstacle (and lists them), or several in different
/// files, or several files; which margin is none, or stands against another one; and which solids enclose nothing, and why.
ObstacleGroups groupObstacles(const std::vector<Mesh>& files, double margin, const ObstacleRules& rules);

/// The scene of a part among the groups, each built as `build` builds it. The contact zones are those of the
/// rules, about the part at its start and at its goal. partSolids may be null when no group is solid.
Scene makeScene(Model part, std::shared_ptr<const Solids> partSolids, const ObstacleGroups& obstacles,
                const ObstacleRules& rules, const Pose& X_environmentStart, const Pose& X_environmentGoal,
                const std::function<Model(const Mesh&)>& build);

}  // namespace clearway
