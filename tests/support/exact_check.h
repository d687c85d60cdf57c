// Checks every promise of clearway/query.h in exact arithmetic, for meshes small enough to try all pairs.
#pragma once

#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/query.h"
#include "support/exact_distance.h"
#include "support/query_cases.h"

namespace clearway::testing {

/// The distance under the pose's affine map of the stored doubles, without rounding. Tries all pairs: meshes
/// may have up to some 300 triangles each.
ExactDistance exactMeshDistance(const Mesh& part, const Mesh& environment, const Pose& X_environmentPart);

/// Two meshes at a pose and their distance.
struct ExactCase {
    std::string name;  ///< with the seed
    Mesh part, environment;
    Pose pose;
    ExactDistance truth;
    double largestCoordinate;  ///< M in the contracts
    double sceneSize;
};
ExactCase exactCase(const std::string& name, const Mesh& part, const Mesh& environment, const Pose& pose);

/// The doubles that enclose a distance: the largest below it (negative for 0) and the least not below it.
struct Enclosing {
    double below, above;
};
Enclosing enclosing(const ExactDistance& distance);

ModelPair buildPair(const ExactCase& exact, const BuildOptions& options);

/// Checks with BOOST_TEST that the interval holds the distance and is no wider than promised, that the
/// witnesses lie on their triangles at the stated distance, that isWithin turns between the two doubles
/// around the distance, and that the three queries agree. Returns the result of distance().
DistanceResult checkExactly(const ExactCase& exact, const ModelPair& models, Workspace& workspace);

/// Runs these checks on every instruction set, with trees of every leaf split and node width.
void checkEveryBuild(const ExactCase& exact);

}  // namespace clearway::testing
