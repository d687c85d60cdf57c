#include "clearway/problem.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(problem_test)

void requireRefused(const Problem& problem, const Box& environment, const std::vector<std::string>& words) {
    testing::requireRefusedBy([&] { boundsOf(problem, environment, Box()); }, words);
}

const Box kUnitBox(Vector3(0, 0, 0), Vector3(1, 1, 1));

BOOST_AUTO_TEST_CASE(poses_have_a_defect_of_rounding_whatever_the_quaternions_length) {
    constexpr unsigned kSeed = 5;
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20000; ++i) {
        PartState state;
        state.rotation.coeffs() << normal(random), normal(random), normal(random), normal(random);
        if (i % 3 == 0) state.rotation.coeffs() *= 1e-6;
        BOOST_TEST_REQUIRE(rotationDefect(poseOf(state)) <= 1e-15, state.rotation.coeffs().transpose());
    }
}

BOOST_AUTO_TEST_CASE(a_pose_turns_by_the_quaternion_and_then_moves) {
    const double half = std::sqrt(0.5);
    const Pose pose = poseOf({Vector3(1, 2, 3), {half, 0, 0, half}});
    BOOST_TEST((pose * Vector3(1, 0, 5) - Vector3(1, 3, 8)).norm() <= 1e-15);
    const Pose planar = poseOf({Vector3(1, 2, 0), {0.8, 0, 0, 0.6}});
    BOOST_TEST(planar.rotation.row(2) == Eigen::RowVector3d(0, 0, 1));
    BOOST_TEST(planar.rotation.col(2) == Vector3(0, 0, 1));
}

BOOST_AUTO_TEST_CASE(a_quaternion_that_is_none_has_no_pose) {
    PartState state;
    state.rotation.coeffs().setZero();
    BOOST_CHECK_THROW(poseOf(state), std::invalid_argument);
    state.rotation.w() = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(poseOf(state), std::invalid_argument);
    state.rotation.w() = std::numeric_limits<double>::infinity();
    BOOST_CHECK_THROW(poseOf(state), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(without_a_volume_the_environments_box_grows_to_hold_start_and_goal) {
    Problem problem;
    problem.start.position = Vector3(-2, 0.5, 0.5);
    problem.goal.position = Vector3(0.5, 3, 0.5);
    const Box bounds = boundsOf(problem, kUnitBox, Box());
    BOOST_TEST(bounds.min() == Vector3(-2, 0, 0));
    BOOST_TEST(bounds.max() == Vector3(1, 3, 1));
}

BOOST_AUTO_TEST_CASE(a_volume_is_the_bounds_and_must_hold_start_and_goal) {
    Problem problem;
    problem.file = "a.cfg";
    problem.volume = Box(Vector3(0, 0, 0), Vector3(2, 2, 2));
    problem.goal.position = Vector3(2, 1, 1);  // on the border is inside
    BOOST_TEST(boundsOf(problem, kUnitBox, Box()).max() == Vector3(2, 2, 2));
    problem.start.position = Vector3(1, -0.5, 1);
    requireRefused(problem, kUnitBox, {"a.cfg", "start.y is -0.5", "from 0 to 2"});
    problem.start.position = Vector3(1, 1, 1);
    problem.goal.position.z() = 2.5;
    requireRefused(problem, kUnitBox, {"a.cfg", "goal.z is 2.5", "from 0 to 2"});
}

BOOST_AUTO_TEST_CASE(in_the_plane_z_is_zero_and_bounds_nothing) {
    Problem problem;
    problem.space = Space::kSe2;
    const Box bounds = boundsOf(problem, Box(Vector3(-1, -1, 4), Vector3(1, 1, 5)), Box());
    BOOST_TEST(bounds.min() == Vector3(-1, -1, 0));
    BOOST_TEST(bounds.max() == Vector3(1, 1, 0));
}

BOOST_AUTO_TEST_CASE(bounds_without_extent_are_refused) {
    requireRefused({}, Box(Vector3(-1, -1, 0), Vector3(1, 1, 0)),
                   {"along z are 0 to 0", "an extent above 0", "volume.min.z and volume.max.z"});
}

BOOST_AUTO_TEST_CASE(what_is_more_than_a_million_sizes_away_is_refused_by_name) {
    const auto refused = [](const Problem& problem, const std::string& what) {
        requireRefused(problem, kUnitBox, {what, "a million times", "from -1732050.8 to 1732051.8"});
    };
    Problem problem;
    problem.goal.position = Vector3(1.7e6, 0, 0);
    BOOST_CHECK_NO_THROW(boundsOf(problem, kUnitBox, Box()));
    problem.goal.position = Vector3(1.8e6, 0, 0);
    refused(problem, "goal.x is 1800000");
    problem.goal.position = Vector3(0, 0, 0);
    problem.start.position = Vector3(0, 0, -1.8e6);
    refused(problem, "start.z is -1800000");
    problem.start.position = Vector3(0, 0, 0);
    problem.volume = Box(Vector3(-1e16, -1, -1), Vector3(2, 2, 2));
    refused(problem, "volume.min.x is -1e+16");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
