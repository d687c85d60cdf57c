#include "build/fits.h"

#include <boost/test/unit_test.hpp>

#include "build/build.h"
#include "build/sample_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(frames_test)

namespace {

constexpr double kFloatRounding = 1e-5;    // relative: frames are compared in float
constexpr double kDoubleRounding = 1e-12;  // of the meshes' size squared: the area of a segment

bool isAtMost(const Rss& a, const Rss& b) {
    return a.area() <= b.area() * (1 + kFloatRounding) + kDoubleRounding;
}

std::vector<CleanMesh> sampleMeshes() {
    Random random(97);
    return {cleanMeshOf(soup(700, 96)), cleanMeshOf(bentSheet(40, 9)), weldedMesh(cadAssembly(random, 3.0)),
            weldedMesh(torus(3, 1, 12))};
}

BinaryTree binaryTree(const CleanMesh& mesh, const std::string& fit) {
    return buildBinaryTree(mesh, {"sah", "none", 1, 8, fit});
}

BOOST_AUTO_TEST_CASE(no_volume_is_larger_than_in_the_frame_of_the_vertices_covariance) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        const BinaryTree tree = binaryTree(mesh, "frames");
        const LeafOrder order(mesh, tree.order);
        LeafOrder::Gathered gathered;
        for (const BinaryNode& node : tree.nodes) {
            order.gatherVertices(node.firstTriangle, node.triangleCount, gathered);
            BOOST_REQUIRE(isAtMost(node.volume, fitRss(gathered.points)));
            BOOST_REQUIRE(isAtMost(node.volume, fitRss(gathered.points, Matrix3::Identity())));
        }
    }
}

BOOST_AUTO_TEST_CASE(no_volume_is_larger_than_with_its_parents_axes) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        const BinaryTree tree = binaryTree(mesh, "frames");
        const LeafOrder order(mesh, tree.order);
        LeafOrder::Gathered gathered;
        for (const BinaryNode& parent : tree.nodes) {
            if (parent.isLeaf()) continue;
            for (const std::int32_t child : {parent.left, parent.right}) {
                const BinaryNode& node = tree.nodes[child];
                order.gatherVertices(node.firstTriangle, node.triangleCount, gathered);
                BOOST_REQUIRE(isAtMost(node.volume, fitRss(gathered.points, parent.volume.axes)));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(the_whole_tree_gets_smaller_than_by_covariance) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        double frames = 0;
        double covariance = 0;
        for (const BinaryNode& node : binaryTree(mesh, "frames").nodes) frames += node.volume.area();
        for (const BinaryNode& node : binaryTree(mesh, "covariance").nodes) covariance += node.volume.area();
        BOOST_TEST(frames < 0.97 * covariance);
    }
}

BOOST_AUTO_TEST_CASE(one_triangle_is_fitted_flat_along_an_edge) {
    const CleanMesh mesh = cleanMeshOf({{Vector3(1, 1, 1), Vector3(5, 3, 2), Vector3(2, 4, 7)}});
    const Rss volume = binaryTree(mesh, "frames").nodes[0].volume;
    const Vector3 a = mesh.vertices[0], b = mesh.vertices[1], c = mesh.vertices[2];
    // For a triangle without an obtuse or right angle, the area of the least rectangle around it is twice its
    // own area.
    BOOST_TEST(volume.area() == 2 * (b - a).cross(c - a).norm(), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(volume.radius < 1e-14);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
