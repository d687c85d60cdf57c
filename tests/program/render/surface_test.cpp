#include "program/render/surface.h"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(surface_test)

using namespace render;

double areaOf(const Surface& surface) {
    double area = 0;
    for (const TriangleIndices& triangle : surface.triangles) {
        const Vector3f& a = surface.vertices[triangle[0]];
        area += 0.5 * (surface.vertices[triangle[1]] - a).cross(surface.vertices[triangle[2]] - a).norm();
    }
    return area;
}

const Mesh plate = windowScene().partMesh;  // 60 x 40 x 10
constexpr double kPlateArea = 2 * (60 * 40 + 60 * 10 + 40 * 10);

BOOST_AUTO_TEST_CASE(coordinates_are_moved_and_scaled) {
    const Surface surface = surfaceOf(plate, {30, 20, 5}, 0.1);
    BOOST_TEST(areaOf(surface) == kPlateArea / 100, boost::test_tools::tolerance(1e-5));
    for (const Vector3f& vertex : surface.vertices) {
        BOOST_TEST(vertex.maxCoeff() <= 1e-6f);
        BOOST_TEST(vertex.x() >= -6 - 1e-5f);
    }
}

BOOST_AUTO_TEST_CASE(normals_keep_creases) {
    const Surface surface = surfaceOf(plate, Vector3::Zero(), 1);
    for (const auto& corners : surface.normals) {
        for (const Vector3f& normal : corners) {  // a box has no round edge: each is along an axis
            BOOST_TEST(normal.cwiseAbs().maxCoeff() > 1 - 1e-5f);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_cut_leaves_what_is_on_its_other_side_and_no_more) {
    const Surface whole = surfaceOf(plate, Vector3::Zero(), 1);
    const Surface left = cutBy({Vector3::UnitX(), 10}, whole);  // 40 of the 60 are left, and one end
    BOOST_TEST(areaOf(left) == 40 * 2 * (40 + 10) + 40 * 10, boost::test_tools::tolerance(1e-5));
    for (const Vector3f& vertex : left.vertices) BOOST_TEST(vertex.x() <= 10 + 1e-4f);
    const Surface right = cutBy({-Vector3::UnitX(), -10}, whole);
    BOOST_TEST(areaOf(left) + areaOf(right) == kPlateArea, boost::test_tools::tolerance(1e-5));
    const Vector3 askew = Vector3(1, 2, -0.5).normalized();
    BOOST_TEST(areaOf(cutBy({askew, 3}, whole)) + areaOf(cutBy({-askew, -3}, whole)) == kPlateArea,
               boost::test_tools::tolerance(1e-5));
    BOOST_TEST(cutBy({Vector3::UnitX(), -31}, whole).triangles.empty());
    BOOST_TEST(areaOf(cutBy({Vector3::UnitX(), 31}, whole)) == kPlateArea,
               boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
