// Makes the flat tree. The children of a node are numbered together and subtrees stay close, so that nodes,
// leaves and vertices that a query meets together lie together.
#include "build/flatten.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "build/collapse.h"
#include "build/leaf_blocks.h"
#include "build/leaf_order.h"
#include "tree/rss.h"

namespace clearway {

namespace {

/// An upper bound of the largest distance at any scale of the coordinates.
double largestDistance(const std::vector<Vector3>& points, const Vector3& from) {
    double largestSquared = 0;
    for (const Vector3& point : points)
        largestSquared = std::max(largestSquared, (point - from).squaredNorm());
    if (areSquaresSafe(largestSquared)) return std::sqrt(largestSquared) * kLengthRounding;
    double largest = 0;
    for (const Vector3& point : points) largest = std::max(largest, (point - from).stableNorm());
    return largest * kLengthRounding;
}

/// The exponent of the smallest power of two above the radius, clamped far beyond any mesh so that the
/// inverse stays finite.
int exponentAbove(double radius) {
    int exponent = 0;
    if (radius > 0) std::frexp(radius, &exponent);
    return std::clamp(exponent, -1000, 1000);
}

/// The middle of the box, rounded to a multiple of 2^-20 units: leaves then find centres of few bits.
Vector3 originOf(const Box& box, double unit) {
    Vector3 origin = 0.5 * box.min() + 0.5 * box.max();
    const double step = 0x1p-20 * unit;
    for (double& x : origin) {
        if (std::abs(x) < 0x1p52 * step) x = std::nearbyint(x / step) * step;
    }
    return origin;
}

/// A tree's box, origin and unit; no nodes.
FlatTree emptyTree(const CleanMesh& mesh) {
    FlatTree flat;
    for (const Vector3& vertex : mesh.vertices) flat.box.extend(vertex);
    // A mesh that is one point keeps it as its origin, and so a radius of 0.
    flat.origin = 0.5 * flat.box.min() + 0.5 * flat.box.max();
    double radius = largestDistance(mesh.vertices, flat.origin);
    if (radius > 0) {
        flat.origin = originOf(flat.box, std::ldexp(1.0, exponentAbove(radius)));
        radius = largestDistance(mesh.vertices, flat.origin);
    }
    flat.unitExponent = exponentAbove(radius);
    flat.unit = std::ldexp(1.0, flat.unitExponent);
    flat.radius = roundedUp(radius / flat.unit);
    flat.radiusAboutMeshOrigin = largestDistance(mesh.vertices, Vector3::Zero());
    return flat;
}

/// The wide nodes in their final order, and the leaves in theirs.
struct WideTree {
    std::vector<WideLanes> nodes;
    std::vector<LeafPlace> leaves;
};

WideTree numberNodes(const BinaryTree& binary, int nodeWidth) {
    const Collapse collapse(binary, nodeWidth);
    WideTree wide;
    /// A wide node whose lanes are still to be filled with the descendants of a binary node.
    struct Pending {
        std::uint32_t node;
        std::int32_t binaryNode;
    };
    std::vector<Pending> pending;
    const auto addLane = [&](std::uint32_t node, std::int32_t binaryNode) {
        const int lane = wide.nodes[node].count++;
        wide.nodes[node].binaryNode[std::size_t(lane)] = binaryNode;
        std::int32_t& child = wide.nodes[node].child[std::size_t(lane)];
        if (collapse.isLeaf(binaryNode)) {
            child = -1;
            wide.leaves.push_back({binaryNode, node, lane});
            return;
        }
        const auto number = static_cast<std::uint32_t>(wide.nodes.size());
        child = static_cast<std::int32_t>(number);
        pending.push_back({number, binaryNode});
        WideLanes below;
        below.parent = node;
        wide.nodes.push_back(below);
    };
    wide.nodes.emplace_back();
    addLane(0, 0);  // node 0 holds only the root's volume
    while (!pending.empty()) {
        const auto [node, binaryNode] = pending.back();
        pending.pop_back();
        const std::size_t firstOpened = pending.size();
        Collapse::Lanes lanes;
        const int count = collapse.lanesOf(binaryNode, lanes);
        for (int lane = 0; lane < count; ++lane) addLane(node, lanes[std::size_t(lane)]);
        std::reverse(pending.begin() + std::ptrdiff_t(firstOpened), pending.end());
    }
    return wide;
}

/// Nodes with children, but without volumes; children that are leaves are still kNoChild.
template <int kWidth>
LargeVector<WideNode<kWidth>> nodesOf(const WideTree& wide) {
    LargeVector<WideNode<kWidth>> nodes(wide.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (int lane = 0; lane < kWidth; ++lane) {
            const bool isInner = lane < wide.nodes[i].count && wide.nodes[i].child[std::size_t(lane)] >= 0;
            nodes[i].child[lane] = isInner ? wide.nodes[i].child[std::size_t(lane)] : kNoChild;
            nodes[i].radius[lane] = -std::numeric_limits<float>::infinity();
        }
    }
    return nodes;
}

template <int kWidth>
void setVolume(const FloatRss& volume, int lane, WideNode<kWidth>& node) {
    for (int k = 0; k < 3; ++k) {
        node.centre[k][lane] = volume.centre[k];
        node.axis0[k][lane] = volume.axis0[k];
        node.axis1[k][lane] = volume.axis1[k];
    }
    node.halfLength0[lane] = volume.halfLength0;
    node.halfLength1[lane] = volume.halfLength1;
    node.radius[lane] = volume.radius;
    node.size[lane] =
        2 * std::sqrt((volume.halfLength0 + volume.radius) * (volume.halfLength1 + volume.radius));
}

}  // namespace

FlatTree flatten(const BinaryTree& binary, const CleanMesh& mesh, int nodeWidth, FitFrames frames) {
    FlatTree flat = emptyTree(mesh);
    flat.nodeWidth = nodeWidth;
    const LeafOrder order(mesh, binary.order);
    withNodeWidth(nodeWidth, [&](auto width) {
        const WideTree wide = numberNodes(binary, width);
        LargeVector<WideNode<width>>& nodes = flat.nodes<width>();
        nodes = nodesOf<width>(wide);
        fitVolumes(wide.nodes, binary, order, flat, frames,
                   [&](std::size_t node, int lane, const FloatRss& volume) {
                       setVolume(volume, lane, nodes[node]);
                   });
        const std::vector<LeafReference> leaves = addLeafBlocks(wide.leaves, binary, order, mesh, flat);
        for (std::size_t i = 0; i < leaves.size(); ++i)
            nodes[wide.leaves[i].wideNode].child[wide.leaves[i].lane] = ~static_cast<std::int32_t>(leaves[i]);
    });
    return flat;
}

}  // namespace clearway
