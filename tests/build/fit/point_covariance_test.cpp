#include "build/fit_rss.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(point_covariance_test)

std::vector<Vector3> brick(const Matrix3& axes, const Vector3& centre, double scale) {
    std::vector<Vector3> points;
    for (const double x : {-3.0, 3.0}) {
        for (const double y : {-2.0, 2.0}) {
            for (const double z : {-1.0, 1.0}) points.push_back(scale * (centre + axes * Vector3(x, y, z)));
        }
    }
    return points;
}

BOOST_AUTO_TEST_CASE(axes_follow_the_spread_at_any_scale) {
    constexpr std::uint64_t kSeed = 3;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 20; ++round) {
            const Matrix3 axes = random.rotation();
            const Vector3 centre = random.inBox(10);
            for (const double scale : {1.0, 0x1p60, 0x1p-60, 0x1p300, 0x1p-300, 0x1p900, 0x1p-900}) {
                const PrincipalFrame frame = principalFrame(brick(axes, centre, scale));
                BOOST_TEST((frame.mean / scale - centre).norm() < 1e-13);
                BOOST_TEST((frame.axes.transpose() * frame.axes - Matrix3::Identity()).cwiseAbs().maxCoeff() <
                           1e-14);
                BOOST_TEST(frame.axes.determinant() > 0);
                for (int i = 0; i < 3; ++i) {
                    BOOST_TEST(std::abs(frame.axes.col(i).dot(axes.col(i))) > 1 - 1e-12);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(points_without_extent_give_an_orthonormal_frame) {
    for (const Vector3& point : {Vector3(0, 0, 0), Vector3(1e9, -1, 1e-30)}) {
        for (const std::size_t count : {1, 2, 50}) {
            const PrincipalFrame frame = principalFrame(std::vector<Vector3>(count, point));
            BOOST_TEST((frame.mean - point).norm() == 0);
            BOOST_TEST((frame.axes.transpose() * frame.axes - Matrix3::Identity()).cwiseAbs().maxCoeff() <
                       1e-14);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
