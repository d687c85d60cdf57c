// The oracle's tree: axis-aligned boxes in double, rounded outward, split at the median centroid of the
// longest axis, with one triangle per leaf.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/mesh.h"
#include "support/triangle_distance.h"

namespace clearway::testing {

struct BoxNode {
    double low[3];
    double high[3];
    int left = -1;  ///< children come after their parent; -1 for a leaf
    int right = -1;
    std::size_t triangle = 0;

    bool isLeaf() const { return left < 0; }
};

struct BoxTree {
    std::vector<BoxNode> nodes;  ///< [0] is the root; empty for a mesh without triangles

    explicit BoxTree(const Mesh& mesh);

    /// This tree, refitted to other positions of the mesh's vertices.
    BoxTree refitted(const Mesh& mesh, const std::vector<LongVector>& vertices) const;

  private:
    int addNodes(const std::vector<Vector3>& centroids, std::vector<std::size_t>& order, std::size_t first,
                 std::size_t last);
};

/// A lower bound of the distance between the contents of two boxes.
double lowerBound(const BoxNode& a, const BoxNode& b);

double diagonalSquared(const BoxNode& node);

}  // namespace clearway::testing
