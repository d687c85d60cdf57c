// Checks the invariants of flat trees in long double from the stored values.
#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "mesh/clean.h"
#include "tree/flat_tree.h"
#include "tree/stored_volume.h"

namespace clearway::testing {

inline LongVector inTreeUnits(const FlatTree& tree, const Vector3& point) {
    const LongVector offset = point.cast<long double>() - tree.origin.cast<long double>();
    return offset * std::ldexp(1.0L, -tree.unitExponent);
}

template <int kWidth>
FloatRss volumeOf(const WideNode<kWidth>& node, int lane) {
    FloatRss volume;
    for (int i = 0; i < 3; ++i) {
        volume.centre[i] = node.centre[i][lane];
        volume.axis0[i] = node.axis0[i][lane];
        volume.axis1[i] = node.axis1[i][lane];
    }
    volume.halfLength0 = node.halfLength0[lane];
    volume.halfLength1 = node.halfLength1[lane];
    volume.radius = node.radius[lane];
    return volume;
}

/// Walks a tree and checks it against its mesh. Counts failures instead of reporting each vertex.
template <int kWidth>
class TreeChecker {
  public:
    TreeChecker(const FlatTree& tree, const CleanMesh& mesh) : tree_(tree), mesh_(mesh) {}

    void check() {
        const std::vector<WideNode<kWidth>>& nodes = tree_.nodes<kWidth>();
        nodeSeen_.assign(nodes.size(), 0);
        leafSeen_.assign(tree_.leaves.size(), 0);
        nodeSeen_[0] = 1;
        BOOST_TEST(nodes[0].child[1] == kNoChild);
        below(0);
        BOOST_TEST(verticesOutside_ == 0u);
        BOOST_TEST(wrongLanes_ == 0u);
        BOOST_TEST((nodeSeen_ == std::vector<int>(nodes.size(), 1)), "each node is reached once");
        BOOST_TEST((leafSeen_ == std::vector<int>(tree_.leaves.size(), 1)), "each leaf is reached once");
        checkTriangles();
        checkLeaves();
    }

  private:
    /// The vertices below a node, all checked against the volumes above them.
    std::set<std::uint32_t> below(std::int32_t index) {
        const WideNode<kWidth>& node = tree_.nodes<kWidth>()[index];
        std::set<std::uint32_t> all;
        bool pastTheLast = false;
        for (int lane = 0; lane < kWidth; ++lane) {
            const std::int32_t child = node.child[lane];
            if (child == kNoChild) {
                pastTheLast = true;
                if (!isUnusedLane(node, lane)) ++wrongLanes_;
                continue;
            }
            if (pastTheLast) ++wrongLanes_;  // used lanes come first
            const long double radius = node.radius[lane];
            const long double size =
                2 * std::sqrt((node.halfLength0[lane] + radius) * (node.halfLength1[lane] + radius));
            if (!(std::abs(node.size[lane] - size) <= 1e-6L * size)) ++wrongLanes_;
            if (child >= 0) ++nodeSeen_.at(child);
            const std::set<std::uint32_t> vertices = child >= 0 ? below(child) : inLeaf(~child);
            const FloatRss volume = volumeOf(node, lane);
            for (const std::uint32_t vertex : vertices) {
                const LongVector point = inTreeUnits(tree_, tree_.vertices[vertex]);
                if (!(distanceFromRectangle(volume, point) <= volume.radius)) ++verticesOutside_;
            }
            all.insert(vertices.begin(), vertices.end());
        }
        return all;
    }

    static bool isUnusedLane(const WideNode<kWidth>& node, int lane) {
        bool allZero = node.halfLength0[lane] == 0 && node.halfLength1[lane] == 0 && node.size[lane] == 0;
        for (int i = 0; i < 3; ++i) {
            allZero =
                allZero && node.centre[i][lane] == 0 && node.axis0[i][lane] == 0 && node.axis1[i][lane] == 0;
        }
        return allZero && node.radius[lane] == -std::numeric_limits<float>::infinity();
    }

