#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "mesh/topology.h"
#include "support/convex_hull.h"

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

    BOOST_TEST(testing::signedVolume(mesh) == 4 * 0.5 * 6.5, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(testing::areaOf(mesh) == 2 * (4 * 0.5 + 4 * 6.5 + 0.5 * 6.5),
               boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_box_that_is_none_is_refused_by_name) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Box wrong[] = {
        Box(), Box(Vector3(0, 0, 0), Vector3(1, -1, 1)), Box(Vector3(0, 0, 0), Vector3(1, infinity, 1)),
        Box(Vector3(0, 0, 0), Vector3(1, 1, 0)), Box(Vector3(0, std::nan(""), 0), Vector3(1, 1, 1))};
    for (const Box& box : wrong) testing::requireRefusedBy([&] { boxMesh(box, "tool"); }, {"'tool'"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
