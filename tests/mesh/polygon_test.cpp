// Triangles fill a polygon inside its outline, whatever its shape and place.
#include "mesh/read/polygon.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "mesh/mesh_files.h"
#include "support/random_meshes.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(polygon_test)

using namespace testing;

struct Filled {
    PolygonShape shape;
    Mesh mesh;
};

Filled fill(const std::vector<Vector3>& corners) {
    Filled filled;
    filled.mesh.vertices = corners;
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    filled.shape = triangulate(corners, order.data(), order.size(), filled.mesh.triangles);
    return filled;
}

Filled fillFlat(const std::vector<std::array<double, 2>>& corners) {
    std::vector<Vector3> points;
    for (const auto& corner : corners) points.push_back({corner[0], corner[1], 0});
    return fill(points);
}

/// The area that the outline encloses, by its sign.
double enclosedArea(const std::vector<Vector3>& corners) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += corners[i].cross(corners[(i + 1) % corners.size()]);
    return sum.norm() / 2;
}

BOOST_AUTO_TEST_CASE(random_simple_polygons_are_filled_inside_their_outline) {
    Random random(1);
    int filled = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<double> angles;
        for (int k = 0; k < 4 + i % 20; ++k) angles.push_back(random.uniform(0, 2 * M_PI));
        std::sort(angles.begin(), angles.end());
        double widest = angles.front() + 2 * M_PI - angles.back();
        for (std::size_t k = 1; k < angles.size(); ++k) widest = std::max(widest, angles[k] - angles[k - 1]);
        if (widest > 3.1) continue;  // the outline would not go round its centre
        const Matrix3 turn = i % 2 ? Matrix3::Identity() : random.rotation();
        std::vector<Vector3> corners;
        for (const double angle : angles) {
            const double radius = random.uniform(0.05, 1);
            const Vector3 corner = turn * Vector3(radius * std::cos(angle), radius * std::sin(angle), 0);
            corners.push_back(i % 3 ? corner : Vector3(corner.cast<float>().cast<double>()));
        }
        const Filled found = fill(corners);
        ++filled;
        BOOST_TEST(found.shape.isFilled);
        BOOST_TEST(found.mesh.triangles.size() == corners.size() - 2);
        BOOST_TEST(areaOf(found.mesh) == enclosedArea(corners), boost::test_tools::tolerance(1e-5));
    }
    BOOST_TEST(filled > 2500);
}

BOOST_AUTO_TEST_CASE(outlines_that_touch_themselves_are_filled) {
    const std::pair<std::vector<std::array<double, 2>>, double> cases[] = {
        {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}},
         12},                                                            // around a hole
        {{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}, 4},   // corners on edges
        {{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}, 2},                   // a corner on an edge
        {{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}, 2},           // a corner on a corner
        {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {2, 2}, {0, 2}}, 16},  // a slit
        {{{0, 0}, {3, 0}, {0, 3}, {1, 1}}, 3},                           // a dart
        {{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 0},                           // a line
    };
    for (const auto& [corners, area] : cases) {
        const Filled found = fillFlat(corners);
        BOOST_TEST(found.shape.isFilled);
        BOOST_TEST(areaOf(found.mesh) == area, boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(a_corner_that_rounding_put_beyond_an_edge_does_no_harm) {
    const Filled found = fillFlat({{0, 0}, {3, 1}, {3, 4}, {1, 0.333333}, {0, 4}});
    BOOST_TEST(found.shape.isFilled);
    BOOST_TEST(areaOf(found.mesh) == 5, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(!fillFlat({{0, 0}, {3, 1}, {3, 4}, {1, 0.33}, {0, 4}}).shape.isFilled);
}

BOOST_AUTO_TEST_CASE(outlines_that_cross_themselves_are_left_out_and_counted) {
    BOOST_TEST(!fillFlat({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).shape.isFilled);
    BOOST_TEST(!fillFlat({{0, 0}, {2, 2}, {2, 0}, {0, 1}}).shape.isFilled);
    std::vector<std::array<double, 2>> star;
    for (int i = 0; i < 5; ++i) star.push_back({std::cos(0.8 * M_PI * i), std::sin(0.8 * M_PI * i)});
    BOOST_TEST(!fillFlat(star).shape.isFilled);
    const Mesh mesh = loadText(
        "a.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nv 8 9 9\nv 9 8 9\nf 1 2 3 4\nf 5 6 7\n");
    BOOST_TEST(mesh.triangles.size() == 1u);
    BOOST_TEST(mesh.origin.crossingFaces == 1u);
    BOOST_TEST(mesh.origin.ignoredFaces == 2u);
}

BOOST_AUTO_TEST_CASE(polygons_that_are_not_flat_are_counted_and_rounded_ones_are_not) {
    const auto quad = [](const std::string& height) {
        return loadText("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 " + height + "\nv 0 1 0\nf 1 2 3 4\n");
    };
    const Mesh bent = quad("0.1");
    BOOST_TEST(bent.origin.bentFaces == 1u);
    BOOST_TEST(bent.origin.bentBy == 0.025, boost::test_tools::tolerance(0.01));
    BOOST_TEST(bent.triangles.size() == 2u);
    BOOST_TEST(quad("1e-6").origin.bentFaces == 0u);
}

BOOST_AUTO_TEST_CASE(thousands_of_corners_are_filled) {
    std::vector<Vector3> corners;
    for (int i = 0; i < 3000; ++i) {
        const double radius = 1 + 0.5 * (i * 7919 % 13) / 13, angle = i * 2 * M_PI / 3000;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    const Filled found = fill(corners);
    BOOST_TEST(found.shape.isFilled);
    BOOST_TEST(areaOf(found.mesh) == enclosedArea(corners), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
