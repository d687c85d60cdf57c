#include "clearway/planning/validity_checker.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "planning/space/ompl_states.h"
#include "support/ompl_log.h"
#include "support/oracle.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(validity_checker_test)

using testing::Random;

struct Fixture {
    explicit Fixture(double margin = 0) {
        window.scene.obstacles[0].margin = margin;
        space = makeSpace(Space::kSe3, *window.problem.volume, 1);
        si = std::make_shared<ob::SpaceInformation>(space);
        checker = std::make_shared<ValidityChecker>(si, window.scene);
    }

    /// States near the wall, so that about half of them collide. Some are outside of the bounds.
    ob::ScopedState<> randomState(Random& random) const {
        PartState state;
        state.position = Vector3(random.uniform(-50, 50), random.uniform(-45, 45), random.uniform(-45, 45));
        state.rotation = Eigen::Quaterniond(random.rotation());
        return toOmpl(space, Space::kSe3, state);
    }

    ob::ScopedState<> at(const Vector3& position) const {
        PartState state = window.problem.start;
        state.position = position;
        return toOmpl(space, Space::kSe3, state);
    }

    testing::WindowScene window = testing::windowScene();
    ob::StateSpacePtr space;
    ob::SpaceInformationPtr si;
    std::shared_ptr<ValidityChecker> checker;
};

BOOST_AUTO_TEST_CASE(a_state_is_valid_exactly_when_in_bounds_and_farther_than_the_margin) {
    for (const double margin : {0.0, 0.5, 5.0}) {
        const Fixture f(margin);
        const testing::MeshOracle oracle(f.window.partMesh, f.window.wallMesh);
        Random random(7);
        int valid = 0;
        for (int i = 0; i < 300; ++i) {
            const auto state = f.randomState(random);
            const double distance = oracle.distance(f.checker->pose(state.get())).distance;
            const bool expected = f.si->satisfiesBounds(state.get()) && distance > margin;
            BOOST_TEST_CONTEXT("seed 7, state " << i << ", margin " << margin) {
                BOOST_TEST(f.checker->isValid(state.get()) == expected);
            }
            valid += expected;
        }
        BOOST_TEST(valid > 20);
        BOOST_TEST(valid < 280);
    }
}

