#include <boost/test/unit_test.hpp>
#include <cmath>

#include "build/fit_rss.h"
#include "support/random_meshes.h"
#include "tree/rss.h"
#include "tree/stored_volume.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(fit_rss_test)

/// Largest distance of a point beyond the swept surface; at most rounding when the volume holds them all.
double largestExcess(const Rss& rss, const std::vector<Vector3>& points) {
    long double excess = 0;
    for (const Vector3& point : points)
        excess = std::max(excess, distanceFromRectangle(rss, point) - rss.radius);
    return static_cast<double>(excess);
}

std::vector<Vector3> randomCloud(Random& random) {
    const Matrix3 axes = random.rotation();
    const Vector3 spread(random.uniform(0, 3), random.uniform(0, 1), random.uniform(0, 1));
    std::vector<Vector3> points;
    const int count = 1 + random.below(60);
    for (int i = 0; i < count; ++i) points.push_back(axes * random.inBox(1).cwiseProduct(spread));
    return points;
}

BOOST_AUTO_TEST_CASE(every_point_is_inside_in_any_frame) {
    constexpr std::uint64_t kSeed = 7;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 3000; ++round) {
            const std::vector<Vector3> points = randomCloud(random);
            BOOST_REQUIRE(largestExcess(fitRss(points), points) < 1e-14);
            BOOST_REQUIRE(largestExcess(fitRss(points, random.rotation()), points) < 1e-14);
        }
    }
}

BOOST_AUTO_TEST_CASE(corners_are_pushed_out_no_farther_than_needed) {
    // A box's corners are out of reach of corner spheres at h - r: each must move along its diagonal until it
    // touches.
    std::vector<Vector3> corners;
    for (const double x : {-4.0, 4.0}) {
        for (const double y : {-3.0, 3.0}) {
            for (const double z : {-1.0, 1.0}) corners.push_back({x, y, z});
        }
    }
    // At z = +-1 the sphere of radius 1 reaches nothing sideways: the rectangle is the box's own face.
    const Rss face = fitRss(corners, Matrix3::Identity());
    BOOST_TEST(face.radius == 1.0);
    BOOST_TEST(face.halfLength0 == 4.0);
    BOOST_TEST(face.halfLength1 == 3.0);

    // Corners at mid height and a point above and below: sides at 4 - 1 and 3 - 1, whose corner spheres miss
    // the corners by sqrt(2) - 1 along the diagonal.
    std::vector<Vector3> rim = {{0, 0, 1}, {0, 0, -1}};
    for (const double x : {-4.0, 4.0}) {
        for (const double y : {-3.0, 3.0}) rim.push_back({x, y, 0});
    }
    const Rss pushed = fitRss(rim, Matrix3::Identity());
    const double push = (std::sqrt(2.0) - 1) * std::sqrt(0.5);
    BOOST_TEST(pushed.radius == 1.0);
    BOOST_TEST(pushed.halfLength0 == 3 + push, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(pushed.halfLength1 == 2 + push, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_order_of_the_points_does_not_matter) {
    constexpr std::uint64_t kSeed = 8;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 300; ++round) {
            const std::vector<Vector3> points = randomCloud(random);
            const Matrix3 axes = random.rotation();
            const Rss forwards = fitRss(points, axes);
            const Rss backwards = fitRss({points.rbegin(), points.rend()}, axes);
            BOOST_REQUIRE(forwards.centre == backwards.centre);
            BOOST_REQUIRE(forwards.halfLength0 == backwards.halfLength0);
            BOOST_REQUIRE(forwards.halfLength1 == backwards.halfLength1);
            BOOST_REQUIRE(forwards.radius == backwards.radius);
        }
    }
}

BOOST_AUTO_TEST_CASE(swept_shapes_are_fitted_by_themselves) {
    std::vector<Vector3> ball;
    std::vector<Vector3> capsule;
    for (int i = 0; i <= 64; ++i) {
        for (int j = 0; j < 128; ++j) {
            const double pi = std::acos(-1.0);
            const double latitude = pi * (i / 64.0 - 0.5);
            const double longitude = 2 * pi * j / 128.0;
            const Vector3 p(std::cos(latitude) * std::cos(longitude),
                            std::cos(latitude) * std::sin(longitude), std::sin(latitude));
            ball.push_back(p);
            capsule.push_back(p + Vector3(-5, 0, 0));
            capsule.push_back(p + Vector3(5, 0, 0));
        }
    }
    const Rss ballFit = fitRss(ball, Matrix3::Identity());
    BOOST_TEST(ballFit.radius == 1.0, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(ballFit.halfLength0 < 1e-12);
    BOOST_TEST(ballFit.halfLength1 < 1e-12);
    const Rss capsuleFit = fitRss(capsule);  // finds the axis by itself
    BOOST_TEST(capsuleFit.radius == 1.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(capsuleFit.halfLength0 == 5.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(capsuleFit.halfLength1 < 1e-12);
}

BOOST_AUTO_TEST_CASE(points_segments_and_plates_have_no_radius) {
    const Vector3 a(1, 2, 3);
    const Vector3 along(2, -1, 2);  // length 3
    const Vector3 across(1, 2, 0);
    const Rss point = fitRss({a});
    BOOST_TEST((point.centre - a).norm() == 0);
    BOOST_TEST((point.halfLength0 == 0 && point.halfLength1 == 0 && point.radius == 0));
    const Rss equal = fitRss(std::vector<Vector3>(9, a));
    BOOST_TEST((equal.centre == a && equal.halfLength0 == 0 && equal.halfLength1 == 0 && equal.radius == 0));
    for (const auto& points :
         {std::vector<Vector3>{a, a + along}, {a, a + 0.3 * along, a + along, a + along}}) {
        const Rss segment = fitRss(points);
        BOOST_TEST(segment.halfLength0 == 1.5, boost::test_tools::tolerance(1e-14));
        BOOST_TEST(segment.halfLength1 < 1e-14);
        BOOST_TEST(segment.radius < 1e-14);
    }
    const Rss plate = fitRss({a, a + along, a + 0.2 * across, a + along + 0.2 * across});
    BOOST_TEST(plate.halfLength0 == 1.5, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(plate.halfLength1 == 0.1 * std::sqrt(5.0), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(plate.radius < 1e-14);
}

BOOST_AUTO_TEST_CASE(scaling_by_a_power_of_two_scales_the_fit_exactly) {
    constexpr std::uint64_t kSeed = 9;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 200; ++round) {
            const std::vector<Vector3> points = randomCloud(random);
            const Rss fitted = fitRss(points);
            for (const double scale : {0x1p60, 0x1p-60, 0x1p200, 0x1p-200, 0x1p900, 0x1p-900}) {
                std::vector<Vector3> scaled = points;
                for (Vector3& point : scaled) point *= scale;
                const Rss scaledFit = fitRss(scaled);
                BOOST_REQUIRE(scaledFit.centre == scale * fitted.centre);
                BOOST_REQUIRE(scaledFit.axes == fitted.axes);
                BOOST_REQUIRE(scaledFit.halfLength0 == scale * fitted.halfLength0);
                BOOST_REQUIRE(scaledFit.halfLength1 == scale * fitted.halfLength1);
                BOOST_REQUIRE(scaledFit.radius == scale * fitted.radius);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
