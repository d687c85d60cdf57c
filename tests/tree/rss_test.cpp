#include "tree/rss.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"
#include "tree/stored_volume.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(rss_test)

namespace {

Rss sample() {
    Rss rss;
    rss.halfLength0 = 2;  // l = 4
    rss.halfLength1 = 1.5;
    rss.radius = 0.5;
    return rss;
}

BOOST_AUTO_TEST_CASE(measures_match_values_worked_out_by_hand) {
    const double pi = std::acos(-1.0);
    BOOST_TEST(sample().area() == 24 + 8 * pi, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(sample().volume() == 12 + pi / 6 + 1.75 * pi, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(sample().longestExtent() == 6,
               boost::test_tools::tolerance(1e-14));  // 3-4-5 triangle + 2 * 0.5
}

BOOST_AUTO_TEST_CASE(volume_matches_the_share_of_random_points_inside) {
    constexpr int kPoints = 400000;
    constexpr std::uint64_t kSeed = 5;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        const Rss rss = sample();
        int inside = 0;
        for (int i = 0; i < kPoints; ++i) {
            const Vector3 point(random.uniform(-2.5, 2.5), random.uniform(-2, 2), random.uniform(-0.5, 0.5));
            if (distanceFromRectangle(rss, point) <= rss.radius) ++inside;
        }
        const double boxVolume = 5.0 * 4.0 * 1.0;
        const double share = rss.volume() / boxVolume;
        const double deviation = std::sqrt(share * (1 - share) / kPoints);
        BOOST_TEST(std::abs(inside / double(kPoints) - share) < 5 * deviation);
    }
}

BOOST_AUTO_TEST_CASE(volume_grows_with_the_radius_by_the_area) {
    const double step = 1e-5;
    Rss smaller = sample();
    Rss larger = sample();
    smaller.radius -= step;
    larger.radius += step;
    const double growth = (larger.volume() - smaller.volume()) / (2 * step);
    BOOST_TEST(growth == sample().area(), boost::test_tools::tolerance(1e-8));
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
