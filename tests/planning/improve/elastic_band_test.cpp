// Bands give paths room, and never take any.
#include "planning/improve/elastic_band.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "clearway/planning/audit.h"
#include "clearway/planning/problem_setup.h"
#include "support/motion_window.h"
#include "support/planar_scenes.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(elastic_band_test)

using Fixture = testing::MotionWindow;

/// Through the window, up and down, by 0.01 from its border.
og::PathGeometric grazing(const Fixture& f) {
    return pathOf(f, {f.at({-60, 0, 0}), f.at({-34, 0, 0}), f.at({-20, 0, 10.99}), f.at({-10, 0, -10.99}),
                      f.at({0, 0, 10.99}), f.at({10, 0, -10.99}), f.at({20, 0, 10.99}), f.at({60, 0, 0})});
}

constexpr double kGrazing = 0.009;  ///< that path keeps it
constexpr double kWindow = 11;      ///< above and below the plate in the middle of the window

WideningOptions withSweeps(std::uint64_t sweeps, double clearance = 0) {
    WideningOptions options;
    options.sweeps = sweeps;
    options.clearance = clearance;
    return options;
}

bool allKeep(const og::PathGeometric& path, const MotionValidator& validator, double clearance) {
    for (unsigned int i = 1; i < path.getStateCount(); ++i) {
        if (!validator.keepsClearance(path.getState(i - 1), path.getState(i), clearance)) return false;
    }
    return true;
}

bool haveSameStates(const og::PathGeometric& a, const og::PathGeometric& b) {
    if (a.getStateCount() != b.getStateCount()) return false;
    for (unsigned int i = 0; i < a.getStateCount(); ++i) {
        if (!a.getSpaceInformation()->equalStates(a.getState(i), b.getState(i))) return false;
    }
    return true;
}

void requireSameEnds(const og::PathGeometric& is, const og::PathGeometric& was) {
    const auto last = [](const og::PathGeometric& path) {
        return path.getState(static_cast<unsigned int>(path.getStateCount()) - 1);
    };
    const ob::SpaceInformation& si = *was.getSpaceInformation();
    BOOST_TEST(si.equalStates(is.getState(0), was.getState(0)));
    BOOST_TEST(si.equalStates(last(is), last(was)));
}

BOOST_AUTO_TEST_CASE(a_band_ended_at_any_time_keeps_what_it_returns_and_no_less_than_before) {
    const Fixture f;
    const og::PathGeometric before = grazing(f);
    BOOST_TEST_REQUIRE(allKeep(before, *f.validator, kGrazing));
    double last = 0;
    int gained = 0;
    for (const int mostAsked : {0, 1, 10, 100, 1000, 3000, 10000, 30000, 100000}) {
        og::PathGeometric path = before;
        WideningOptions options = withSweeps(200, kGrazing);
        int asked = 0;
        options.isSpent = [&] { return ++asked > mostAsked; };
        const double kept = widenPath(path, *f.validator, options);
        BOOST_TEST_CONTEXT("asked " << mostAsked << " times") {
            BOOST_TEST(kept >= kGrazing);
            BOOST_TEST(kept >= last);
            BOOST_TEST(allKeep(path, *f.validator, kept));
            BOOST_TEST(audit(path, *f.validator).upperClearance >= kept);
            requireSameEnds(path, before);
        }
        gained += kept > last;
        last = kept;
    }
    BOOST_TEST(gained > 3);
    BOOST_TEST(last > 0.85 * kWindow);
}

BOOST_AUTO_TEST_CASE(a_margin_leaves_less_room) {
    const Fixture f(2);
    og::PathGeometric path = pathOf(f, {f.at({-60, 0, 0}), f.at({0, 3, 3}), f.at({60, 0, 0})});
    BOOST_TEST_REQUIRE(allKeep(path, *f.validator, 0));
    const double kept = widenPath(path, *f.validator, withSweeps(200));
    BOOST_TEST(kept > 0.85 * (kWindow - 2));
    BOOST_TEST(allKeep(path, *f.validator, kept));
}

BOOST_AUTO_TEST_CASE(a_path_of_two_states_gets_states_between_them) {
    const Fixture f;
    og::PathGeometric path = pathOf(f, {f.at({-60, 4, 9}), f.at({60, 4, 9})});
    BOOST_TEST_REQUIRE(!allKeep(path, *f.validator, 2.1));
    const double kept = widenPath(path, *f.validator, withSweeps(200));
    BOOST_TEST(kept > 0.85 * kWindow);
    BOOST_TEST(path.getStateCount() > 2u);
    og::PathGeometric single = pathOf(f, {f.at({-60, 0, 0})});
    BOOST_TEST(widenPath(single, *f.validator, withSweeps(9)) == 0);
}