    std::set<std::uint32_t> inLeaf(std::int32_t index) {
        ++leafSeen_.at(index);
        const Leaf& leaf = tree_.leaves[index];
        std::set<std::uint32_t> vertices;
        for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) {
            const auto& triangle = tree_.triangles.at(leaf.firstTriangle + i);
            vertices.insert(triangle.begin(), triangle.end());
        }
        return vertices;
    }

    /// Checks that each triangle of the mesh is there once, with its id and its exact vertices.
    void checkTriangles() const {
        BOOST_TEST(tree_.triangles.size() == mesh_.triangles.size());
        BOOST_TEST(tree_.vertices.size() == mesh_.vertices.size());
        std::set<std::uint32_t> ids;
        for (std::size_t i = 0; i < tree_.triangles.size(); ++i) {
            const std::uint32_t id = tree_.triangleIds.at(i);
            ids.insert(id);
            const TriangleIndices& original = mesh_.triangles.at(id - 7);  // as cleanMeshOf numbers them
            for (int corner = 0; corner < 3; ++corner) {
                BOOST_REQUIRE(tree_.vertices.at(tree_.triangles[i][corner]) ==
                              mesh_.vertices[original[corner]]);
            }
        }
        BOOST_TEST(ids.size() == mesh_.triangles.size());
    }

    /// Checks that leaves cover the triangles in order, and that their floats are the vertices relative to
    /// the leaf's centre and within its radius.
    void checkLeaves() const {
        std::uint32_t next = 0;
        const long double perUnit = std::ldexp(1.0L, -tree_.unitExponent);
        for (const Leaf& leaf : tree_.leaves) {
            BOOST_REQUIRE(leaf.firstTriangle == next);
            BOOST_REQUIRE((leaf.triangleCount >= 1 && leaf.triangleCount <= 16));
            next += leaf.triangleCount;
            const LongVector centre(leaf.centre[0], leaf.centre[1], leaf.centre[2]);
            for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) {
                for (int corner = 0; corner < 3; ++corner) {
                    const Vector3& vertex = tree_.vertices[tree_.triangles[leaf.firstTriangle + i][corner]];
                    const LongVector offset = (vertex.cast<long double>() - centre) * perUnit;
                    BOOST_REQUIRE(offset.norm() <= leaf.radius);
                    for (int k = 0; k < 3; ++k) {
                        const float stored = tree_.leafVertices.at(9 * leaf.firstTriangle +
                                                                   (3 * corner + k) * leaf.triangleCount + i);
                        BOOST_REQUIRE(std::abs(stored - offset[k]) <=
                                      0x1.01p-24L * std::abs(offset[k]) + 0x1p-150L);
                    }
                }
            }
        }
        BOOST_TEST(next == tree_.triangles.size());
        BOOST_TEST(tree_.leafVertices.size() == 9 * tree_.triangles.size() + kLeafPadding);
    }

    const FlatTree& tree_;
    const CleanMesh& mesh_;
    std::vector<int> nodeSeen_;
    std::vector<int> leafSeen_;
    std::size_t verticesOutside_ = 0;
    std::size_t wrongLanes_ = 0;
};

inline void checkTree(const FlatTree& tree, const CleanMesh& mesh) {
    BOOST_TEST(tree.radius <= 1);
    std::apply([&](const auto&... nodes) { BOOST_TEST((!nodes.empty() + ...) == 1); }, tree.nodesByWidth);
    for (const Vector3& vertex : tree.vertices) {
        BOOST_REQUIRE(inTreeUnits(tree, vertex).norm() <= tree.radius);
        BOOST_REQUIRE(vertex.cast<long double>().norm() <= tree.radiusAboutMeshOrigin);
        BOOST_REQUIRE(tree.box.contains(vertex));
    }
    withNodeWidth(tree.nodeWidth, [&](auto width) { TreeChecker<width>(tree, mesh).check(); });
}

}  // namespace clearway::testing
