#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

#include "build/build.h"
#include "build/check_tree.h"
#include "build/collapse.h"
#include "build/flatten.h"
#include "build/sample_meshes.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(flatten_test)

CleanMesh rowOfTriangles() {
    std::vector<Corners> triangles;
    for (int i = 0; i < 16; ++i) triangles.push_back({Vector3(i, 0, 0), Vector3(i, 1, 0), Vector3(i, 0, 1)});
    return cleanMeshOf(triangles);
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
    for (const LeafReference at : tree.leaves()) flatCounts.insert(tree.leaf(at).triangleCount);
    BOOST_TEST(tree.nodes<2>().size() == innerNodes + 1);  // and node 0, which holds the root's own volume
    BOOST_TEST((flatCounts == binaryCounts));
    for (std::size_t i = 1; i < tree.nodes<2>().size(); ++i)
        BOOST_TEST(tree.nodes<2>()[i].child[1] != kNoChild);
}

BOOST_AUTO_TEST_CASE(lanes_are_those_the_collapse_chose) {
    const CleanMesh mesh = cleanMeshOf(soup(900, 62));
    const BinaryTree binary = buildBinaryTree(mesh, {});
    const Collapse collapse(binary, 8);
    const FlatTree tree = flatten(binary, mesh, 8);
    // Both trees are walked depth first.
    std::vector<std::pair<std::int32_t, std::int32_t>> pending{{tree.nodes<8>()[0].child[0], 0}};
    std::size_t visited = 1;
    while (!pending.empty()) {
        const auto [wide, node] = pending.back();
        pending.pop_back();
        ++visited;
        Collapse::Lanes lanes;
        const auto count = std::size_t(collapse.lanesOf(node, lanes));
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const std::int32_t child = tree.nodes<8>()[wide].child[lane];
            BOOST_REQUIRE((child == kNoChild) == (lane >= count));
            if (lane >= count) continue;
            BOOST_REQUIRE((child < 0) == collapse.isLeaf(lanes[lane]));
            if (child >= 0) {
                pending.push_back({child, lanes[lane]});
            } else {
                BOOST_REQUIRE(tree.leaf(LeafReference(~child)).triangleCount ==
                              binary.nodes[lanes[lane]].triangleCount);
            }
        }
    }
    BOOST_TEST(visited == tree.nodes<8>().size());
}

BOOST_AUTO_TEST_CASE(children_of_a_node_are_numbered_together) {
    const CleanMesh mesh = cleanMeshOf(soup(900, 63));
    const FlatTree tree = flatten(buildBinaryTree(mesh, {}), mesh, 8);
    std::map<std::int32_t, std::int32_t> numberOfLeaf;
    for (const LeafReference at : tree.leaves()) {
        numberOfLeaf.emplace(std::int32_t(at), std::int32_t(numberOfLeaf.size()));
    }
    for (const WideNode<8>& node : tree.nodes<8>()) {
        std::vector<std::int32_t> inner;
        std::vector<std::int32_t> leaves;
        for (const std::int32_t child : node.child) {
            if (child == kNoChild) continue;
            child >= 0 ? inner.push_back(child) : leaves.push_back(numberOfLeaf.at(~child));
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
    requireRefusedBy([&] { flatten(binary, mesh, 3); }, {"nodeWidth is 3, expected one of 8, 2"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
