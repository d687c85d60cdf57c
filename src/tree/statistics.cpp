#include "tree/statistics.h"

#include <algorithm>

namespace clearway {

namespace {

template <class Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.size() * sizeof(Value);
}

template <int kWidth>
void countNodes(const std::vector<WideNode<kWidth>>& nodes, TreeStatistics& counted) {
    std::vector<int> depths(nodes.size(), 1);  // children come after their parent
    std::size_t children = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        counted.depth = std::max(counted.depth, depths[i]);
        for (const std::int32_t child : nodes[i].child) {
            if (child == kNoChild) continue;
            ++children;
            if (child >= 0) depths[child] = depths[i] + 1;
        }
    }
    counted.nodes = nodes.size();
    counted.meanChildren = static_cast<double>(children) / static_cast<double>(nodes.size());
}

}  // namespace

TreeStatistics statistics(const FlatTree& tree) {
    TreeStatistics counted;
    if (tree.nodeWidth == 2) {
        countNodes(tree.nodes2, counted);
    } else {
        countNodes(tree.nodes8, counted);
    }
    counted.leaves = tree.leaves.size();
    for (const Leaf& leaf : tree.leaves) {
        if (counted.leavesBySize.size() <= leaf.triangleCount)
            counted.leavesBySize.resize(leaf.triangleCount + 1);
        ++counted.leavesBySize[leaf.triangleCount];
    }
    counted.bytes = sizeof(FlatTree) + bytesOf(tree.nodes2) + bytesOf(tree.nodes8) + bytesOf(tree.leaves) +
                    bytesOf(tree.leafVertices) + bytesOf(tree.vertices) + bytesOf(tree.triangles) +
                    bytesOf(tree.triangleIds);
    return counted;
}

}  // namespace clearway
