// Builds a binary tree by splitting one node at a time, large subtrees in parallel: the loop that most
// general splits share, and the means to divide a run of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/parallel.h"
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

/// Below this depth only halves are taken, so that no input makes a tree deeper than this plus the logarithm
/// of its triangles, nor a build slower than quasilinear. Meshes of millions of triangles stay well above
/// this depth.
constexpr int kDeepestSplit = 96;

/// Nodes of more triangles than this have their two children built, and fitted, by two tasks. The limit
/// depends on the tree alone, so that the tasks do not depend on the number of threads.
constexpr std::uint32_t kTaskTriangles = 8192;

/// Makes a node's two children, the left one over its first leftCount triangles, and returns the left one's index; the right
/// one's is the next. They get the node's frame.
std::size_t addChildren(LargeVector<BinaryNode>& nodes, std::size_t node, std::size_t leftCount);

/// The result of one task: a subtree, or a large node alone with the results of its children.
struct SubtreeNodes {
    LargeVector<BinaryNode> nodes;  ///< children as indices into these
    std::unique_ptr<SubtreeNodes> left, right;
};

/// Fills in the tree's nodes from the tasks' results.
void joinSubtrees(const SubtreeNodes& root, BinaryTree& tree);

template <class MakeSplit>
std::unique_ptr<SubtreeNodes> buildSubtree(const BinaryNode& root, int depth, std::size_t largestGroup,
                                           const MakeSplit& makeSplit) {
    auto part = std::make_unique<SubtreeNodes>();
    part->nodes.push_back(root);
    std::size_t leftCount;
    {
        auto split = makeSplit();
        if (root.triangleCount <= kTaskTriangles || root.triangleCount <= largestGroup) {
            split.splitAllBelow(part->nodes, depth);
            return part;
        }
        leftCount = split.leftCountOf(part->nodes.front(), depth);
    }
    LargeVector<BinaryNode> family = part->nodes;
    addChildren(family, 0, leftCount);
    invokeBoth([&] { part->left = buildSubtree(family[1], depth + 1, largestGroup, makeSplit); },
               [&] { part->right = buildSubtree(family[2], depth + 1, largestGroup, makeSplit); });
    return part;
}

/// Divides the tree's order into nodes, with leaves of at most largestGroup triangles, large subtrees in parallel. makeSplit():
/// called from several threads at once; makes a split with scratch of its own, whose functions must not depend on what it did
/// before: leftCountOf(node, depth) rearranges the triangles of a node so that those of its left child come first, and returns
/// their number, neither 0 nor all; splitAllBelow(nodes, depth) splits all below nodes[0].
template <class MakeSplit>
void buildInTasks(BinaryTree& tree, std::size_t largestGroup, const MakeSplit& makeSplit) {
    BinaryNode root;
    root.triangleCount = static_cast<std::uint32_t>(tree.order.size());
    joinSubtrees(*buildSubtree(root, 0, largestGroup, makeSplit), tree);
}

/// Rearranges the triangles of a node, at least two, so that those of its left child come first, and returns
/// their number. 0 or all means that the split found nothing; the loop then calls splitInHalves.
using NodeSplit = std::function<std::size_t(TriangleRun)>;

/// Makes a NodeSplit with scratch of its own, for one task; called from several threads at once. The way a
/// node is split must not depend on the nodes that its NodeSplit has seen before.
using MakeNodeSplit = std::function<NodeSplit()>;

/// The topology over the given triangles, with leaves of at most largestGroup triangles; volumes are not
/// fitted yet. The result does not depend on the number of threads.
BinaryTree buildTopDown(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup,
                        const MakeNodeSplit& makeNodeSplit);

}  // namespace clearway
