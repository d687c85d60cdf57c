// Checks the invariants of flat trees in long double from the stored values.
#pragma once

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "mesh/clean.h"
#include "support/tree_triangles.h"
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
        const LargeVector<WideNode<kWidth>>& nodes = tree_.nodes<kWidth>();
        nodeSeen_.assign(nodes.size(), 0);
        leafSeen_.assign(tree_.leafBlocks.size(), 0);
        nodeSeen_[0] = 1;
        BOOST_TEST(nodes[0].child[1] == kNoChild);
        below(0);
        BOOST_TEST(cornersOutside_ == 0u);
        BOOST_TEST(wrongLanes_ == 0u);
        BOOST_TEST((nodeSeen_ == std::vector<int>(nodes.size(), 1)), "each node is reached once");
        std::vector<int> leaves(tree_.leafBlocks.size(), 0);
        for (const LeafReference at : tree_.leaves()) leaves.at(at) = 1;
        BOOST_TEST((leafSeen_ == leaves), "each leaf is reached once");
        checkTriangles();
        checkLeaves();
    }

  private:
    /// The triangles below a node, their corners all checked against the volumes above them.
    std::vector<TriangleAt> below(std::int32_t index) {
        const WideNode<kWidth>& node = tree_.nodes<kWidth>()[index];
        std::vector<TriangleAt> all;
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
            const std::vector<TriangleAt> triangles =
                child >= 0 ? below(child) : inLeaf(LeafReference(~child));
            const FloatRss volume = volumeOf(node, lane);
            for (const TriangleAt triangle : triangles) {
                for (const Vector3& corner : tree_.corners(triangle)) {
                    const LongVector point = inTreeUnits(tree_, corner);
                    if (!(distanceFromRectangle(volume, point) <= volume.radius)) ++cornersOutside_;
                }
            }
            all.insert(all.end(), triangles.begin(), triangles.end());
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

    std::vector<TriangleAt> inLeaf(LeafReference at) {
        ++leafSeen_.at(at);
        std::vector<TriangleAt> triangles;
        for (std::uint32_t i = 0; i < tree_.leaf(at).triangleCount; ++i) triangles.push_back({at, i});
        return triangles;
    }

    /// Checks that each triangle of the mesh is there once, with its id and its exact vertices.
    void checkTriangles() const {
        const std::vector<TriangleAt> triangles = trianglesOf(tree_);
        BOOST_TEST(triangles.size() == mesh_.triangles.size());
        std::set<std::uint32_t> ids;
        for (const TriangleAt triangle : triangles) {
            const std::uint32_t id = tree_.triangleId(triangle);
            ids.insert(id);
            const TriangleIndices& original = mesh_.triangles.at(id - 7);  // as cleanMeshOf numbers them
            const std::array<Vector3, 3> corners = tree_.corners(triangle);
            for (std::size_t k = 0; k < 3; ++k) {
                BOOST_REQUIRE((corners[k] == mesh_.vertices[original[k]]));
            }
        }
        BOOST_TEST(ids.size() == mesh_.triangles.size());
    }

    /// Checks that the leaves' floats are the vertices relative to the leaf's centre and within its radius.
    void checkLeaves() const {
        const long double perUnit = std::ldexp(1.0L, -tree_.unitExponent);
        for (const TriangleAt triangle : trianglesOf(tree_)) {
            const Leaf leaf = tree_.leaf(triangle.leaf);
            BOOST_REQUIRE((leaf.triangleCount >= 1 && leaf.triangleCount <= 16));
            const LongVector centre(leaf.centre[0], leaf.centre[1], leaf.centre[2]);
            const std::array<Vector3, 3> corners = tree_.corners(triangle);
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const LongVector offset = (corners[corner].cast<long double>() - centre) * perUnit;
                BOOST_REQUIRE(offset.norm() <= leaf.radius);
                for (int k = 0; k < 3; ++k) {
                    const float stored =
                        leaf.offsets[(3 * corner + std::size_t(k)) * leaf.triangleCount + triangle.number];
                    BOOST_REQUIRE(std::abs(stored - offset[k]) <=
                                  0x1.01p-24L * std::abs(offset[k]) + 0x1p-150L);
                }
            }
        }
        BOOST_TEST(faultOf(tree_, mesh_.triangles.size() + 7) == "");
    }

    const FlatTree& tree_;
    const CleanMesh& mesh_;
    std::vector<int> nodeSeen_;
    std::vector<int> leafSeen_;
    std::size_t cornersOutside_ = 0;
    std::size_t wrongLanes_ = 0;
};

inline void checkTree(const FlatTree& tree, const CleanMesh& mesh) {
    BOOST_TEST(tree.radius <= 1);
    std::apply([&](const auto&... nodes) { BOOST_TEST((!nodes.empty() + ...) == 1); }, tree.nodesByWidth);
    for (const Vector3& vertex : mesh.vertices) {
        BOOST_REQUIRE(inTreeUnits(tree, vertex).norm() <= tree.radius);
        BOOST_REQUIRE(vertex.cast<long double>().norm() <= tree.radiusAboutMeshOrigin);
        BOOST_REQUIRE(tree.box.contains(vertex));
    }
    withNodeWidth(tree.nodeWidth, [&](auto width) { TreeChecker<width>(tree, mesh).check(); });
}

}  // namespace clearway::testing
