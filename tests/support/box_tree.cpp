#include "support/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace clearway::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Converting long double to double rounds to nearest; one step further out certainly holds the point.
void fitLeaf(BoxNode& node, const TriangleIndices& triangle, const std::vector<LongVector>& vertices) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto values = {vertices[triangle[0]][axis], vertices[triangle[1]][axis],
                             vertices[triangle[2]][axis]};
        node.low[axis] = std::nextafter(static_cast<double>(std::min(values)), -kInfinity);
        node.high[axis] = std::nextafter(static_cast<double>(std::max(values)), kInfinity);
    }
}

}  // namespace

BoxTree::BoxTree(const Mesh& mesh) {
    if (mesh.triangles.empty()) return;
    std::vector<Vector3> centroids;
    for (const TriangleIndices& t : mesh.triangles) {
        centroids.push_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
    }
    std::vector<std::size_t> order(centroids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    nodes.reserve(2 * order.size());
    addNodes(centroids, order, 0, order.size());

    std::vector<LongVector> vertices;
    for (const Vector3& vertex : mesh.vertices) vertices.push_back(vertex.cast<long double>());
    *this = refitted(mesh, vertices);
}

int BoxTree::addNodes(const std::vector<Vector3>& centroids, std::vector<std::size_t>& order,
                      std::size_t first, std::size_t last) {
    const int index = static_cast<int>(nodes.size());
    nodes.push_back({});
    nodes[index].triangle = order[first];
    if (last - first == 1) return index;

    Box box;
    for (std::size_t i = first; i < last; ++i) box.extend(centroids[order[i]]);
    Eigen::Index axis;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = (first + last) / 2;
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                     [&](std::size_t a, std::size_t b) { return centroids[a][axis] < centroids[b][axis]; });
    const int left = addNodes(centroids, order, first, middle);
    const int right = addNodes(centroids, order, middle, last);
    nodes[index].left = left;
    nodes[index].right = right;
    return index;
}

BoxTree BoxTree::refitted(const Mesh& mesh, const std::vector<LongVector>& vertices) const {
    BoxTree result = *this;
    for (auto node = result.nodes.rbegin(); node != result.nodes.rend(); ++node) {
        if (node->isLeaf()) {
            fitLeaf(*node, mesh.triangles[node->triangle], vertices);
            continue;
        }
        const BoxNode& left = result.nodes[node->left];
        const BoxNode& right = result.nodes[node->right];
        for (int axis = 0; axis < 3; ++axis) {
            node->low[axis] = std::min(left.low[axis], right.low[axis]);
            node->high[axis] = std::max(left.high[axis], right.high[axis]);
        }
    }
    return result;
}

double lowerBound(const BoxNode& a, const BoxNode& b) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double gap = std::max({a.low[axis] - b.high[axis], b.low[axis] - a.high[axis], 0.0});
        squared += gap * gap;
    }
    return std::sqrt(squared) * (1 - 1e-14);  // lowered by more than the few roundings in it
}

double diagonalSquared(const BoxNode& node) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis)
        squared += (node.high[axis] - node.low[axis]) * (node.high[axis] - node.low[axis]);
    return squared;
}

}  // namespace clearway::testing
