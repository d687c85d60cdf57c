// Puts a build together: the general split's topology, its leaves split further, wide nodes and their volumes.
#include "build/build.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "build/fit_volumes.h"
#include "build/flatten.h"
#include "build/general_splits.h"
#include "build/leaf_splits.h"
#include "build/rate_nodes.h"
#include "build/reinsertion.h"
#include "core/parallel.h"

namespace clearway {

namespace {

/// Replaces a leaf by a small tree over its triangles.
void graft(BinaryTree& tree, std::size_t leaf, const BinaryTree& branch) {
    const FrameAxes axes = tree.nodes[leaf].axes;
    const std::uint32_t firstTriangle = tree.nodes[leaf].firstTriangle;
    std::copy(branch.order.begin(), branch.order.end(), tree.order.begin() + firstTriangle);
    // The branch's root takes the leaf's place; its other nodes go to the end.
    const std::int32_t shift = static_cast<std::int32_t>(tree.nodes.size()) - 1;
    for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
        BinaryNode node = branch.nodes[i];
        node.firstTriangle += firstTriangle;
        node.axes = axes;
        node.area = kNotRated;  // its area is in the branch's unit
        if (!node.isLeaf()) {
            node.left += shift;
            node.right += shift;
        }
        if (i == 0) {
            tree.nodes[leaf] = node;
        } else {
            tree.nodes.push_back(node);
        }
    }
}

void splitLeaves(BinaryTree& tree, const CleanMesh& mesh, LeafSplit leafSplit, GeneralSplit generalSplit) {
    const std::size_t count = tree.nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!tree.nodes[i].isLeaf()) continue;
        const auto first = tree.order.begin() + tree.nodes[i].firstTriangle;
        graft(tree, i, leafSplit(mesh, {first, first + tree.nodes[i].triangleCount}, generalSplit));
    }
}

BinaryTree buildInThisArena(const CleanMesh& mesh, const BuildOptions& options) {
    const NamedGeneralSplit& generalSplit = generalSplitNamed(options.generalSplit);
    const NamedLeafSplit& leafSplit = leafSplitNamed(options.leafSplit);
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    BinaryTree tree =
        generalSplit.build(mesh, std::move(triangles), static_cast<std::size_t>(options.leafSize));
    if (generalSplit.isImproved) reinsertSubtrees(tree, mesh);
    splitLeaves(tree, mesh, leafSplit.build, generalSplit.build);
    rateNodes(tree, mesh);
    return tree;
}

}  // namespace

BinaryTree buildBinaryTree(const CleanMesh& mesh, const BuildOptions& options) {
    requireBuildOptions(options);
    assert(!mesh.triangles.empty());
    return onThreads(options.threads, [&] { return buildInThisArena(mesh, options); });
}

FlatTree buildTree(const CleanMesh& mesh, const BuildOptions& options) {
    requireBuildOptions(options);
    assert(!mesh.triangles.empty());
    return onThreads(options.threads, [&] {
        return flatten(buildInThisArena(mesh, options), mesh, options.nodeWidth,
                       fitNamed(options.fit).frames);
    });
}

}  // namespace clearway
