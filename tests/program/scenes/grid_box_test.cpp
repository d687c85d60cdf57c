#include "program/scenes/grid_box.h"

#include <boost/test/unit_test.hpp>

#include "program/scenes/scene_checks.h"
#include "support/convex_hull.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

const Box kBox(Vector3(-3, 1, 2), Vector3(17, 14, 5));

Mesh meshOf(std::size_t triangles) {
    Assembly assembly;
    assembly.add("box", gridBox(kBox, triangles));
    return assembly.mesh();
}

BOOST_AUTO_TEST_CASE(any_number_of_triangles_is_reached) {
    for (std::size_t n = 12; n < 400; ++n) BOOST_TEST(meshOf(n).triangles.size() == n - n % 2);
    BOOST_TEST(meshOf(100001).triangles.size() == 100000);
}

BOOST_AUTO_TEST_CASE(it_is_a_closed_solid_of_the_box) {
    for (const std::size_t n : {12, 14, 100, 346, 5000}) {
        const Mesh mesh = meshOf(n);
        BOOST_TEST(isClosed(mesh, mesh.components[0]));
        BOOST_TEST(signedVolume(mesh) == kBox.volume(), boost::test_tools::tolerance(1e-6));
        BOOST_TEST((boundingBox(mesh).min() == kBox.min()));
        BOOST_TEST((boundingBox(mesh).max() == kBox.max()));
    }
}

BOOST_AUTO_TEST_CASE(every_triangle_lies_in_a_face_exactly_and_none_is_degenerate) {
    const Mesh mesh = meshOf(700);
    for (const TriangleIndices& t : mesh.triangles) {
        const Vector3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        bool isInFace = false;
        for (int axis = 0; axis < 3; ++axis) {
            isInFace = isInFace || (a[axis] == b[axis] && b[axis] == c[axis] &&
                                    (a[axis] == kBox.min()[axis] || a[axis] == kBox.max()[axis]));
        }
        BOOST_TEST(isInFace);
        BOOST_TEST((b - a).cross(c - a).norm() > 0.01);
    }
}

}  // namespace
