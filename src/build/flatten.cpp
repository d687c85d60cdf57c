// From the binary tree to the flat one that queries read. The children of a node are numbered together and
// subtrees stay close: nodes, leaves and vertices that are met together lie together.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "build/build.h"
#include "build/collapse.h"
#include "build/leaf_order.h"
#include "build/triangle_run.h"
#include "core/round.h"

namespace clearway {

namespace {

/// Covers the rounding of a distance between two points in double, relative to it.
constexpr double kDistanceRounding = 1 + 8 * 0x1p-53;

constexpr std::uint32_t kNotYetUsed = std::numeric_limits<std::uint32_t>::max();

/// Above the true one, whatever the coordinates' scale.
double largestDistance(const std::vector<Vector3>& points, const Vector3& from) {
    double largest = 0;
    for (const Vector3& point : points) largest = std::max(largest, (point - from).stableNorm());
    return largest * kDistanceRounding;
}

/// The smallest power of two above the radius; far beyond any mesh it stops where the inverse is still
/// finite.
int exponentAbove(double radius) {
    int exponent = 0;
    if (radius > 0) std::frexp(radius, &exponent);
    return std::clamp(exponent, -1000, 1000);
}

template <int kWidth>
WideNode<kWidth> nodeWithoutChildren() {
    WideNode<kWidth> node{};
    std::fill(std::begin(node.radius), std::end(node.radius), -std::numeric_limits<float>::infinity());
    std::fill(std::begin(node.child), std::end(node.child), kNoChild);
    return node;
}

template <int kWidth>
class Flattening {
  public:
    Flattening(const BinaryTree& binary, const CleanMesh& mesh, FlatTree& flat)
        : binary_(binary),
          mesh_(mesh),
          flat_(flat),
          nodes_(flat.nodes<kWidth>()),
          leafOrder_(mesh, binary.order),
          collapse_(binary, kWidth),
          unit_(std::ldexp(1.0, flat.unitExponent)),
          vertexIndices_(mesh.vertices.size(), kNotYetUsed) {}

    void run() {
        nodes_.push_back(nodeWithoutChildren<kWidth>());
        std::vector<Pending> pending;
        setLane(0, 0, 0, pending);  // the root's own volume is all of node 0
        while (!pending.empty()) {
            const auto [node, binaryNode] = pending.back();
            pending.pop_back();
            const std::vector<std::int32_t> children = collapse_.lanesOf(binaryNode);
            const std::size_t firstOpened = pending.size();
            for (std::size_t lane = 0; lane < children.size(); ++lane) {
                setLane(node, static_cast<int>(lane), children[lane], pending);
            }
            std::reverse(pending.begin() + firstOpened, pending.end());
        }
        flat_.leafVertices.resize(flat_.leafVertices.size() + kLeafPadding, 0.0f);
    }

  private:
    /// A wide node whose lanes are still to be filled from those below a binary node.
    struct Pending {
        std::int32_t node;
        std::int32_t binaryNode;
    };

    void setLane(std::int32_t node, int lane, std::int32_t binaryNode, std::vector<Pending>& pending) {
        const BinaryNode& source = binary_.nodes[binaryNode];
        leafOrder_.gatherVertices(source.firstTriangle, source.triangleCount, gathered_);
        setVolume(nodes_[node], lane, roundOutward(source.volume, gathered_.points, flat_.origin, unit_));
        if (source.isLeaf()) {
            nodes_[node].child[lane] = ~addLeaf(source);
        } else {
            const std::int32_t child = static_cast<std::int32_t>(nodes_.size());
            nodes_[node].child[lane] = child;
            nodes_.push_back(nodeWithoutChildren<kWidth>());
            pending.push_back({child, binaryNode});
        }
    }

    static void setVolume(WideNode<kWidth>& node, int lane, const FloatRss& volume) {
        for (int i = 0; i < 3; ++i) {
            node.centre[i][lane] = volume.centre[i];
            node.axis0[i][lane] = volume.axis0[i];
            node.axis1[i][lane] = volume.axis1[i];
        }
        node.halfLength0[lane] = volume.halfLength0;
        node.halfLength1[lane] = volume.halfLength1;
        node.radius[lane] = volume.radius;
        node.size[lane] =
            2 * std::sqrt((volume.halfLength0 + volume.radius) * (volume.halfLength1 + volume.radius));
    }

    std::int32_t addLeaf(const BinaryNode& source) {
        gatherCorners(mesh_, binary_.order.data() + source.firstTriangle, source.triangleCount, corners_);
        Box box;
        for (const Vector3& corner : corners_) box.extend(corner);
        const Vector3 centre = 0.5 * box.min() + 0.5 * box.max();

        Leaf leaf;
        leaf.centre = {centre.x(), centre.y(), centre.z()};
        leaf.firstTriangle = static_cast<std::uint32_t>(flat_.triangles.size());
        leaf.triangleCount = source.triangleCount;
        leaf.radius = roundedUp(largestDistance(corners_, centre) / unit_);
        for (int corner = 0; corner < 3; ++corner) {
            for (int coordinate = 0; coordinate < 3; ++coordinate) {
                for (std::size_t i = corner; i < corners_.size(); i += 3) {
                    const double offset = corners_[i][coordinate] - centre[coordinate];
                    flat_.leafVertices.push_back(static_cast<float>(offset / unit_));
                }
            }
        }
        for (std::uint32_t i = 0; i < source.triangleCount; ++i)
            addTriangle(binary_.order[source.firstTriangle + i]);
        flat_.leaves.push_back(leaf);
        return static_cast<std::int32_t>(flat_.leaves.size()) - 1;
    }

    void addTriangle(std::uint32_t triangle) {
        TriangleIndices indices = mesh_.triangles[triangle];
        for (std::uint32_t& vertex : indices) {
            if (vertexIndices_[vertex] == kNotYetUsed) {
                vertexIndices_[vertex] = static_cast<std::uint32_t>(flat_.vertices.size());
                flat_.vertices.push_back(mesh_.vertices[vertex]);
            }
            vertex = vertexIndices_[vertex];
        }
        flat_.triangles.push_back(indices);
        flat_.triangleIds.push_back(mesh_.triangleIds[triangle]);
    }

    const BinaryTree& binary_;
    const CleanMesh& mesh_;
    FlatTree& flat_;
    std::vector<WideNode<kWidth>>& nodes_;
    const LeafOrder leafOrder_;
    const Collapse collapse_;
    const double unit_;
    std::vector<std::uint32_t>
        vertexIndices_;  ///< new index of each of the mesh's vertices: in order of first use
    std::vector<Vector3> corners_;
    LeafOrder::Gathered gathered_;
};

}  // namespace

FlatTree flatten(const BinaryTree& tree, const CleanMesh& mesh, int nodeWidth) {
    FlatTree flat;
    flat.nodeWidth = nodeWidth;
    for (const Vector3& vertex : mesh.vertices) flat.box.extend(vertex);
    flat.origin = 0.5 * flat.box.min() + 0.5 * flat.box.max();
    const double radius = largestDistance(mesh.vertices, flat.origin);
    flat.unitExponent = exponentAbove(radius);
    flat.radius = roundedUp(std::ldexp(radius, -flat.unitExponent));
    flat.radiusAboutMeshOrigin = largestDistance(mesh.vertices, Vector3::Zero());
    withNodeWidth(nodeWidth, [&](auto width) { Flattening<width>(tree, mesh, flat).run(); });
    return flat;
}

}  // namespace clearway
