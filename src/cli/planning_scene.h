// What the subcommands that plan share: the problem's scene, built as far as planning can need it.
#pragma once

#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "planning/plan.h"

namespace clearway {

/// Throws what loading the meshes and building their models throw. cache: as buildModel takes it.
Scene buildScene(const Problem& problem, const planning::PlanOptions& options, const BuildOptions& tree,
                 const std::string& cache);

/// A row: the model's file, its triangles, and how many were left out.
void printMesh(const std::string& label, const Model& model);

/// One line each, on stderr.
void printWarnings(const std::vector<std::string>& warnings);

}  // namespace clearway
