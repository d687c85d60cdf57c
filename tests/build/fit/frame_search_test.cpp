#include "build/frame_search.h"

#include <boost/test/unit_test.hpp>

#include "support/random_meshes.h"
#include "tree/stored_volume.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(frame_search_test)

namespace {

constexpr double kFloatRounding = 1e-5;  // relative: candidates are compared in float

std::vector<Vector3> randomCloud(Random& random, int count) {
    const Matrix3 axes = random.rotation();
    const Vector3 spread(random.uniform(0, 3), random.uniform(0, 1), random.uniform(0, 1));
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) points.push_back(axes * random.inBox(1).cwiseProduct(spread));
    return points;
}

Matrix3 withNormal(const Matrix3& axes, int normal) {
    Matrix3 turned;
    turned << axes.col((normal + 1) % 3), axes.col((normal + 2) % 3), axes.col(normal);
    return turned;
}

BOOST_AUTO_TEST_CASE(no_frame_considered_gives_less_area) {
    constexpr std::uint64_t kSeed = 81;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        FrameSearch search;
        for (int round = 0; round < 1500; ++round) {
            const std::vector<Vector3> points = randomCloud(random, 1 + random.below(60));
            std::vector<Matrix3> frames = {principalFrame(points).axes, Matrix3::Identity()};
            for (int i = random.below(5); i > 0; --i) frames.push_back(random.rotation());
            search.begin(points);
            double least = std::numeric_limits<double>::infinity();
            for (const Matrix3& axes : frames) {
                search.consider(axes);
                for (int normal = 0; normal < 3; ++normal)
                    least = std::min(least, fitRss(points, withNormal(axes, normal)).area());
            }
            const Rss best = search.leastArea();
            BOOST_REQUIRE(best.area() <= least * (1 + kFloatRounding) + 1e-12);
            for (const Vector3& point : points)
                BOOST_REQUIRE(distanceFromRectangle(best, point) <= best.radius + 1e-14);
        }
    }
}

BOOST_AUTO_TEST_CASE(each_axis_may_become_the_normal) {
    Random random(82);
    for (int flat = 0; flat < 3; ++flat) {
        std::vector<Vector3> points;
        for (int i = 0; i < 50; ++i) {
            Vector3 point = random.inBox(1);
            point[flat] = 0;
            points.push_back(point);
        }
        FrameSearch search;
        search.begin(points);
        search.consider(Matrix3::Identity());
        const Rss plate = search.leastArea();
        BOOST_TEST(plate.radius == 0);
        BOOST_TEST(std::abs(plate.axes(flat, 2)) == 1);
    }
}

BOOST_AUTO_TEST_CASE(neither_scale_nor_place_changes_the_choice) {
    constexpr std::uint64_t kSeed = 83;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        FrameSearch search;
        const auto fit = [&](const std::vector<Vector3>& points, const std::vector<Matrix3>& frames) {
            search.begin(points);
            for (const Matrix3& axes : frames) search.consider(axes);
            return search.leastArea();
        };
        for (int round = 0; round < 100; ++round) {
            const std::vector<Vector3> points = randomCloud(random, 30);
            const std::vector<Matrix3> frames = {random.rotation(), random.rotation(), random.rotation()};
            const Rss fitted = fit(points, frames);
            for (const double scale : {0x1p200, 0x1p-200, 0x1p900, 0x1p-900}) {
                std::vector<Vector3> scaled = points;
                for (Vector3& point : scaled) point *= scale;
                const Rss scaledFit = fit(scaled, frames);
                BOOST_REQUIRE(scaledFit.axes == fitted.axes);
                BOOST_REQUIRE(scaledFit.radius == scale * fitted.radius);
            }
            std::vector<Vector3> moved = points;
            for (Vector3& point : moved) point += Vector3(1e6, -1e6, 3e5);
            BOOST_REQUIRE(fit(moved, frames).area() <= fitted.area() * (1 + 1e-4));
        }
    }
}

BOOST_AUTO_TEST_CASE(one_point_or_equal_points_have_no_size) {
    const Vector3 a(1, 2, 3);
    FrameSearch search;
    for (const int count : {1, 7, 8, 9, 30}) {
        search.begin(std::vector<Vector3>(1, a));
        const std::vector<Vector3> points(count, a);
        search.begin(points);
        search.consider(Matrix3::Identity());
        const Rss fitted = search.leastArea();
        BOOST_TEST((fitted.centre == a && fitted.area() == 0));
    }
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
