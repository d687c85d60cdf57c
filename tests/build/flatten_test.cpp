#define BOOST_TEST_MODULE flatten
#include <boost/test/unit_test.hpp>
#include <set>
#include <stdexcept>

#include "build/build.h"
#include "build/check_tree.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
namespace {

/// A full binary tree over 16 single triangles in a row, node i with children 2 i + 1 and 2 i + 2, and areas
/// as given.
BinaryTree fullTree(const std::vector<double>& areas) {
    BinaryTree tree;
    tree.nodes.resize(31);
    for (int i = 30; i >= 0; --i) {
        BinaryNode& node = tree.nodes[i];
        if (i >= 15) {
            node.firstTriangle = static_cast<std::uint32_t>(i - 15);
            node.triangleCount = 1;
        } else {
            node.left = 2 * i + 1;
            node.right = 2 * i + 2;
            node.firstTriangle = tree.nodes[node.left].firstTriangle;
            node.triangleCount = tree.nodes[node.left].triangleCount + tree.nodes[node.right].triangleCount;
        }
        node.volume.halfLength0 = 1;
        node.volume.halfLength1 = areas[i] / 8;  // area 2 l w, without radius
    }
    for (std::uint32_t i = 0; i < 16; ++i) tree.order.push_back(i);
    return tree;
}

CleanMesh rowOfTriangles() {
    std::vector<Corners> triangles;
    for (int i = 0; i < 16; ++i) triangles.push_back({Vector3(i, 0, 0), Vector3(i, 1, 0), Vector3(i, 0, 1)});
    return cleanMeshOf(triangles);
}

/// Positions of the triangles below a lane.
std::set<std::uint32_t> below(const FlatTree& tree, std::int32_t child) {
    std::set<std::uint32_t> positions;
    if (child < 0) {
        const Leaf& leaf = tree.leaves[~child];
        for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) {
            positions.insert(tree.triangleIds[leaf.firstTriangle + i] - 7);
        }
        return positions;
    }
    for (const std::int32_t next : tree.nodes8[child].child) {
        if (next != kNoChild) positions.merge(below(tree, next));
    }
    return positions;
}

BOOST_AUTO_TEST_CASE(the_inner_child_of_largest_area_is_opened_until_there_are_eight) {
    // 1 is opened first, then 4, 3, 9, 8 and 7, which makes eight with 2 and 10 left closed. Leaves are never
    // opened, however large.
    std::vector<double> areas(31, 1000.0);
    const double inner[] = {200, 100, 1, 50, 60, 0.9, 0.9, 10, 20, 30, 5, 0.8, 0.8, 0.8, 0.8};
    std::copy(std::begin(inner), std::end(inner), areas.begin());
    const CleanMesh mesh = rowOfTriangles();
    const FlatTree tree = flatten(fullTree(areas), mesh, 8);
    checkTree(tree, mesh);
    std::set<std::set<std::uint32_t>> lanes;
    for (const std::int32_t child : tree.nodes8[tree.nodes8[0].child[0]].child)
        lanes.insert(below(tree, child));
    const std::set<std::set<std::uint32_t>> expected = {{0}, {1}, {2},    {3},
                                                        {4}, {5}, {6, 7}, {8, 9, 10, 11, 12, 13, 14, 15}};
    BOOST_TEST((lanes == expected));
}

BOOST_AUTO_TEST_CASE(width_two_keeps_the_binary_tree) {
    const CleanMesh mesh = cleanMeshOf(soup(300, 61));
    const BinaryTree binary = buildBinaryTree(mesh, {"axis", "none", 4, 2});
    std::multiset<std::uint32_t> binaryCounts;
    std::size_t innerNodes = 0;
    for (const BinaryNode& node : binary.nodes) {
        if (node.isLeaf()) {
            binaryCounts.insert(node.triangleCount);
        } else {
            ++innerNodes;
        }
    }
    const FlatTree tree = flatten(binary, mesh, 2);
    std::multiset<std::uint32_t> flatCounts;
    for (const Leaf& leaf : tree.leaves) flatCounts.insert(leaf.triangleCount);
    BOOST_TEST(tree.nodes2.size() == innerNodes + 1);  // and node 0, which holds the root's own volume
    BOOST_TEST((flatCounts == binaryCounts));
    for (std::size_t i = 1; i < tree.nodes2.size(); ++i) BOOST_TEST(tree.nodes2[i].child[1] != kNoChild);
}

BOOST_AUTO_TEST_CASE(lanes_stay_free_only_where_nothing_is_left_to_open) {
    const CleanMesh mesh = cleanMeshOf(soup(900, 62));
    const FlatTree tree = flatten(buildBinaryTree(mesh, {}), mesh, 8);
    for (std::size_t i = 1; i < tree.nodes8.size(); ++i) {
        if (tree.nodes8[i].child[7] != kNoChild) continue;
        for (const std::int32_t child : tree.nodes8[i].child) BOOST_REQUIRE((child < 0));
    }
}

BOOST_AUTO_TEST_CASE(children_of_a_node_are_numbered_together) {
    const CleanMesh mesh = cleanMeshOf(soup(900, 63));
    const FlatTree tree = flatten(buildBinaryTree(mesh, {}), mesh, 8);
    for (const WideNode<8>& node : tree.nodes8) {
        std::vector<std::int32_t> inner;
        std::vector<std::int32_t> leaves;
        for (const std::int32_t child : node.child) {
            if (child != kNoChild) (child >= 0 ? inner : leaves).push_back(child >= 0 ? child : ~child);
        }
        for (const auto& numbers : {inner, leaves}) {
            for (std::size_t i = 1; i < numbers.size(); ++i) BOOST_REQUIRE(numbers[i] == numbers[i - 1] + 1);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_unit_makes_the_mesh_fill_half_to_one) {
    for (const double scale : {1.0, 0x1p200, 0x1p-200, 3e7, 1e-5}) {
        const CleanMesh mesh = cleanMeshOf(transformed(soup(50, 64), scale, {0, 0, 0}));
        const FlatTree tree = flatten(buildBinaryTree(mesh, {}), mesh, 8);
        BOOST_TEST(tree.radius <= 1);
        BOOST_TEST(tree.radius >= 0.5);
    }
}

BOOST_AUTO_TEST_CASE(another_width_is_refused) {
    const CleanMesh mesh = rowOfTriangles();
    const BinaryTree binary = buildBinaryTree(mesh, {});
    BOOST_CHECK_EXCEPTION(flatten(binary, mesh, 3), std::invalid_argument,
                          [](const std::invalid_argument& error) {
                              return std::string(error.what()) == "nodeWidth is 3, expected one of: 8, 2";
                          });
}

}  // namespace
}  // namespace clearway::testing
