// What the subcommands that plan share: the problem's scene, built as far as planning can need it.
#pragma once

#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/obstacle_groups.h"
#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::cli {

/// Throws what loading the meshes, grouping them by the problem's rules and building their models throw.
/// Warns on stderr of solids turned over and of a part that cannot be solid. cache: as buildModel takes it.
Scene buildScene(const Problem& problem, const planning::PlanOptions& options, const BuildOptions& tree,
                 const std::string& cache);

/// What to show of the worlds, as one mesh: not what the problem ignores, unless it ignores all of it.
Mesh shownEnvironment(const Problem& problem);

/// groupObstacles by the problem's rules; what it throws names the file.
ObstacleGroups obstaclesOf(const Problem& problem, const std::vector<Mesh>& worlds);

/// Of all of the environment, what is ignored included: where bounds come from.
Box boxOf(const ObstacleGroups& obstacles);

/// Rows: the obstacles, with names when rules tell them apart, the margin and the contact zones.
void printObstacles(const Scene& scene);
void printObstacles(const ObstacleGroups& obstacles);

/// The files a problem is read from, which no output may replace.
std::vector<std::string> inputsOf(const Problem& problem);

/// A row: the model's file, its triangles, and how many were left out.
void printMesh(const std::string& label, const Model& model);

/// One line each, on stderr.
void printWarnings(const std::vector<std::string>& warnings);

}  // namespace clearway::cli
