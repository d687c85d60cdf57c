// The findings of `clearway info` as JSON.
#pragma once

#include "clearway/model.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "mesh/clean.h"
#include "program/options/facts.h"

namespace clearway::cli {

/// The mesh as it was read, the findings of cleaning, and the tree of the model that was built from it.
Json meshFacts(const Mesh& mesh, const CleanMesh& cleaned, const Model& model);

/// The keys of the problem with their values. bounds: of the part's position.
Json problemFacts(const Problem& problem, const Box& bounds);

Json obstacleFacts(const ObstacleGroups& obstacles);

/// Whether the part is valid there; if not, why; if so, how far from what.
Json poseFacts(const SceneClearance& clearance, const PartState& state);

}  // namespace clearway::cli
