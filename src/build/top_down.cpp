// Each task builds a subtree, or one large node and the tasks of its children; the parts are then joined.
#include "build/top_down.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

namespace clearway {

namespace {

/// Three times the triangle's centroid, relative to a point: exact enough to compare when the point is near.
Vector3 tripleCentroid(const CleanMesh& mesh, std::uint32_t triangle, const Vector3& relativeTo) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (mesh.vertices[a] - relativeTo) + (mesh.vertices[b] - relativeTo) +
           (mesh.vertices[c] - relativeTo);
}

class TopDownSplit {
  public:
    TopDownSplit(const CleanMesh& mesh, std::vector<std::uint32_t>& order, std::size_t largestGroup,
                 NodeSplit split)
        : mesh_(mesh), order_(order), largestGroup_(largestGroup), split_(std::move(split)) {}

    std::size_t leftCountOf(const BinaryNode& node, int depth) const {
        std::uint32_t* first = order_.data() + node.firstTriangle;
        const TriangleRun run{first, first + node.triangleCount};
        const std::size_t leftCount = depth < kDeepestSplit ? split_(run) : 0;
        return leftCount == 0 || leftCount == run.size() ? splitInHalves(mesh_, run) : leftCount;
    }

    void splitAllBelow(LargeVector<BinaryNode>& nodes, int rootDepth) const {
        struct Pending {
            std::size_t node;
            int depth;
        };
        std::vector<Pending> pending{{0, rootDepth}};  // an explicit stack, so that no tree is too deep
        while (!pending.empty()) {
            const auto [index, depth] = pending.back();
            pending.pop_back();
            if (nodes[index].triangleCount <= largestGroup_) continue;
            const std::size_t left = addChildren(nodes, index, leftCountOf(nodes[index], depth));
            pending.push_back({left + 1, depth + 1});
            pending.push_back({left, depth + 1});
        }
    }

  private:
    const CleanMesh& mesh_;
    std::vector<std::uint32_t>& order_;
    const std::size_t largestGroup_;
    const NodeSplit split_;
};

std::size_t countNodes(const SubtreeNodes& part) {
    return part.nodes.size() + (part.left == nullptr ? 0 : countNodes(*part.left) + countNodes(*part.right));
}

/// Appends a subtree's nodes, then those of its children.
void append(const SubtreeNodes& part, LargeVector<BinaryNode>& nodes) {
    const std::size_t root = nodes.size();
    const std::int32_t shift = static_cast<std::int32_t>(root);
    nodes.insert(nodes.end(), part.nodes.begin(), part.nodes.end());
    for (std::size_t i = root; i < nodes.size(); ++i) {
        if (nodes[i].isLeaf()) continue;
        nodes[i].left += shift;
        nodes[i].right += shift;
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

std::size_t addChildren(LargeVector<BinaryNode>& nodes, std::size_t node, std::size_t leftCount) {
    const std::size_t left = nodes.size();
    BinaryNode child;
    child.firstTriangle = nodes[node].firstTriangle;
    child.triangleCount = static_cast<std::uint32_t>(leftCount);
    child.axes = nodes[node].axes;
    nodes[node].left = static_cast<std::int32_t>(left);
    nodes[node].right = static_cast<std::int32_t>(left + 1);
    const std::uint32_t rightCount = nodes[node].triangleCount - child.triangleCount;
    nodes.push_back(child);
    child.firstTriangle += child.triangleCount;
    child.triangleCount = rightCount;
    nodes.push_back(child);
    return left;
}

void joinSubtrees(const SubtreeNodes& root, BinaryTree& tree) {
    tree.nodes.reserve(countNodes(root));
    append(root, tree.nodes);
}

BinaryTree buildTopDown(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup,
                        const MakeNodeSplit& makeNodeSplit) {
    assert(!triangles.empty() && largestGroup >= 1);
    BinaryTree tree;
    tree.order = std::move(triangles);
    buildInTasks(tree, largestGroup,
                 [&] { return TopDownSplit(mesh, tree.order, largestGroup, makeNodeSplit()); });
    return tree;
}

}  // namespace clearway
