#include <boost/test/unit_test.hpp>
#include <cmath>

#include "build/fit_rss.h"
#include "support/random_meshes.h"
#include "tree/rss.h"
#include "tree/stored_volume.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(round_outward_test)

namespace {

std::vector<Vector3> cloud(Random& random, double spread0, double spread1, double spread2) {
    const Matrix3 axes = random.rotation();
    const Vector3 centre = random.inBox(0.5);
    std::vector<Vector3> points;
    const int count = 1 + random.below(30);
    for (int i = 0; i < count; ++i) {
        points.push_back(centre + axes * random.inBox(0.3).cwiseProduct(Vector3(spread0, spread1, spread2)));
    }
    return points;
}

bool holds(const FloatRss& stored, const std::vector<Vector3>& points, const Vector3& origin, double unit) {
    for (const Vector3& point : points) {
        const LongVector x =
            (point.cast<long double>() - origin.cast<long double>()) / static_cast<long double>(unit);
        if (!(distanceFromRectangle(stored, x) <= stored.radius)) return false;
    }
    return true;
}

BOOST_AUTO_TEST_CASE(every_point_is_inside_the_stored_volume_and_it_is_hardly_larger) {
    constexpr std::uint64_t kSeed = 17;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 5000; ++round) {
            const double thin = std::pow(10.0, random.uniform(-18, 0));
            const std::vector<Vector3> points = cloud(random, 1, round % 2 ? 1 : thin, thin);
            const Rss rss = fitRss(points);
            const FloatRss stored = roundOutward(rss, points, Vector3::Zero(), 1);
            BOOST_REQUIRE(holds(stored, points, Vector3::Zero(), 1));
            BOOST_REQUIRE(stored.radius - rss.radius < 3e-7);
        }
    }
}

BOOST_AUTO_TEST_CASE(any_scale_and_origin_keep_the_points_inside) {
    constexpr std::uint64_t kSeed = 19;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 300; ++round) {
            for (const double unit : {1.0, 0x1p200, 0x1p-200, 0x1p900, 0x1p-900}) {
                for (const Vector3& shift :
                     {Vector3(0, 0, 0), Vector3(1e9, -3e9, 7e8), Vector3(1e3, 1e-3, 1)}) {
                    const Vector3 origin = unit * shift;
                    std::vector<Vector3> points = cloud(random, 1, 0.1, 1e-9);
                    for (Vector3& point : points) point = unit * point + origin;
                    BOOST_REQUIRE(
                        holds(roundOutward(fitRss(points), points, origin, unit), points, origin, unit));
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_point_at_the_origin_has_radius_zero) {
    const Vector3 origin(3, 4, 5);
    const FloatRss stored = roundOutward(fitRss({origin, origin}), {origin, origin}, origin, 0.5);
    BOOST_TEST((stored.centre[0] == 0 && stored.centre[1] == 0 && stored.centre[2] == 0));
    BOOST_TEST((stored.halfLength0 == 0 && stored.halfLength1 == 0 && stored.radius == 0));
}

BOOST_AUTO_TEST_CASE(flat_volumes_stay_flat_to_rounding_in_double) {
    const std::vector<Vector3> square = {{0, 0, 0.25}, {0.5, 0, 0.25}, {0.5, 0.5, 0.25}, {0, 0.5, 0.25}};
    const FloatRss stored = roundOutward(fitRss(square), square, Vector3::Zero(), 1);
    BOOST_TEST(stored.radius < 1e-14f);
    BOOST_TEST(holds(stored, square, Vector3::Zero(), 1));
}

BOOST_AUTO_TEST_CASE(no_stored_number_is_a_denormal_float) {
    constexpr std::uint64_t kSeed = 23;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 2000; ++round) {
            std::vector<Vector3> points = cloud(random, 1, 1, 1);
            const double scale = std::pow(10.0, random.uniform(-60, 0));
            for (Vector3& point : points) point *= scale;
            const FloatRss stored = roundOutward(fitRss(points), points, Vector3::Zero(), 1);
            BOOST_REQUIRE(holds(stored, points, Vector3::Zero(), 1));
            const auto isFine = [](float value) { return value == 0 || std::isnormal(value); };
            for (int i = 0; i < 3; ++i) {
                BOOST_REQUIRE(
                    (isFine(stored.centre[i]) && isFine(stored.axis0[i]) && isFine(stored.axis1[i])));
            }
            BOOST_REQUIRE(
                (isFine(stored.halfLength0) && isFine(stored.halfLength1) && isFine(stored.radius)));
        }
    }
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
