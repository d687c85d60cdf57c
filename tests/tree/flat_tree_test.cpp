#include "tree/flat_tree.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "build/build.h"
#include "build/flatten.h"
#include "build/sample_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(flat_tree_test)

namespace {

/// Node 0 above node 1, which has two leaves and node 2, which has one leaf.
FlatTree handMadeTree() {
    FlatTree tree;
    WideNode<8> empty{};
    for (std::int32_t& child : empty.child) child = kNoChild;
    tree.nodes<8>().assign(3, empty);
    tree.nodes<8>()[0].child[0] = 1;
    tree.nodes<8>()[1].child[0] = ~0;
    tree.nodes<8>()[1].child[1] = 2;
    tree.nodes<8>()[1].child[2] = ~1;
    tree.nodes<8>()[2].child[0] = ~2;
    tree.leaves.resize(3);
    tree.leaves[0].triangleCount = 3;
    tree.leaves[1].triangleCount = 1;
    tree.leaves[2].triangleCount = 3;
    return tree;
}

BOOST_AUTO_TEST_CASE(a_hand_made_tree_is_counted_right) {
    const TreeStatistics counted = statistics(handMadeTree());
    BOOST_TEST(counted.nodes == 3u);
    BOOST_TEST(counted.leaves == 3u);
    BOOST_TEST((counted.leavesBySize == std::vector<std::size_t>{0, 1, 0, 2}));
    BOOST_TEST(counted.depth == 3);
    BOOST_TEST(counted.meanChildren == 5.0 / 3);
    BOOST_TEST(counted.bytes == sizeof(FlatTree) + 3 * 448 + 3 * sizeof(Leaf));
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
    BOOST_TEST(counted.bytes > 9 * sizeof(float) * triangles + sizeof(Vector3) * mesh.vertices.size());
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
