// Makes the flat tree. The children of a node are numbered together and subtrees stay close, so that nodes,
// leaves and vertices that a query meets together lie together.
#include "build/flatten.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "build/leaf_centre.h"
#include "build/leaf_order.h"
#include "build/top_down.h"
#include "clearway/errors.h"
#include "mesh/renumber.h"
#include "tree/rss.h"

namespace clearway {

namespace {

/// Covers the rounding of a distance between two points in double, relative to it.
constexpr double kLengthRounding = 1 + 8 * 0x1p-53;

/// An upper bound of the largest distance at any scale of the coordinates.
double largestDistance(const std::vector<Vector3>& points, const Vector3& from) {
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

/// References to leaves stay below this, so that no node takes ~reference for kNoChild.
constexpr std::size_t kLeafBlocksEnd = std::numeric_limits<std::int32_t>::max();

/// The middle of the box, rounded to a multiple of 2^-20 units: leaves then find centres of few bits.
Vector3 originOf(const Box& box, double unit) {
    Vector3 origin = 0.5 * box.min() + 0.5 * box.max();
    const double step = 0x1p-20 * unit;
    for (double& x : origin) {
        if (std::abs(x) < 0x1p52 * step) x = std::nearbyint(x / step) * step;
    }
    return origin;
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
          numberOf_(mesh.vertices.size()) {}

    void run() {
        nodes_.push_back(nodeWithoutChildren<kWidth>());
        std::vector<Pending> pending;
        setLane(0, 0, 0, pending);  // node 0 holds only the root's volume
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
        flat_.leafBlocks.resize(flat_.leafBlocks.size() + kLeafPadding, 0.0f);
        nodes_.shrink_to_fit();
        flat_.leafBlocks.shrink_to_fit();
        flat_.vertices.shrink_to_fit();
    }

  private:
    /// A wide node whose lanes are still to be filled with the descendants of a binary node.
    struct Pending {
        std::int32_t node;
        std::int32_t binaryNode;
    };

    void setLane(std::int32_t node, int lane, std::int32_t binaryNode, std::vector<Pending>& pending) {
        const BinaryNode& source = binary_.nodes[binaryNode];
        leafOrder_.gatherVertices(source.firstTriangle, source.triangleCount, gathered_);
        setVolume(nodes_[node], lane,
                  roundOutward(source.volume, gathered_.points, flat_.origin, flat_.unit));
        if (source.isLeaf()) {
            nodes_[node].child[lane] = ~static_cast<std::int32_t>(addLeaf(source));
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

    LeafReference addLeaf(const BinaryNode& source) {
        const std::uint32_t* triangles = binary_.order.data() + source.firstTriangle;
        const std::uint32_t count = source.triangleCount;
        gatherCorners(mesh_, triangles, count, corners_);
        const LeafCentre centre = chooseLeafCentre(corners_, flat_.origin, flat_.unit);
        std::vector<float>& blocks = flat_.leafBlocks;
        const std::size_t at = blocks.size();
        if (at >= kLeafBlocksEnd) throw ArgumentError("the mesh has too many triangles for one tree");

        blocks.insert(blocks.end(), centre.stored.begin(), centre.stored.end());
        blocks.push_back(roundedUp(largestDistance(corners_, centre.point) / flat_.unit));
        addWholeNumber(count + (centre.isExact ? 0 : kHasVertices));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (int k = 0; k < 3; ++k) {
                for (std::size_t i = corner; i < corners_.size(); i += 3) {
                    blocks.push_back(leafOffset(corners_[i][k], centre.point[k], flat_.unit));
                }
            }
        }
        for (std::uint32_t i = 0; i < count; ++i) addWholeNumber(mesh_.triangleIds[triangles[i]]);
        if (!centre.isExact) {
            for (std::uint32_t i = 0; i < count; ++i) addVertexNumbers(triangles[i]);
        }
        assert(blocks.size() == at + leafBlockSize(count, centre.isExact));
        return static_cast<LeafReference>(at);
    }

    void addWholeNumber(std::uint32_t number) { storeWholeNumber(number, flat_.leafBlocks.emplace_back()); }

    void addVertexNumbers(std::uint32_t triangle) {
        for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
            addWholeNumber(numberOf_(
                vertex, [&](std::uint32_t used) { flat_.vertices.push_back(mesh_.vertices[used]); }));
        }
    }

    const BinaryTree& binary_;
    const CleanMesh& mesh_;
    FlatTree& flat_;
    std::vector<WideNode<kWidth>>& nodes_;
    const LeafOrder leafOrder_;
    const Collapse collapse_;
    FirstUseOrder numberOf_;  ///< the new numbers of the mesh's vertices
    std::vector<Vector3> corners_;
    LeafOrder::Gathered gathered_;
};

/// A node's area as a share of the root's; 1 if the root is a point.
double shareOfRoot(const BinaryTree& tree, std::int32_t node) {
    const double unit = tree.nodes.front().volume.longestExtent();
    const auto area = [unit](Rss volume) {
        volume.halfLength0 /= unit;
        volume.halfLength1 /= unit;
        volume.radius /= unit;
        return volume.area();
    };
    const double share = area(tree.nodes[node].volume) / area(tree.nodes.front().volume);
    return share >= 0 ? share : 1;  // 1 for NaN
}

}  // namespace

Collapse::Collapse(const BinaryTree& tree, int lanes)
    : tree_(tree), lanes_(lanes), choices_(tree.nodes.size()) {
    assert(lanes >= 2 && lanes <= kMostLanes);
    // Children come after their parents.
    for (std::size_t i = tree.nodes.size(); i-- > 0;) choose(static_cast<std::int32_t>(i));
}

void Collapse::choose(std::int32_t index) {
    const BinaryNode& node = tree_.nodes[index];
    if (node.isLeaf()) return;  // a leaf takes one lane and costs no wide node
    const Choice& left = choices_[node.left];
    const Choice& right = choices_[node.right];
    Choice& choice = choices_[index];
    for (int lanes = 2; lanes <= lanes_; ++lanes) {
        float& least = choice.cost[lanes - 1];
        for (int k = 1; k < lanes; ++k) {
            const float cost = left.cost[k - 1] + right.cost[lanes - k - 1];
            if (k == 1 || cost < least) {
                least = cost;
                choice.leftLanes[lanes - 1] = static_cast<std::int8_t>(k);
            }
        }
    }
    // The amount added for each node fills the lanes of nodes that queries hardly visit. It saves 1 % of the
    // visits and 2 bytes a triangle.
    const double perNode = 1.0 / static_cast<double>(tree_.order.size());
    choice.cost[0] = choice.cost[lanes_ - 1] + static_cast<float>(shareOfRoot(tree_, index) + perNode);
    choice.leftLanes[0] = choice.leftLanes[lanes_ - 1];
    for (int lanes = 2; lanes <= lanes_; ++lanes) {
        if (choice.cost[lanes - 2] > choice.cost[lanes - 1]) continue;
        choice.cost[lanes - 1] = choice.cost[lanes - 2];
        choice.leftLanes[lanes - 1] = 0;
    }
}

std::vector<std::int32_t> Collapse::lanesOf(std::int32_t index) const {
    const BinaryNode& node = tree_.nodes[index];
    const int leftLanes = choices_[index].leftLanes[0];
    std::vector<std::int32_t> result;
    appendLanes(node.left, leftLanes, result);
    appendLanes(node.right, lanes_ - leftLanes, result);
    return result;
}

void Collapse::appendLanes(std::int32_t index, int lanes, std::vector<std::int32_t>& result) const {
    const Choice& choice = choices_[index];
    while (lanes > 1 && choice.leftLanes[lanes - 1] == 0) --lanes;
    if (lanes == 1) {
        result.push_back(index);
        return;
    }
    const int leftLanes = choice.leftLanes[lanes - 1];
    appendLanes(tree_.nodes[index].left, leftLanes, result);
    appendLanes(tree_.nodes[index].right, lanes - leftLanes, result);
}

FlatTree flatten(const BinaryTree& tree, const CleanMesh& mesh, int nodeWidth) {
    FlatTree flat;
    flat.nodeWidth = nodeWidth;
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
    withNodeWidth(nodeWidth, [&](auto width) { Flattening<width>(tree, mesh, flat).run(); });
    return flat;
}

}  // namespace clearway
