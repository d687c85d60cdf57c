// Each task builds a subtree, or one large node and the tasks of its children; the parts are then joined.
#include "build/top_down.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include "core/parallel.h"

namespace clearway {

namespace {

/// Three times the triangle's centroid, relative to a point: exact enough to compare when the point is near.
Vector3 tripleCentroid(const CleanMesh& mesh, std::uint32_t triangle, const Vector3& relativeTo) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (mesh.vertices[a] - relativeTo) + (mesh.vertices[b] - relativeTo) +
           (mesh.vertices[c] - relativeTo);
}

BinaryNode nodeOver(std::uint32_t firstTriangle, std::size_t count) {
    BinaryNode node;
    node.firstTriangle = firstTriangle;
    node.triangleCount = static_cast<std::uint32_t>(count);
    return node;
}

/// The result of one task: a subtree, or a large node alone with the results of its children.
struct Part {
    std::vector<BinaryNode> nodes;  ///< children as indices into these
    std::unique_ptr<Part> left, right;
};

class TopDown {
  public:
    TopDown(const CleanMesh& mesh, std::vector<std::uint32_t>& order, std::size_t largestGroup,
            const MakeNodeSplit& makeNodeSplit)
        : mesh_(mesh), order_(order), largestGroup_(largestGroup), makeNodeSplit_(makeNodeSplit) {}

    /// Builds the subtree below the root, which is at this depth of the whole tree.
    std::unique_ptr<Part> build(const BinaryNode& root, int depth) const {
        auto part = std::make_unique<Part>();
        part->nodes.push_back(root);
        const NodeSplit split = makeNodeSplit_();
        if (root.triangleCount <= kTaskTriangles || root.triangleCount <= largestGroup_) {
            splitAllBelow(part->nodes, depth, split);
            return part;
        }
        const std::size_t leftCount = leftCountOf(root, depth, split);
        invokeBoth([&] { part->left = build(leftChild(root, leftCount), depth + 1); },
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
        std::vector<Pending> pending{{0, rootDepth}};  // an explicit stack, so that no tree is too deep
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

/// Appends a part's nodes, then those of its children.
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

void appendCorners(const CleanMesh& mesh, std::uint32_t triangle, std::vector<Vector3>& corners) {
    for (const std::uint32_t vertex : mesh.triangles[triangle]) corners.push_back(mesh.vertices[vertex]);
}

void gatherCorners(const CleanMesh& mesh, const std::uint32_t* triangles, std::size_t count,
                   std::vector<Vector3>& corners) {
    corners.clear();
    for (std::size_t i = 0; i < count; ++i) appendCorners(mesh, triangles[i], corners);
}

bool liesBeyond(const CleanMesh& mesh, std::uint32_t triangle, const Plane& plane) {
    return plane.normal.dot(tripleCentroid(mesh, triangle, plane.point)) > 0;
}

std::size_t partitionByPlane(const CleanMesh& mesh, TriangleRun run, const Plane& plane) {
    const auto isLeft = [&](std::uint32_t triangle) { return !liesBeyond(mesh, triangle, plane); };
    return static_cast<std::size_t>(std::partition(run.first, run.last, isLeft) - run.first);
}

std::size_t splitInHalves(const CleanMesh& mesh, TriangleRun run) {
    const Vector3 reference = mesh.vertices[mesh.triangles[*run.first][0]];
    Vector3 lowest = tripleCentroid(mesh, *run.first, reference);
    Vector3 highest = lowest;
    for (const std::uint32_t triangle : run) {
        const Vector3 centroid = tripleCentroid(mesh, triangle, reference);
        lowest = lowest.cwiseMin(centroid);
        highest = highest.cwiseMax(centroid);
    }
    Eigen::Index axis = 0;
    (highest - lowest).maxCoeff(&axis);

    const auto key = [&](std::uint32_t triangle) {
        return std::make_pair(tripleCentroid(mesh, triangle, reference)[axis], triangle);
    };
    std::uint32_t* middle = run.first + run.size() / 2;
    std::nth_element(run.first, middle, run.last,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    return run.size() / 2;
}

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
