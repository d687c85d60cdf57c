#include <boost/test/unit_test.hpp>
#include <limits>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/topology.h"

namespace clearway {

BOOST_AUTO_TEST_SUITE(box_mesh_test)

BOOST_AUTO_TEST_CASE(a_box_is_closed_faces_outwards_and_fills_its_corners) {
    const Box box(Vector3(-1, 2, 0.5), Vector3(3, 2.5, 7));
    const Mesh mesh = boxMesh(box, "keep out");
    BOOST_TEST(checkEdges(mesh.triangles).isClosed());
    BOOST_TEST((boundingBox(mesh).min() == box.min()));
    BOOST_TEST((boundingBox(mesh).max() == box.max()));
    BOOST_TEST_REQUIRE(mesh.components.size() == 1u);
    BOOST_TEST(mesh.components[0].name == "keep out");
    BOOST_TEST(mesh.components[0].triangleCount == mesh.triangles.size());

    // For a closed surface that faces outwards these terms sum to the volume, and the triangles' areas to the
    // box's area.
    double volume = 0, area = 0;
    for (const TriangleIndices& t : mesh.triangles) {
        const Vector3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        volume += a.dot(b.cross(c)) / 6;
        area += (b - a).cross(c - a).norm() / 2;
    }
    BOOST_TEST(volume == 4 * 0.5 * 6.5, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(area == 2 * (4 * 0.5 + 4 * 6.5 + 0.5 * 6.5), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_box_that_is_none_is_refused_by_name) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Box wrong[] = {
        Box(), Box(Vector3(0, 0, 0), Vector3(1, -1, 1)), Box(Vector3(0, 0, 0), Vector3(1, infinity, 1)),
        Box(Vector3(0, 0, 0), Vector3(1, 1, 0)), Box(Vector3(0, std::nan(""), 0), Vector3(1, 1, 1))};
    for (const Box& box : wrong) {
        BOOST_CHECK_EXCEPTION(boxMesh(box, "tool"), std::invalid_argument, [](const std::exception& error) {
            return std::string(error.what()).find("'tool'") != std::string::npos;
        });
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway
