#include "tree/rss.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"
#include "tree/stored_volume.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(rss_test)

Rss sample() {
    Rss rss;
    rss.halfLength0 = 2;  // l = 4
    rss.halfLength1 = 1.5;
    rss.radius = 0.5;
    return rss;
}

BOOST_AUTO_TEST_CASE(the_area_matches_a_value_worked_out_by_hand) {
    BOOST_TEST(sample().area() == 24 + 8 * std::acos(-1.0), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_area_matches_the_share_of_random_points_near_the_surface) {
    constexpr int kPoints = 400000;
    constexpr double kNear = 0.05;  // small enough for the surface's curvature not to matter
    constexpr std::uint64_t kSeed = 5;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        const Rss rss = sample();
        int near = 0;
        for (int i = 0; i < kPoints; ++i) {
            const Vector3 point(random.uniform(-2.6, 2.6), random.uniform(-2.1, 2.1),
                                random.uniform(-0.6, 0.6));
            if (std::abs(distanceFromRectangle(rss, point) - rss.radius) <= kNear) ++near;
        }
        const double boxVolume = 5.2 * 4.2 * 1.2;
        const double share = 2 * kNear * rss.area() / boxVolume;
        const double deviation = std::sqrt(share * (1 - share) / kPoints);
        BOOST_TEST(std::abs(near / double(kPoints) - share) < 5 * deviation);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
