#include "build/top_down.h"

#include <cassert>
#include <utility>

#include "build/split/halves.h"

namespace clearway {

namespace {

struct Pending {
    std::int32_t node;
    int depth;
};

/// Gives the node two children over the first leftCount of its triangles and over the others.
void addChildren(BinaryTree& tree, std::int32_t node, std::size_t leftCount) {
    BinaryNode left;
    BinaryNode right;
    left.firstTriangle = tree.nodes[node].firstTriangle;
    left.triangleCount = static_cast<std::uint32_t>(leftCount);
    right.firstTriangle = left.firstTriangle + left.triangleCount;
    right.triangleCount = tree.nodes[node].triangleCount - left.triangleCount;
    tree.nodes[node].left = static_cast<std::int32_t>(tree.nodes.size());
    tree.nodes[node].right = tree.nodes[node].left + 1;
    tree.nodes.push_back(left);
    tree.nodes.push_back(right);
}

}  // namespace

BinaryTree buildTopDown(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup,
                        const NodeSplit& splitNode) {
    assert(!triangles.empty() && largestGroup >= 1);
    BinaryTree tree;
    tree.order = std::move(triangles);
    tree.nodes.emplace_back();
    tree.nodes.front().triangleCount = static_cast<std::uint32_t>(tree.order.size());

    std::vector<Pending> pending{{0, 0}};  // a stack of our own: no tree is too deep for it
    while (!pending.empty()) {
        const auto [node, depth] = pending.back();
        pending.pop_back();
        const std::size_t count = tree.nodes[node].triangleCount;
        if (count <= largestGroup) continue;

        std::uint32_t* first = tree.order.data() + tree.nodes[node].firstTriangle;
        const TriangleRun run{first, first + count};
        std::size_t leftCount = depth < kDeepestSplit ? splitNode(run) : 0;
        if (leftCount == 0 || leftCount == count) leftCount = splitInHalves(mesh, run);
        addChildren(tree, node, leftCount);
        pending.push_back({tree.nodes[node].right, depth + 1});
        pending.push_back({tree.nodes[node].left, depth + 1});
    }
    return tree;
}

}  // namespace clearway
