// Makes the obstacles of a scene from the environment's meshes and the rules for them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/obstacle_rules.h"
#include "clearway/scene.h"

#pragma GCC visibility push(default)

namespace clearway {

/// Joins the meshes of several files. With more than one file, components are called FILE/NAME. FILE is the
/// file's name without its ending, or with as much of its path as distinguishes it from files of equal name.
/// Equal component names get #2, #3, ...
Mesh joinedEnvironment(const std::vector<Mesh>& files);

/// Components that share a margin and count alike. One Obstacle is built from each group.
struct ObstacleGroup {
    Mesh mesh;                             ///< the components, in the environment's frame
    double margin = 0;                     ///< environment units, >= 0
    double overlap = 0;                    ///< environment units, >= 0; 0 if the margin is above 0
    double shrunkBy = 0;                   ///< see Obstacle; the overlap, or 0 if the part is to be shrunk
    std::shared_ptr<const Solids> solids;  ///< null unless solid or with an overlap
    bool isIgnoredAtStart = false;         ///< see Obstacle
    bool isIgnoredAtGoal = false;          ///< see Obstacle
    std::vector<std::uint32_t> fileTriangles;  ///< see Obstacle
};

/// All groups of an environment, and what the rules leave out. Lengths in environment units.
struct ObstacleGroups {
    std::vector<ObstacleGroup> groups;  ///< none without triangles
    std::vector<std::string> ignored;   ///< names of the components left out
    Box ignoredBox;  ///< box of the ignored components, and of those shrunk, as they were; environment's frame
    std::vector<std::string> notes;  ///< one line for each solid that was turned over

    double largestMargin() const;          ///< the groups' largest margin; 0 without groups
    bool hasSolids() const;                ///< whether any group has solids
    std::vector<double> overlaps() const;  ///< those above 0, each once, rising
    Box environmentBox() const;  ///< box of all groups and ignoredBox: where a problem's bounds come from
};

/// Puts each component of the files that has triangles into one group, or among the ignored ones. margin: for components that no
/// rule names. Throws ArgumentError if a file's components do not cover its triangles in order, if a rule matches no obstacle (and lists the obstacles) or is
/// ambiguous between files, if a margin or an overlap is negative, not finite or contradicts another rule, if an
/// obstacle has both above 0, or if a solid encloses nothing (and says why).
ObstacleGroups groupObstacles(const std::vector<Mesh>& files, double margin, const ObstacleRules& rules);

/// Makes the scene of a part among the groups, whose models `build` makes. The contact zones of the rules lie
/// around the part's start and goal. partSolids may be null if no group is solid. shrunk: the part, shrunk by each
/// overlap of the groups that are not shrunk themselves.
Scene makeScene(Model part, std::shared_ptr<const Solids> partSolids, const ObstacleGroups& obstacles,
                const ObstacleRules& rules, const Pose& X_environmentStart, const Pose& X_environmentGoal,
                const std::function<Model(const Mesh&)>& build,
                const std::vector<std::shared_ptr<const ShrunkModel>>& shrunk = {});

}  // namespace clearway

#pragma GCC visibility pop
