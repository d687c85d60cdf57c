#include "program/render/rays.h"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "program/render/camera.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(rays_test)

using namespace render;

/// The plate, 60 x 40 x 10, at the origin and once more, turned upright, at x = 100.
struct TwoPlates {
    Surface plate = surfaceOf(windowScene().partMesh, Vector3::Zero(), 1);
    RayScene scene;
    TwoPlates() {
        const std::size_t shape = scene.addShape(plate);
        scene.addBody(shape, {});
        scene.addBody(
            shape, {Eigen::AngleAxisf(float(M_PI / 2), Vector3f::UnitY()).toRotationMatrix(), {100, 0, 0}});
        scene.finish();
    }
};

constexpr auto kClose = 1e-4f;

BOOST_AUTO_TEST_CASE(the_nearest_body_is_met_where_it_stands) {
    const TwoPlates plates;
    const RayHit first = plates.scene.nearest({{-100, 1, 1}, {1, 0, 0}});
    BOOST_TEST(first.isHit);
    BOOST_TEST(first.body == 0u);
    BOOST_TEST(first.along == 70, boost::test_tools::tolerance(kClose));
    const RayHit second = plates.scene.nearest({{200, 1, 1}, {-2, 0, 0}});
    BOOST_TEST(second.body == 1u);
    BOOST_TEST(second.along == 47.5f, boost::test_tools::tolerance(kClose));  // upright it is 10 thick
    BOOST_TEST(plates.scene.nearest({{100, 1, 29}, {-1, 0, 0}}).body == 1u);
    BOOST_TEST(!plates.scene.nearest({{-100, 1, 1}, {-1, 0, 0}}).isHit);
    BOOST_TEST(plates.scene.nearest({{-100, 1, 1}, {1, 0, 0}, 75}).along > 75);
}

BOOST_AUTO_TEST_CASE(a_hit_names_the_triangle_and_the_place_in_it) {
    const TwoPlates plates;
    const Ray ray{{7, 3, 100}, {0, 0, -1}};
    const RayHit hit = plates.scene.nearest(ray);
    const TriangleIndices& triangle = plates.plate.triangles[hit.triangle];
    const Vector3f place = (1 - hit.u - hit.v) * plates.plate.vertices[triangle[0]] +
                           hit.u * plates.plate.vertices[triangle[1]] +
                           hit.v * plates.plate.vertices[triangle[2]];
    BOOST_TEST((place - Vector3f(7, 3, 5)).norm() < 1e-3f);
}

BOOST_AUTO_TEST_CASE(what_is_in_the_way_counts_up_to_the_length_given) {
    const TwoPlates plates;
    BOOST_TEST(plates.scene.isBlocked({{-100, 1, 1}, {1, 0, 0}}, 71));
    BOOST_TEST(!plates.scene.isBlocked({{-100, 1, 1}, {1, 0, 0}}, 69));
    BOOST_TEST(!plates.scene.isBlocked({{-100, 1, 6}, {1, 0, 0}}, 150));
}

BOOST_AUTO_TEST_CASE(a_surface_without_triangles_is_never_met) {
    RayScene scene;
    scene.addBody(scene.addShape({}), {});
    scene.finish();
    BOOST_TEST(!scene.nearest({{0, 0, 0}, {1, 0, 0}}).isHit);
}

BOOST_AUTO_TEST_CASE(a_camera_takes_all_points_in_and_stands_no_farther_off_than_that_needs) {
    const Surface plate = surfaceOf(windowScene().partMesh, Vector3::Zero(), 1);
    const Area area{20, 30, 500, 300};
    for (const NamedView& view : namedViews()) {
        const Camera camera = cameraAround(plate.vertices, view.from, 0.5, area);
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (const Vector3f& vertex : plate.vertices) {
            const Vector3f d = vertex - camera.eye;
            const double depth = camera.forward.dot(d);
            BOOST_TEST_REQUIRE(depth > 0);
            const double x = camera.centreX + camera.focal * camera.right.dot(d) / depth;
            const double y = camera.centreY - camera.focal * camera.up.dot(d) / depth;
            left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
            bottom = std::max(bottom, y);
            const Ray ray = camera.rayThrough(static_cast<float>(x), static_cast<float>(y));
            BOOST_TEST(ray.direction.dot(d.normalized()) > 1 - 1e-5f);
        }
        BOOST_TEST((left > area.left - 0.1 && right < area.right + 0.1 && top > area.top - 0.1 &&
                    bottom < area.bottom + 0.1),
                   view.name);
        const bool fills =
            right - left > 0.99 * (area.right - area.left) || bottom - top > 0.99 * (area.bottom - area.top);
        BOOST_TEST(fills, view.name);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
