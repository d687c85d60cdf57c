#include "tree/flat_tree.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <climits>
#include <cmath>
#include <string>

#include "build/build.h"
#include "build/flatten.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(flat_tree_test)

/// A leaf's block: all floats are 0.5, the ids count on from the first one, all numbers of vertices are 0.
void addBlock(FlatTree& tree, std::uint32_t triangles, bool isExact, std::uint32_t firstId) {
    std::vector<float> block(leafBlockSize(triangles, isExact), 0.5f);
    storeWholeNumber(triangles + (isExact ? 0 : kHasVertices), block[kLeafHeader - 1]);
    for (std::uint32_t i = kLeafHeader + 9 * triangles, id = firstId; i < block.size(); ++i, ++id)
        storeWholeNumber(id < firstId + triangles ? id : 0, block[i]);
    tree.leafBlocks.insert(tree.leafBlocks.end(), block.begin(), block.end());
}

/// Node 0 above node 1, which has two leaves and node 2, which has one leaf. The last leaf is not exact.
FlatTree handMadeTree() {
    FlatTree tree;
    WideNode<8> empty{};
    for (std::int32_t& child : empty.child) child = kNoChild;
    tree.nodes<8>().assign(3, empty);
    addBlock(tree, 3, true, 0);
    const auto second = std::int32_t(tree.leafBlocks.size());
    addBlock(tree, 1, true, 3);
    const auto third = std::int32_t(tree.leafBlocks.size());
    addBlock(tree, 3, false, 4);
    tree.leafBlocks.resize(tree.leafBlocks.size() + kLeafPadding, 0.0f);
    tree.vertices.assign(1, Vector3(1, 2, 3));
    tree.box.extend(tree.vertices[0]);
    tree.nodes<8>()[0].child[0] = 1;
    tree.nodes<8>()[1].child[0] = ~0;
    tree.nodes<8>()[1].child[1] = 2;
    tree.nodes<8>()[1].child[2] = ~second;
    tree.nodes<8>()[2].child[0] = ~third;
    return tree;
}

/// Puts nodes with one child each above the last leaf.
void deepen(FlatTree& tree, int by) {
    auto& nodes = tree.nodes<8>();
    for (; by > 0; --by) {
        nodes.push_back(nodes.back());
        nodes[nodes.size() - 2].child[0] = std::int32_t(nodes.size() - 1);
    }
}

BOOST_AUTO_TEST_CASE(a_hand_made_tree_is_counted_right) {
    const TreeStatistics counted = statistics(handMadeTree());
    BOOST_TEST(counted.nodes == 3u);
    BOOST_TEST(counted.leaves == 3u);
    BOOST_TEST((counted.leavesBySize == std::vector<std::size_t>{0, 1, 0, 2}));
    BOOST_TEST(counted.depth == 3);
    BOOST_TEST(counted.meanChildren == 5.0 / 3);
    // Blocks have 5 floats, and 10 or 13 for each triangle.
    BOOST_TEST(counted.bytes ==
               sizeof(FlatTree) + 3 * 448 + 4 * (35 + 15 + 44 + kLeafPadding) + sizeof(Vector3));
}

BOOST_AUTO_TEST_CASE(exact_leaves_hold_their_corners_and_others_refer_to_them) {
    FlatTree tree = handMadeTree();
    tree.origin = {100, 0, 0};
    tree.unit = 4;
    const std::vector<LeafReference> leaves = tree.leaves();
    BOOST_TEST_REQUIRE(leaves.size() == 3u);
    BOOST_TEST(tree.leaf(leaves[0]).isExact);
    BOOST_TEST(!tree.leaf(leaves[2]).isExact);
    BOOST_TEST((tree.corners({leaves[0], 2})[1] == Vector3(104, 4, 4)));  // centre and offset are half a unit
    BOOST_TEST((tree.corners({leaves[2], 2})[1] == Vector3(1, 2, 3)));
}

