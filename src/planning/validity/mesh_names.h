// What messages call the meshes that are close to each other.
#pragma once

#include <string>

#include "clearway/scene.h"

namespace clearway::planning {

/// The name of a model's mesh: the component's, else its file's.
std::string meshName(const Model& model, std::int64_t component);

/// The name of the obstacle's mesh; empty without one.
std::string obstacleName(const Scene& scene, const SceneDistance& nearest);

/// Of the obstacle; 0 without one.
double marginOf(const Scene& scene, const SceneDistance& nearest);

/// "triangle 3 of the part's mesh 'a' and triangle 4 of the environment's mesh 'b' are ...": of a pair that
/// touches or is closer than the margin.
std::string whyBlocked(const Scene& scene, const SceneDistance& nearest);

}  // namespace clearway::planning
