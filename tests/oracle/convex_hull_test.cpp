#include "support/convex_hull.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(convex_hull_test)

using namespace clearway;
using namespace clearway::testing;

BOOST_AUTO_TEST_CASE(the_hull_of_a_cubes_grid_is_the_cube) {
    std::vector<Vector3> points;
    for (int i = 0; i < 125; ++i) points.emplace_back(i % 5, i / 5 % 5, i / 25);
    const Mesh hull = convexHull(points);
    BOOST_TEST(signedVolume(hull) == 64, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_hull_of_points_on_a_ball_holds_them_all) {
    std::vector<Vector3> points;
    constexpr int kPoints = 2000;
    for (int i = 0; i < kPoints; ++i) {  // a spiral from pole to pole
        const double z = 1 - (2 * i + 1.0) / kPoints, r = std::sqrt(1 - z * z), angle = 2.399963 * i;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    const Mesh hull = convexHull(points);
    BOOST_TEST(hull.triangles.size() == 2 * kPoints - 4);
    BOOST_TEST(signedVolume(hull) == 4.0 / 3 * M_PI, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(points_in_a_plane_have_no_hull) {
    BOOST_CHECK_THROW(convexHull({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}), std::invalid_argument);
    BOOST_CHECK_THROW(convexHull({}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
