// Counts and checks of flat trees.
#include "tree/flat_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "clearway/build_options.h"
#include "core/text.h"

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
    counted.bytes += bytesOf(nodes);
}

/// Children must come after their parent, so that every path downwards ends.
template <int kWidth>
bool areNodesSound(const std::vector<WideNode<kWidth>>& nodes, std::size_t leaves) {
    if (nodes.empty()) return false;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        bool ended = false;
        for (int lane = 0; lane < kWidth; ++lane) {
            const std::int32_t child = nodes[n].child[lane];
            if (child == kNoChild) {
                ended = true;
                continue;
            }
            if (ended || (n == 0 && lane > 0)) return false;
            const bool sound = child < 0 ? std::size_t(~child) < leaves
                                         : std::size_t(child) > n && std::size_t(child) < nodes.size();
            if (!sound) return false;
        }
        if (nodes[n].child[0] == kNoChild) return false;
    }
    return true;
}

template <int... kWidths>
bool isNodeWidth(int nodeWidth, std::integer_sequence<int, kWidths...>) {
    return ((nodeWidth == kWidths) || ...);
}

template <int... kWidths>
bool areNodesSound(const FlatTree& tree, std::integer_sequence<int, kWidths...>) {
    return ((tree.nodeWidth == kWidths ? areNodesSound(tree.nodes<kWidths>(), tree.leaves.size())
                                       : tree.nodes<kWidths>().empty()) &&
            ...);
}

}  // namespace

void refuseNodeWidth(int nodeWidth) {
    std::vector<std::string> known;
    for (const int width : nodeWidths()) known.push_back(std::to_string(width));
    throw std::invalid_argument("nodeWidth is " + std::to_string(nodeWidth) + ", expected one of " +
                                joined(known));
}

TreeStatistics statistics(const FlatTree& tree) {
    TreeStatistics counted;
    withNodeWidth(tree.nodeWidth, [&](auto width) { countNodes(tree.nodes<width>(), counted); });
    counted.leaves = tree.leaves.size();
    for (const Leaf& leaf : tree.leaves) {
        if (counted.leavesBySize.size() <= leaf.triangleCount)
            counted.leavesBySize.resize(leaf.triangleCount + 1);
        ++counted.leavesBySize[leaf.triangleCount];
    }
    counted.bytes += sizeof(FlatTree) + bytesOf(tree.leaves) + bytesOf(tree.leafVertices) +
                     bytesOf(tree.vertices) + bytesOf(tree.triangles) + bytesOf(tree.triangleIds);
    return counted;
}

const char* faultOf(const FlatTree& tree, std::size_t meshTriangles) {
    const std::size_t triangles = tree.triangles.size();
    if (!isNodeWidth(tree.nodeWidth, NodeWidths())) return "its node width is unknown";
    if (!areNodesSound(tree, NodeWidths())) return "its nodes refer to what is not there";
    for (const Leaf& leaf : tree.leaves) {
        if (leaf.triangleCount < 1 || leaf.triangleCount > std::uint32_t(kLargestLeafSize) ||
            leaf.firstTriangle > triangles || leaf.triangleCount > triangles - leaf.firstTriangle) {
            return "its leaves refer to triangles that are not there";
        }
    }
    if (tree.leafVertices.size() != 9 * triangles + kLeafPadding || tree.triangleIds.size() != triangles) {
        return "its arrays differ in length";
    }
    for (const auto& triangle : tree.triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (vertex >= tree.vertices.size()) return "its triangles refer to vertices that are not there";
        }
    }
    for (const std::uint32_t id : tree.triangleIds) {
        if (id >= meshTriangles) return "its triangle ids are out of range";
    }
    const auto isFinite = [](const Vector3& vertex) { return vertex.allFinite(); };
    if (!std::all_of(tree.vertices.begin(), tree.vertices.end(), isFinite) || !tree.origin.allFinite() ||
        !std::isfinite(tree.radius) || std::abs(tree.unitExponent) > 2000 || !tree.box.min().allFinite() ||
        !tree.box.max().allFinite()) {
        return "its coordinates are not finite";
    }
    return nullptr;
}

}  // namespace clearway
