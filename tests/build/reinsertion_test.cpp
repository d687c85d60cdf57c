#include "build/reinsertion.h"

#include <boost/test/unit_test.hpp>
#include <numeric>

#include "build/general_splits.h"
#include "build/rate_nodes.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(reinsertion_test)

BinaryTree treeOf(const CleanMesh& mesh, GeneralSplit split) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    BinaryTree tree = split(mesh, all, 4);
    rateNodes(tree, mesh);
    return tree;
}

double sumOfAreas(const BinaryTree& tree) {
    double sum = 0;
    for (const BinaryNode& node : tree.nodes) sum += node.isLeaf() ? 0 : node.area;
    return sum / tree.nodes[0].area;
}

void checkTopology(const BinaryTree& tree, std::size_t triangles) {
    std::vector<int> seen(triangles, 0);
    for (const std::uint32_t triangle : tree.order) ++seen.at(triangle);
    BOOST_TEST((seen == std::vector<int>(triangles, 1)));
    BOOST_TEST(tree.nodes[0].triangleCount == triangles);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BinaryNode& node = tree.nodes[i];
        if (node.isLeaf()) continue;
        BOOST_REQUIRE((node.left > std::int32_t(i) && node.right > std::int32_t(i)));
        const BinaryNode &left = tree.nodes.at(node.left), &right = tree.nodes.at(node.right);
        BOOST_REQUIRE(left.firstTriangle == node.firstTriangle);
        BOOST_REQUIRE(right.firstTriangle == left.firstTriangle + left.triangleCount);
        BOOST_REQUIRE(node.triangleCount == left.triangleCount + right.triangleCount);
    }
}

BOOST_AUTO_TEST_CASE(the_nodes_areas_fall_in_sum_and_every_triangle_stays) {
    Random random(99);
    for (const CleanMesh& mesh :
         {cleanMeshOf(soup(2000, 98)), weldedMesh(cadAssembly(random, 3.0)), weldedMesh(torus(3, 1, 24))}) {
        for (const GeneralSplit split : {buildBySah, buildByMeanSplit}) {
            BinaryTree tree = treeOf(mesh, split);
            const double before = sumOfAreas(tree);
            const std::size_t nodes = tree.nodes.size();
            reinsertSubtrees(tree, mesh);
            BOOST_TEST(tree.nodes.size() == nodes);
            checkTopology(tree, mesh.triangles.size());
            rateNodes(tree, mesh);
            // Reinsertion measures boxes, not these volumes.
            BOOST_TEST(sumOfAreas(tree) < before * 1.02);
        }
    }
}

BOOST_AUTO_TEST_CASE(what_lies_apart_is_parted) {
    // Two clusters whose triangles take turns: each half of the tree holds both, until subtrees have moved.
    const std::vector<Corners> here = soup(64, 41), there = transformed(soup(64, 42), 1, {50, 0, 0});
    std::vector<Corners> triangles;
    for (std::size_t i = 0; i < 64; i += 16) {
        triangles.insert(triangles.end(), here.begin() + i, here.begin() + i + 16);
        triangles.insert(triangles.end(), there.begin() + i, there.begin() + i + 16);
    }
    const CleanMesh mesh = cleanMeshOf(triangles);
    BinaryTree tree;
    tree.nodes.resize(15);
    for (std::size_t i = 0; i < 15; ++i) {  // a balanced tree over runs of 16
        const std::uint32_t level = i == 0 ? 0 : i < 3 ? 1 : i < 7 ? 2 : 3;
        const std::uint32_t count = 128u >> level;
        tree.nodes[i].triangleCount = count;
        tree.nodes[i].firstTriangle = count * std::uint32_t(i + 1 - (std::size_t(1) << level));
        if (level == 3) continue;
        tree.nodes[i].left = std::int32_t(2 * i + 1);
        tree.nodes[i].right = std::int32_t(2 * i + 2);
    }
    tree.order.resize(128);
    std::iota(tree.order.begin(), tree.order.end(), 0u);
    reinsertSubtrees(tree, mesh);
    checkTopology(tree, 128);
    rateNodes(tree, mesh);
    int mixed = 0;  // nodes that reach from one cluster to the other
    for (const BinaryNode& node : tree.nodes) mixed += !node.isLeaf() && node.area > 0.3 * tree.nodes[0].area;
    BOOST_TEST(mixed == 1);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
