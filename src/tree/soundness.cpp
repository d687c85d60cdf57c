#include "tree/soundness.h"

#include <algorithm>
#include <cmath>

namespace clearway {
namespace {

constexpr std::uint32_t kLargestLeaf = 16;

/// Children come after their node, so that every way down ends.
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

}  // namespace

const char* faultOf(const FlatTree& tree, std::size_t meshTriangles) {
    const std::size_t triangles = tree.triangles.size();
    if (tree.nodeWidth != 2 && tree.nodeWidth != 8) return "its node width is unknown";
    if (!(tree.nodeWidth == 2 ? tree.nodes8.empty() && areNodesSound(tree.nodes2, tree.leaves.size())
                              : tree.nodes2.empty() && areNodesSound(tree.nodes8, tree.leaves.size()))) {
        return "its nodes refer to what is not there";
    }
    for (const Leaf& leaf : tree.leaves) {
        if (leaf.triangleCount < 1 || leaf.triangleCount > kLargestLeaf || leaf.firstTriangle > triangles ||
            leaf.triangleCount > triangles - leaf.firstTriangle) {
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
