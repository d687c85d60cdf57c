// Se3Space is OMPL's SE(3), to the last digit.
#include "clearway/planning/se3_space.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(se3_space_test)

namespace ob = ompl::base;

template <class Space>
std::shared_ptr<Space> bounded() {
    auto space = std::make_shared<Space>();
    ob::RealVectorBounds bounds(3);
    bounds.setLow(-90);
    bounds.setHigh(90);
    space->setBounds(bounds);
    space->setSubspaceWeight(1, 36.4);
    space->setup();
    return space;
}

/// Random states, the next one often near the last one, and opposite quaternions.
std::vector<std::vector<double>> manyStates() {
    testing::Random random(4);
    std::vector<std::vector<double>> all;
    for (int i = 0; i < 400; ++i) {
        const Vector3 position = random.inBox(80);
        Eigen::Quaterniond turn(random.rotation());
        if (i % 3 == 1)
            turn.coeffs() =
                -Eigen::Quaterniond(all.back()[6], all.back()[3], all.back()[4], all.back()[5]).coeffs();
        if (i % 3 == 2)
            turn = Eigen::Quaterniond(
                       Eigen::AngleAxisd(std::pow(10, random.uniform(-9, 0)), random.direction())) *
                   turn;
        all.push_back({position.x(), position.y(), position.z(), turn.x(), turn.y(), turn.z(), turn.w()});
    }
    return all;
}

BOOST_AUTO_TEST_CASE(distances_copies_and_interpolations_are_those_of_ompl) {
    const auto whole = bounded<Se3Space>();
    const auto ompls = bounded<ob::SE3StateSpace>();
    whole->sanityChecks();
    ob::ScopedState<> a(whole), b(whole), between(whole), c(ompls), d(ompls), expected(ompls);
    const auto states = manyStates();
    for (std::size_t i = 1; i < states.size(); ++i) {
        a = c = states[i - 1];
        b = d = states[i];
        BOOST_TEST(whole->distance(a.get(), b.get()) == ompls->distance(c.get(), d.get()));
        BOOST_TEST(whole->distance(a.get(), d.get()) == ompls->distance(c.get(), d.get()));
        whole->interpolate(a.get(), b.get(), 0.3, between.get());
        ompls->interpolate(c.get(), d.get(), 0.3, expected.get());
        BOOST_TEST((between.reals() == expected.reals()));
        ob::State* copy = whole->cloneState(b.get());
        BOOST_TEST(whole->equalStates(copy, b.get()));
        BOOST_TEST(whole->satisfiesBounds(copy));
        whole->freeState(copy);
    }
}

BOOST_AUTO_TEST_CASE(a_motion_validator_takes_it_for_se3) {
    const testing::WindowScene window = testing::windowScene();
    const auto space = bounded<Se3Space>();
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const MotionValidator validator(si, window.scene);
    ob::ScopedState<ob::SE3StateSpace> start(space), goal(space);
    for (auto* state : {&start, &goal}) (*state)->rotation().setIdentity();
    start->setXYZ(-60, 0, 0);
    goal->setXYZ(60, 0, 0);
    BOOST_TEST(validator.checkMotion(start.get(), goal.get()));
    start->setZ(12);
    goal->setZ(12);
    BOOST_TEST(!validator.checkMotion(start.get(), goal.get()));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