BOOST_AUTO_TEST_CASE(no_end_and_no_wish_is_exceeded) {
    const Fixture f;
    og::PathGeometric path = grazing(f);
    WideningOptions options = withSweeps(200, kGrazing);
    options.enough = 1;
    const double enough = widenPath(path, *f.validator, options);
    BOOST_TEST(enough >= 0.99);
    BOOST_TEST(enough <= 1);
    // The plate reaches 30 from its middle and the wall's face is at x = -2.
    og::PathGeometric tight = pathOf(f, {f.at({-34, 5, 30}), f.at({-40, 0, 0}), f.at({60, 0, 0})});
    const double kept = widenPath(tight, *f.validator, withSweeps(200));
    BOOST_TEST(kept <= 2);
    BOOST_TEST(kept > 1.9);
}

BOOST_AUTO_TEST_CASE(in_the_plane_a_path_gets_to_the_middle_of_wide_gates) {
    const auto gates = testing::gatesScene();
    const auto setup = makeSetup(gates.problem, gates.scene);
    const MotionValidator& validator = motionValidatorOf(setup.getSpaceInformation());
    std::vector<PartState> states;
    for (const Vector3& place : {Vector3(-80, 0, 0), Vector3(-45, 31, 0), Vector3(-15, 31, 0),
                                 Vector3(15, -31, 0), Vector3(45, -31, 0), Vector3(80, 0, 0)}) {
        states.emplace_back();
        states.back().position = place;
    }
    og::PathGeometric path = pathThrough(setup.getSpaceInformation(), states);
    BOOST_TEST_REQUIRE(allKeep(path, validator, 0));
    BOOST_TEST_REQUIRE(!allKeep(path, validator, 1.5));
    const double kept = widenPath(path, validator, withSweeps(200));
    BOOST_TEST(kept > 0.9 * testing::kWideGates);
    BOOST_TEST(kept <= testing::kWideGates);
    BOOST_TEST(allKeep(path, validator, kept));
}

BOOST_AUTO_TEST_CASE(as_many_sweeps_give_the_same_path_bit_by_bit) {
    const Fixture first, second;
    og::PathGeometric one = grazing(first), other = grazing(second);
    const double kept = widenPath(one, *first.validator, withSweeps(40, kGrazing));
    BOOST_TEST(kept > 0.1);
    BOOST_TEST(widenPath(other, *second.validator, withSweeps(40, kGrazing)) == kept);
    BOOST_TEST(haveSameStates(one, other));
}

BOOST_AUTO_TEST_CASE(where_contact_is_ignored_the_other_obstacles_count) {
    Fixture f;
    Scene scene = f.window.scene;
    // A tray under the plate at its start, which counts again once the plate is 3 away.
    const Mesh tray = testing::translated(testing::box({40, 30, 5}, 2), {-60, 0, -10});
    scene.obstacles.push_back({Model::build(tray), 0});
    scene.obstacles.back().isIgnoredAtStart = true;
    const auto start = f.at({-60, 0, 0});
    scene.startContact = ContactZone{f.validator->pose(start.get()), 3};
    const auto si = std::make_shared<ob::SpaceInformation>(f.space);
    si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, scene));
    const auto validator = std::make_shared<MotionValidator>(si, scene);
    si->setMotionValidator(validator);
    si->setup();
    og::PathGeometric path(si);
    for (const auto& state :
         {start, f.at({-60, 0, 10}), f.at({-30, 0, 10}), f.at({0, 3, 8}), f.at({60, 0, 0})})
        path.append(state.get());
    BOOST_TEST_REQUIRE(allKeep(path, *validator, 0));
    const double before = audit(path, *validator).upperClearance;
    const double kept = widenPath(path, *validator, withSweeps(200));
    BOOST_TEST(kept > before);
    BOOST_TEST(allKeep(path, *validator, kept));
    // Without the zone no path from this start keeps anything: the plate stands on the tray.
    BOOST_TEST(kept > 0);
    scene.startContact.reset();
    scene.obstacles.back().isIgnoredAtStart = false;
    const MotionValidator strict(si, scene);
    BOOST_TEST(!allKeep(path, strict, 0));
}

BOOST_AUTO_TEST_CASE(a_spent_band_leaves_the_path_as_it_is) {
    const Fixture f;
    const og::PathGeometric before = grazing(f);
    og::PathGeometric path = before;
    WideningOptions options;
    options.clearance = kGrazing;
    options.isSpent = [] { return true; };
    BOOST_TEST(widenPath(path, *f.validator, options) == kGrazing);
    BOOST_TEST(haveSameStates(path, before));
}

BOOST_AUTO_TEST_CASE(wrong_options_and_spaces_are_refused) {
    const Fixture f;
    og::PathGeometric path = grazing(f);
    for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        BOOST_CHECK_THROW(widenPath(path, *f.validator, withSweeps(1, wrong)), std::invalid_argument);
    }
    WideningOptions options;
    options.gain = 0;
    BOOST_CHECK_THROW(widenPath(path, *f.validator, options), std::invalid_argument);
    const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(-1, 1);
    og::PathGeometric own(std::make_shared<ob::SpaceInformation>(plane));
    const ob::ScopedState<> origin(plane);
    own.append(origin.get());
    own.append(origin.get());
    BOOST_CHECK_THROW(widenPath(own, *f.validator, withSweeps(1)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
