#include "build/top_down.h"

#include <tbb/parallel_invoke.h>

#include <cassert>
#include <memory>
#include <utility>

#include "build/split/halves.h"
#include "build/tasks.h"

namespace clearway {

namespace {

BinaryNode nodeOver(std::uint32_t firstTriangle, std::size_t count) {
    BinaryNode node;
    node.firstTriangle = firstTriangle;
    node.triangleCount = static_cast<std::uint32_t>(count);
    return node;
}

/// What one task makes: a subtree, or a large node alone and the tasks of its children.
struct Part {
    std::vector<BinaryNode> nodes;  ///< children as indices into these
    std::unique_ptr<Part> left, right;
};

class TopDown {
  public:
    TopDown(const CleanMesh& mesh, std::vector<std::uint32_t>& order, std::size_t largestGroup,
            const MakeNodeSplit& makeNodeSplit)
        : mesh_(mesh), order_(order), largestGroup_(largestGroup), makeNodeSplit_(makeNodeSplit) {}

    /// depth: of the root, within the whole tree.
    std::unique_ptr<Part> build(const BinaryNode& root, int depth) const {
        auto part = std::make_unique<Part>();
        part->nodes.push_back(root);
        const NodeSplit split = makeNodeSplit_();
        if (root.triangleCount <= kTaskTriangles || root.triangleCount <= largestGroup_) {
            splitAllBelow(part->nodes, depth, split);
            return part;
        }
        const std::size_t leftCount = leftCountOf(root, depth, split);
        tbb::parallel_invoke([&] { part->left = build(leftChild(root, leftCount), depth + 1); },
                             [&] { part->right = build(rightChild(root, leftCount), depth + 1); });
        return part;
    }

  private:
    struct Pending {
        std::size_t node;
        int depth;
    };

    static BinaryNode leftChild(const BinaryNode& node, std::size_t leftCount) {
        return nodeOver(node.firstTriangle, leftCount);
    }
    static BinaryNode rightChild(const BinaryNode& node, std::size_t leftCount) {
        return nodeOver(node.firstTriangle + static_cast<std::uint32_t>(leftCount),
                        node.triangleCount - leftCount);
    }

    std::size_t leftCountOf(const BinaryNode& node, int depth, const NodeSplit& split) const {
        std::uint32_t* first = order_.data() + node.firstTriangle;
        const TriangleRun run{first, first + node.triangleCount};
        const std::size_t leftCount = depth < kDeepestSplit ? split(run) : 0;
        return leftCount == 0 || leftCount == run.size() ? splitInHalves(mesh_, run) : leftCount;
    }

    void splitAllBelow(std::vector<BinaryNode>& nodes, int rootDepth, const NodeSplit& split) const {
        std::vector<Pending> pending{{0, rootDepth}};  // a stack of our own: no tree is too deep for it
        while (!pending.empty()) {
            const auto [index, depth] = pending.back();
            pending.pop_back();
            const BinaryNode node = nodes[index];
            if (node.triangleCount <= largestGroup_) continue;
            const std::size_t leftCount = leftCountOf(node, depth, split);
            const std::size_t left = nodes.size();
            nodes[index].left = static_cast<std::int32_t>(left);
            nodes[index].right = static_cast<std::int32_t>(left + 1);
            nodes.push_back(leftChild(node, leftCount));
            nodes.push_back(rightChild(node, leftCount));
            pending.push_back({left + 1, depth + 1});
            pending.push_back({left, depth + 1});
        }
    }

    const CleanMesh& mesh_;
    std::vector<std::uint32_t>& order_;
    const std::size_t largestGroup_;
    const MakeNodeSplit& makeNodeSplit_;
};

/// Appends a part's nodes, its children's behind them.
void append(const Part& part, std::vector<BinaryNode>& nodes) {
    const std::size_t root = nodes.size();
    const std::int32_t shift = static_cast<std::int32_t>(root);
    for (BinaryNode node : part.nodes) {
        if (!node.isLeaf()) {
            node.left += shift;
            node.right += shift;
        }
        nodes.push_back(node);
    }
    if (part.left == nullptr) return;
    nodes[root].left = static_cast<std::int32_t>(nodes.size());
    append(*part.left, nodes);
    nodes[root].right = static_cast<std::int32_t>(nodes.size());
    append(*part.right, nodes);
}

}  // namespace

BinaryTree buildTopDown(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup,
                        const MakeNodeSplit& makeNodeSplit) {
    assert(!triangles.empty() && largestGroup >= 1);
    BinaryTree tree;
    tree.order = std::move(triangles);
    const TopDown build(mesh, tree.order, largestGroup, makeNodeSplit);
    append(*build.build(nodeOver(0, tree.order.size()), 0), tree.nodes);
    return tree;
}

}  // namespace clearway
