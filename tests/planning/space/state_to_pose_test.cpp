#include "clearway/planning/state_to_pose.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/WrapperStateSpace.h>

#include <boost/test/unit_test.hpp>
#include <limits>
#include <stdexcept>

#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(state_to_pose_test)

namespace ob = ompl::base;

void set(ob::SE3StateSpace::StateType& state, const Vector3& p, const Eigen::Quaterniond& q) {
    state.setXYZ(p.x(), p.y(), p.z());
    state.rotation().x = q.x();
    state.rotation().y = q.y();
    state.rotation().z = q.z();
    state.rotation().w = q.w();
}

BOOST_AUTO_TEST_CASE(an_se3_state_whose_quaternion_is_off_by_1e_9_becomes_an_accepted_pose) {
    const auto space = std::make_shared<ob::SE3StateSpace>();
    const StateToPose toPose = stateToPose(*space);
    testing::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Pose expected = random.pose(100);
        Eigen::Quaterniond q(expected.rotation);
        q.coeffs() *= 1 + random.uniform(-1e-9, 1e-9);
        ob::ScopedState<ob::SE3StateSpace> state(space);
        set(*state, expected.translation, q);
        const Pose pose = toPose(state.get());
        BOOST_TEST(rotationDefect(pose) <= kPoseDefect);
        BOOST_TEST((pose.rotation - expected.rotation).cwiseAbs().maxCoeff() < 1e-14);
        BOOST_TEST(pose.translation == expected.translation);
    }
}

BOOST_AUTO_TEST_CASE(an_se2_state_turns_about_z_and_keeps_z) {
    const auto space = std::make_shared<ob::SE2StateSpace>();
    ob::ScopedState<ob::SE2StateSpace> state(space);
    state->setXY(3, -4);
    state->setYaw(2.5);
    const Pose pose = stateToPose(*space)(state.get());
    BOOST_TEST(pose.translation == Vector3(3, -4, 0));
    const Matrix3 expected = Eigen::AngleAxisd(2.5, Vector3::UnitZ()).toRotationMatrix();
    BOOST_TEST((pose.rotation - expected).cwiseAbs().maxCoeff() < 1e-15);
    BOOST_TEST(rotationDefect(pose) <= kPoseDefect);
}

BOOST_AUTO_TEST_CASE(a_state_without_a_pose_gives_one_that_is_not_finite) {
    const auto space = std::make_shared<ob::SE3StateSpace>();
    const StateToPose toPose = stateToPose(*space);
    ob::ScopedState<ob::SE3StateSpace> state(space);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    set(*state, Vector3::Zero(), Eigen::Quaterniond(0, 0, 0, 0));
    BOOST_TEST(rotationDefect(toPose(state.get())) == kInfinity);
    set(*state, Vector3::Zero(), Eigen::Quaterniond(kNan, 0, 0, 1));
    BOOST_TEST(rotationDefect(toPose(state.get())) == kInfinity);
    set(*state, Vector3(0, kNan, 0), Eigen::Quaterniond(1, 0, 0, 0));
    BOOST_TEST(rotationDefect(toPose(state.get())) == kInfinity);
    set(*state, Vector3(0, 0, kInfinity), Eigen::Quaterniond(1, 0, 0, 0));
    BOOST_TEST(rotationDefect(toPose(state.get())) == kInfinity);
}

BOOST_AUTO_TEST_CASE(derived_and_wrapped_spaces_are_recognised) {
    const auto dubins = std::make_shared<ob::DubinsStateSpace>();
    ob::ScopedState<ob::SE2StateSpace> planar(dubins);
    planar->setXY(1, 2);
    planar->setYaw(0);
    BOOST_TEST(stateToPose(*dubins)(planar.get()).translation == Vector3(1, 2, 0));

    const auto inner = std::make_shared<ob::SE3StateSpace>();
    inner->setSubspaceWeight(1, 700);
    const auto wrapper = std::make_shared<ob::WrapperStateSpace>(inner);
    ob::State* state = wrapper->allocState();
    set(*state->as<ob::WrapperStateSpace::StateType>()->getState()->as<ob::SE3StateSpace::StateType>(),
        Vector3(5, 6, 7), Eigen::Quaterniond::Identity());
    BOOST_TEST(stateToPose(*wrapper)(state).translation == Vector3(5, 6, 7));
    wrapper->freeState(state);
}

BOOST_AUTO_TEST_CASE(another_space_is_refused_by_its_name) {
    const auto space = std::make_shared<ob::RealVectorStateSpace>(6);
    space->setName("gantry");
    testing::requireRefusedBy([&] { stateToPose(*space); }, {"'gantry'"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