BOOST_AUTO_TEST_CASE(each_fault_of_a_tree_is_found) {
    const auto faultAfter = [](auto&& change) {
        FlatTree tree = handMadeTree();
        change(tree);
        return faultOf(tree, 7);
    };
    const auto write = [](FlatTree& tree, std::size_t place, std::uint32_t number) {
        storeWholeNumber(number, tree.leafBlocks.at(place));
    };
    const std::string cut = "its last leaf is cut off",
                      many = "its leaves hold an impossible number of triangles",
                      notFinite = "its coordinates are not finite";
    const auto childAfter = [&](int node, int lane, std::int32_t child) {
        return faultAfter([&](FlatTree& tree) { tree.nodes<8>()[node].child[lane] = child; });
    };
    BOOST_TEST(faultAfter([](FlatTree&) {}) == "");
    BOOST_TEST(childAfter(1, 0, ~1) == "node 1 refers to what is not there");
    BOOST_TEST(childAfter(1, 0, ~10000) == "node 1 refers to what is not there");
    BOOST_TEST(childAfter(1, 0, 3) == "node 1 refers to what is not there");
    BOOST_TEST(childAfter(2, 0, 1) == "node 2 refers to what is not there");  // a circle
    BOOST_TEST(childAfter(2, 0, 2) == "node 2 refers to what is not there");
    BOOST_TEST(childAfter(1, 0, 2) == "node 1 shares a child");
    BOOST_TEST(childAfter(2, 0, ~0) == "node 2 shares a child");
    BOOST_TEST(childAfter(1, 2, kNoChild) == "the leaf at 35 has no parent");
    BOOST_TEST(childAfter(1, 0, kNoChild) == "node 1 has an impossible number of children");
    BOOST_TEST(childAfter(2, 0, kNoChild) == "node 2 has an impossible number of children");
    BOOST_TEST(childAfter(0, 1, 2) == "node 0 has an impossible number of children");
    BOOST_TEST(faultAfter([](FlatTree& tree) {
                   std::swap(tree.nodes<8>()[1].child[1], tree.nodes<8>()[1].child[2]);
                   tree.nodes<8>()[1].child[2] = kNoChild;
               }) == "node 2 has no parent");
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.nodes<2>().resize(1); }) ==
               "its nodes are not all 8 wide");
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.nodes<8>().clear(); }) == "its nodes are not all 8 wide");
    BOOST_TEST(faultAfter([](FlatTree& tree) { deepen(tree, kDeepestTree - 3); }) == "");
    BOOST_TEST(faultAfter([](FlatTree& tree) { deepen(tree, kDeepestTree - 2); }) ==
               "node 256 is below 256 others");
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.leafBlocks.pop_back(); }) == cut);
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.leafBlocks.clear(); }) ==
               "node 1 refers to what is not there");
    BOOST_TEST(faultAfter([&](FlatTree& tree) { write(tree, 4, 0); }) == many);
    BOOST_TEST(faultAfter([&](FlatTree& tree) { write(tree, 4, 17); }) == many);
    BOOST_TEST(faultAfter([&](FlatTree& tree) { write(tree, 4, 64 + 3); }) == many);
    BOOST_TEST(faultAfter([&](FlatTree& tree) { write(tree, 5 + 27, 7); }) ==
               "its triangle ids are out of range");
    BOOST_TEST(faultAfter([&](FlatTree& tree) { write(tree, 5 + 27, 6); }) ==
               "its leaves hold triangle 6 twice");
    BOOST_TEST(faultAfter([&](FlatTree& tree) { write(tree, 35 + 15 + 5 + 27 + 3, 1); }) ==
               "its triangles refer to vertices that are not there");
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.leafBlocks[31] = NAN; }) == notFinite);
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.leafBlocks[3] = INFINITY; }) == notFinite);
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.vertices[0].x() = NAN; }) == notFinite);
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.nodes<8>()[2].size[0] = NAN; }) ==
               "node 2 has a volume that is not finite");
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.nodes<8>()[2].size[1] = NAN; }) == "");  // an unused lane
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.radiusAboutMeshOrigin = NAN; }) == notFinite);
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.unitExponent = 1001; }) == notFinite);
    BOOST_TEST(faultAfter([](FlatTree& tree) { tree.unitExponent = INT_MIN; }) == notFinite);
}

BOOST_DATA_TEST_CASE(counts_of_a_built_tree_add_up, boost::unit_test::data::make(nodeWidths()), width) {
    const CleanMesh mesh = cleanMeshOf(bentSheet(30, 10));
    const FlatTree tree = flatten(buildBinaryTree(mesh, {"axis", "chain", 4, width}), mesh, width);
    const TreeStatistics counted = statistics(tree);
    std::size_t leaves = 0;
    std::size_t triangles = 0;
    for (std::size_t size = 1; size < counted.leavesBySize.size(); ++size) {
        leaves += counted.leavesBySize[size];
        triangles += size * counted.leavesBySize[size];
    }
    BOOST_TEST(counted.leavesBySize.size() <= 5u);
    BOOST_TEST(leaves == counted.leaves);
    BOOST_TEST(triangles == mesh.triangles.size());
    BOOST_TEST(counted.nodes == tree.nodes<2>().size() + tree.nodes<8>().size());
    // Each node and leaf except node 0 is the child of one node.
    BOOST_TEST(counted.meanChildren * counted.nodes == double(counted.nodes - 1 + counted.leaves),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(counted.depth >= (width == 2 ? 8 : 4));
    BOOST_TEST(counted.bytes > 9 * sizeof(float) * triangles);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
