// Builds a binary tree by splitting one node at a time, large subtrees in parallel: the loop that most
// general splits share, and the means to divide a run of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// A run of positions of triangles in CleanMesh::triangles, not owned. A split looks at the run and
/// rearranges it.
struct TriangleRun {
    std::uint32_t* first;
    std::uint32_t* last;  ///< one past the end

    std::uint32_t* begin() const { return first; }
    std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
};

/// Appends the three corners of a triangle. A vertex that several triangles share is appended for each of
/// them.
void appendCorners(const CleanMesh& mesh, std::uint32_t triangle, std::vector<Vector3>& corners);

/// Replaces the vector's contents by the corners of `count` triangles.
void gatherCorners(const CleanMesh& mesh, const std::uint32_t* triangles, std::size_t count,
                   std::vector<Vector3>& corners);

struct Plane {
    Vector3 point;
    Vector3 normal;
};

/// Whether the triangle's centroid lies on the side of the plane to which the normal points.
bool liesBeyond(const CleanMesh& mesh, std::uint32_t triangle, const Plane& plane);

/// Moves the triangles beyond the plane to the end of the run and returns the number of the others.
std::size_t partitionByPlane(const CleanMesh& mesh, TriangleRun run, const Plane& plane);

/// The split for nodes where a strategy finds none: rearranges the run at the median of the centroids along
/// the longest side of their box, by the triangles' positions where centroids coincide. Returns the size of
/// the left half, which for at least two triangles is neither 0 nor all.
std::size_t splitInHalves(const CleanMesh& mesh, TriangleRun run);

/// Rearranges the triangles of a node, at least two, so that those of its left child come first, and returns
/// their number. 0 or all means that the split found nothing; the loop then calls splitInHalves.
using NodeSplit = std::function<std::size_t(TriangleRun)>;

/// Makes a NodeSplit with scratch of its own, for one task; called from several threads at once. The way a
/// node is split must not depend on the nodes that its NodeSplit has seen before.
using MakeNodeSplit = std::function<NodeSplit()>;

/// Below this depth only halves are taken, so that no input makes a tree deeper than this plus the logarithm
/// of its triangles, nor a build slower than quasilinear. Meshes of millions of triangles stay well above
/// this depth.
constexpr int kDeepestSplit = 96;

/// Nodes of more triangles than this have their two children built, and fitted, by two tasks. The limit
/// depends on the tree alone, so that the tasks do not depend on the number of threads.
constexpr std::uint32_t kTaskTriangles = 4096;

/// The topology over the given triangles, with leaves of at most largestGroup triangles; volumes are not
/// fitted yet. The result does not depend on the number of threads.
BinaryTree buildTopDown(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup,
                        const MakeNodeSplit& makeNodeSplit);

}  // namespace clearway
