#include "build/leaf_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/leaf/groups.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(chain_test)

Leaves chains(const std::vector<TriangleIndices>& triangles) {
    return leavesOf(splitGroup(splitIntoVertexChains, meshOf(triangles)));
}

BOOST_AUTO_TEST_CASE(one_shared_vertex_holds_triangles_together) {
    BOOST_TEST((chains({{0, 1, 2}, {2, 3, 4}, {5, 6, 7}, {7, 6, 8}}) == Leaves{{0, 1}, {2, 3}}));
    BOOST_TEST(
        (chains({{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {0, 7, 8}}) == Leaves{{0, 1, 2, 3}}));  // a fan by its tip
    BOOST_TEST((chains({{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}) == Leaves{{0}, {1}, {2}, {3}}));
    BOOST_TEST((chains({{0, 1, 2}}) == Leaves{{0}}));
}

BOOST_AUTO_TEST_CASE(a_chain_grows_from_any_of_its_links) {
    // 0 and 1 have nothing in common, 2 holds them together; 3 hangs on by 1 alone.
    BOOST_TEST((chains({{0, 1, 2}, {3, 4, 5}, {2, 6, 3}, {5, 7, 8}}) == Leaves{{0, 2, 1, 3}}));
}

BOOST_AUTO_TEST_CASE(points_and_segments_join_by_the_vertices_they_have) {
    BOOST_TEST((chains({{0, 0, 0}, {1, 2, 2}, {0, 3, 4}, {2, 5, 6}}) == Leaves{{0, 2}, {1, 3}}));
}

BOOST_AUTO_TEST_CASE(many_chains_hang_under_a_balanced_subtree) {
    std::vector<TriangleIndices> triangles;
    for (std::uint32_t i = 0; i < 13; ++i) triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    const CleanMesh mesh = meshOf(triangles);
    const BinaryTree tree = splitGroup(splitIntoVertexChains, mesh);
    BOOST_TEST(tree.nodes.size() == 2 * 13 - 1u);
    std::vector<int> depths(tree.nodes.size(), 0);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        BOOST_TEST(depths[i] <= 4);  // log2(13), rounded up
        if (tree.nodes[i].isLeaf()) continue;
        BOOST_TEST(static_cast<std::size_t>(tree.nodes[i].left) > i);
        BOOST_TEST(static_cast<std::size_t>(tree.nodes[i].right) > i);
        depths[tree.nodes[i].left] = depths[tree.nodes[i].right] = depths[i] + 1;
        const BinaryNode& left = tree.nodes[tree.nodes[i].left];
        const BinaryNode& right = tree.nodes[tree.nodes[i].right];
        BOOST_TEST(left.firstTriangle == tree.nodes[i].firstTriangle);
        BOOST_TEST(right.firstTriangle == left.firstTriangle + left.triangleCount);
        BOOST_TEST(left.triangleCount + right.triangleCount == tree.nodes[i].triangleCount);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
