// Poses from and to Eigen's types: the same map, and a rotation that queries accept.
#include "clearway/types.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <limits>

#include "support/words.h"

BOOST_AUTO_TEST_SUITE(pose_test)

using namespace clearway;

const Eigen::Quaterniond kTurn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
const Vector3 kPlace(1, -2, 3.5);

BOOST_AUTO_TEST_CASE(an_isometry_and_its_pose_move_points_alike) {
    const Eigen::Isometry3d isometry = Eigen::Translation3d(kPlace) * kTurn;
    const Pose pose = toPose(isometry);
    const Vector3 point(0.25, 4, -8);
    BOOST_TEST((pose * point - isometry * point).norm() < 1e-14);
    BOOST_TEST((toIsometry(pose).matrix() == isometry.matrix()));
}

BOOST_AUTO_TEST_CASE(a_quaternion_of_any_length_makes_a_pose_that_queries_accept) {
    for (const double length : {1.0, 1e-320, 1e-200, 0.3, 1e160, 1e307}) {
        const Pose pose = toPose(Eigen::Quaterniond(kTurn.coeffs() * length), kPlace);
        BOOST_TEST(rotationDefect(pose) <= 1e-15);
        if (length > 1e-300) BOOST_TEST(toQuaternion(pose).angularDistance(kTurn) < 1e-14);
        BOOST_TEST((pose.translation == kPlace));
    }
}

BOOST_AUTO_TEST_CASE(a_quaternion_without_a_direction_is_refused) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double entry : {0.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        testing::requireRefusedBy([&] { toPose(Eigen::Quaterniond(entry, 0, 0, 0), kPlace); },
                                  {"expected above 0 and finite"});
    }
}

BOOST_AUTO_TEST_CASE(a_matrix_that_is_no_rotation_is_refused_by_what_is_wrong_with_it) {
    const auto refusal = [](const Matrix3& matrix) {
        return testing::refusalBy([&] { requirePose({matrix, kPlace}); });
    };
    const Matrix3 turn = kTurn.toRotationMatrix(), mirror = Vector3(1, 1, -1).asDiagonal();
    BOOST_TEST(refusal(turn) == "accepted");
    BOOST_TEST(refusal(mirror) == "the pose's matrix is no rotation: its determinant is -1, expected 1");
    BOOST_TEST(refusal(Matrix3::Zero()) ==
               "the pose's matrix is no rotation: its determinant is 0, expected 1");
    BOOST_TEST(refusal(2 * Matrix3::Identity()) ==
               "the pose's matrix is no rotation: max |R^T R - I| is 3, expected at most 1e-12");
    BOOST_TEST(refusal(turn / 0.0) ==
               "the pose's rotation or translation is not finite, expected finite numbers");
}

BOOST_AUTO_TEST_SUITE_END()