BOOST_AUTO_TEST_CASE(the_sign_of_clearance_is_the_verdict_and_it_never_exceeds_the_distance_less_the_margin) {
    for (const double margin : {0.0, 5.0}) {
        const Fixture f(margin);
        const testing::MeshOracle oracle(f.window.partMesh, f.window.wallMesh);
        Random random(8);
        for (int i = 0; i < 300; ++i) {
            const auto state = f.randomState(random);
            const bool valid = f.checker->isValid(state.get());
            const double clearance = f.checker->clearance(state.get());
            double sameClearance = 99;
            double againClearance = 99;
            bool isOffered = true;
            BOOST_TEST_CONTEXT("seed 8, state " << i << ", margin " << margin) {
                BOOST_TEST((clearance > 0) == valid);
                BOOST_TEST(f.checker->isValid(state.get(), sameClearance) == valid);
                BOOST_TEST(f.checker->isValid(state.get(), againClearance, nullptr, isOffered) == valid);
                BOOST_TEST(!isOffered);
                BOOST_TEST(sameClearance == clearance, boost::test_tools::tolerance(1e-12));
                BOOST_TEST(againClearance == clearance, boost::test_tools::tolerance(1e-12));
                BOOST_TEST(clearance <=
                           std::max(0.0, oracle.distance(f.checker->pose(state.get())).distance - margin));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(the_sign_agrees_where_the_distance_is_the_margin) {
    // The plate's face is parallel to the wall's: the distance is exactly |x| - 30 - 2.
    for (const double gap : {0.0, 1e-300, 5e-16, 1e-15, 1e-14, 1e-12, 1e-9}) {
        for (const double margin : {0.0, 3.0}) {
            const Fixture f(margin);
            const auto state = f.at({-32 - margin - gap, 0, 0});
            BOOST_TEST_CONTEXT("gap " << gap << ", margin " << margin) {
                BOOST_TEST((f.checker->clearance(state.get()) > 0) == f.checker->isValid(state.get()));
            }
        }
    }
    const Fixture touching;
    BOOST_TEST(touching.checker->clearance(touching.at({-32, 0, 0}).get()) <= 0);
    BOOST_TEST(!touching.checker->isValid(touching.at({-32, 0, 0}).get()));
    BOOST_TEST(touching.checker->isValid(touching.at({-32 - 1e-9, 0, 0}).get()));
}

BOOST_AUTO_TEST_CASE(a_state_outside_of_the_bounds_is_invalid_however_far_from_the_wall) {
    const Fixture f;
    const auto state = f.at({-101, 0, 0});
    BOOST_TEST(!f.checker->isValid(state.get()));
    BOOST_TEST(f.checker->clearance(state.get()) <= 0);
    BOOST_TEST(f.checker->counters().outOfBounds == 2u);
}

BOOST_AUTO_TEST_CASE(a_state_without_a_pose_is_invalid_counted_and_logged_once) {
    const Fixture f;
    testing::OmplLog log;
    auto state = f.at({-60, 0, 0});
    auto* se3 = state->as<ob::SE3StateSpace::StateType>();
    se3->setX(std::numeric_limits<double>::quiet_NaN());
    BOOST_TEST(!f.checker->isValid(state.get()));
    se3->setX(-60);
    se3->rotation().x = se3->rotation().y = se3->rotation().z = se3->rotation().w = 0;
    BOOST_TEST(!f.checker->isValid(state.get()));
    double clearance = 99;
    BOOST_TEST(!f.checker->isValid(state.get(), clearance));
    BOOST_TEST(clearance == 0);
    BOOST_TEST(f.checker->clearance(state.get()) == 0);
    BOOST_TEST(f.checker->counters().unusable == 4u);
    BOOST_TEST(log.lines.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_quaternion_that_is_not_of_unit_length_is_no_pose_and_not_out_of_bounds) {
    const Fixture f;
    const ValidityChecker checker(f.si, f.window.scene);
    for (const double length : {0.0, 2.0}) {
        auto state = f.at({-60, 0, 0});
        auto& rotation = state->as<ob::SE3StateSpace::StateType>()->rotation();
        rotation.x = rotation.y = rotation.z = 0;
        rotation.w = length;
        BOOST_TEST(!checker.isValid(state.get()));
        const WhyInvalid why = checker.whyInvalid(state.get());
        BOOST_TEST((why.kind == WhyInvalid::Kind::kNoPose));
        BOOST_TEST(testing::holds(why.words(), "quaternion has length"));
    }
    const Scene alone(f.window.scene.part);
    auto nowhere = f.at({-60, 0, 0});
    nowhere->as<ob::SE3StateSpace::StateType>()->setX(std::nan(""));
    const ValidityChecker free(f.si, alone);
    BOOST_TEST(!free.isValid(nowhere.get()));
    BOOST_TEST((free.whyInvalid(nowhere.get()).kind == WhyInvalid::Kind::kNoPose));
}

BOOST_AUTO_TEST_CASE(a_callback_that_throws_makes_a_state_invalid_and_is_not_passed_on) {
    const Fixture f;
    const StateToPose fails = [](const ob::State*) -> Pose {
        throw std::runtime_error("no kinematics here");
    };
    const ValidityChecker checker(f.si, SharedScene(f.window.scene, fails));
    testing::OmplLog log;
    const auto state = f.at({-60, 0, 0});
    BOOST_TEST(!checker.isValid(state.get()));
    BOOST_TEST(checker.clearance(state.get()) == 0);
    BOOST_TEST(checker.counters().unusable == 2u);
    BOOST_TEST(log.lines.size() == 1u);
    BOOST_TEST(log.lines.at(0).find("no kinematics here") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(another_space_works_through_a_callback) {
    const auto window = testing::windowScene();
    const auto space = std::make_shared<ob::RealVectorStateSpace>(1);  // along x, lying flat
    space->setBounds(-100, 100);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    BOOST_CHECK_THROW(ValidityChecker(si, window.scene), std::invalid_argument);
    const StateToPose alongX = [](const ob::State* state) {
        return Pose{Matrix3::Identity(), {state->as<ob::RealVectorStateSpace::StateType>()->values[0], 0, 0}};
    };
    const ValidityChecker checker(si, SharedScene(window.scene, alongX));
    ob::ScopedState<ob::RealVectorStateSpace> state(space);
    state[0] = 0;  // in the window: 11 from its upper and lower side
    BOOST_TEST(checker.clearance(state.get()) == 11, boost::test_tools::tolerance(1e-12));
    state[0] = 101;
    BOOST_TEST(!checker.isValid(state.get()));
}

BOOST_AUTO_TEST_CASE(an_se2_state_is_checked_in_the_plane) {
    auto window = testing::windowScene();
    const auto space = makeSpace(Space::kSe2, Box(Vector3(-100, -60, 0), Vector3(100, 60, 0)), 1);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const ValidityChecker checker(si, window.scene);
    PartState state;
    BOOST_TEST(checker.isValid(toOmpl(space, Space::kSe2, state).get()));
    state.position.y() = 13;
    BOOST_TEST(!checker.isValid(toOmpl(space, Space::kSe2, state).get()));
    state.position.y() = 7;
    BOOST_TEST(checker.isValid(toOmpl(space, Space::kSe2, state).get()));
    state.rotation =
        Eigen::AngleAxisd(M_PI / 2, Vector3::UnitZ());  // 60 across a window of 64, 7 off its middle
    BOOST_TEST(!checker.isValid(toOmpl(space, Space::kSe2, state).get()));
}

BOOST_AUTO_TEST_CASE(the_specs_promise_a_lower_bound_and_no_direction) {
    const Fixture f;
    BOOST_TEST(f.checker->getSpecs().clearanceComputationType ==
               ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE);
    BOOST_TEST(!f.checker->getSpecs().hasValidDirectionComputation);
}

BOOST_AUTO_TEST_CASE(a_wrong_margin_or_models_of_different_widths_are_refused) {
    const Fixture f;
    for (const double margin : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        Scene scene = f.window.scene;
        scene.obstacles[0].margin = margin;
        BOOST_CHECK_THROW(ValidityChecker(f.si, scene), std::invalid_argument);
    }
    BuildOptions binary;
    binary.nodeWidth = 2;
    const Scene mixed{f.window.scene.part, Model::build(f.window.wallMesh, binary), 0};
    BOOST_CHECK_THROW(ValidityChecker(f.si, mixed), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(an_empty_callback_is_refused) {
    const Fixture f;
    BOOST_CHECK_THROW(ValidityChecker(f.si, SharedScene(f.window.scene, StateToPose())),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
