// The slow truth that every query is tested against: an independent, plain binary tree of axis-aligned boxes
// in double, rounded outward, with long double at its leaves and integer arithmetic for pairs that may touch.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway::testing {

struct OracleAnswer {
    double distance = 0;  ///< rounded to nearest; 0 exactly when the two share a point
    std::size_t partTriangle = 0;
    std::size_t environmentTriangle = 0;
};

/// Built once for two meshes, then asked at any number of poses. Degenerate triangles count as segments or
/// points. The error is a few 2^-64 of the largest coordinate.
class MeshOracle {
  public:
    MeshOracle(const Mesh& part, const Mesh& environment);
    ~MeshOracle();

    OracleAnswer distance(const Pose& X_environmentPart) const;

    /// Whether the two share a point: exact, for the pose's affine map without rounding.
    bool collides(const Pose& X_environmentPart) const;

    /// The sum of the diagonals of the part's and the environment's boxes.
    double sceneSize() const;

    /// The distance between one triangle of each mesh, at the pose.
    double pairDistance(const Pose& X_environmentPart, std::size_t partTriangle,
                        std::size_t environmentTriangle) const;

  private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

/// Tries every triangle against every other, without a tree: for small meshes, and to check MeshOracle.
OracleAnswer bruteForceDistance(const Mesh& part, const Mesh& environment, const Pose& X_environmentPart);

/// The corners of a mesh's triangle.
std::array<Vector3, 3> cornersOf(const Mesh& mesh, std::size_t triangle);

}  // namespace clearway::testing
