// Puts a build together: the general split's topology, its leaves split further, wide nodes and their volumes.
#include "build/build.h"

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

BinaryTree buildInThisArena(const CleanMesh& mesh, const BuildOptions& options) {
    const NamedGeneralSplit& generalSplit = generalSplitNamed(options.generalSplit);
    const NamedLeafSplit& leafSplit = leafSplitNamed(options.leafSplit);
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    BinaryTree tree =
        generalSplit.build(mesh, std::move(triangles), static_cast<std::size_t>(options.leafSize));
    if (generalSplit.isImproved) reinsertSubtrees(tree, mesh);
    leafSplit.build(tree, mesh, generalSplit.build);
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
