#include "clearway/planning/motion_validator.h"

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/ScopedState.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "clearway/planning/validity_checker.h"
#include "support/motion_window.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(motion_validator_test)

using Fixture = testing::MotionWindow;
using testing::withLeastInterval;

BOOST_AUTO_TEST_CASE(a_sheet_without_thickness_that_steps_jump_is_met) {
    Mesh sheet;
    sheet.vertices = {{0, -90, -90}, {0, 90, -90}, {0, 0, 90}};
    sheet.triangles = {{0, 1, 2}};
    const Fixture f;
    const Scene scene{f.window.scene.part, Model::build(sheet), 0};
    const auto si = std::make_shared<ob::SpaceInformation>(f.space);
    si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, scene));
    si->setStateValidityCheckingResolution(0.5);
    si->setup();
    const ob::DiscreteMotionValidator discrete(si);
    const MotionValidator certified(si, scene);
    const auto s1 = f.at({-35, 0, 0}), s2 = f.at({35, 0, 0});
    BOOST_TEST(discrete.checkMotion(s1.get(), s2.get()));
    BOOST_TEST(!certified.checkMotion(s1.get(), s2.get()));
    BOOST_TEST(certified.counters().invalid == 1u);
    BOOST_TEST(certified.counters().undecided == 0u);
}

BOOST_AUTO_TEST_CASE(a_motion_with_little_clearance_all_along_is_valid) {
    for (const double margin : {0.0, 1.5}) {
        const Fixture f(margin);
        const double x = -32 - margin - 0.02;
        BOOST_TEST(f.check(f.at({x, -40, 20}), f.at({x, 30, -20})));
        // The length is 80.6 / 0.02 clearances, which bounds the number of queries.
        BOOST_TEST(f.validator->counters().queries < 2.5 * 80.7 / 0.02);
        BOOST_TEST(f.check(f.at({x, -40, 20}), f.at({-80, 30, -20}, 0.3)));
    }
}

BOOST_AUTO_TEST_CASE(what_comes_too_close_to_tell_is_undecided_and_no_motion_along_a_face_is) {
    const Fixture coarse(0, withLeastInterval(0.1)), fine(0, withLeastInterval(1e-7));
    // So near that what the rates of OMPL's interpolation may be off counts, which shorter intervals make less.
    const auto s1 = coarse.at({-32 - 1e-7, -20, 30}), s2 = coarse.at({-32 - 1e-7, 20, 30});
    BOOST_TEST(!coarse.check(s1, s2));
    BOOST_TEST(coarse.validator->counters().undecided == 1u);
    BOOST_TEST((coarse.report(s1, s2).verdict == MotionVerdict::kUndecided));
    BOOST_TEST(fine.check(s1, s2));
    BOOST_TEST(coarse.check(coarse.at({-32 - 1e-3, -20, 30}), coarse.at({-32 - 1e-3, 20, 30})));
    const auto touching = fine.at({-32, 0, 30});
    BOOST_TEST(!fine.check(s1, touching));
    BOOST_TEST(fine.validator->counters().invalid == 1u);
    BOOST_TEST(fine.validator->counters().undecided == 0u);
}

BOOST_AUTO_TEST_CASE(a_motion_that_would_take_long_is_undecided_as_soon_as_it_is_stopped) {
    MotionOptions options = withLeastInterval(1e-5);
    int asked = 0;
    options.isStopped = [&] { return ++asked > 50; };
    const Fixture f(0, options);
    const auto s1 = f.at({-32 - 1e-10, -20, 30}), s2 = f.at({-32 - 1e-10, 20, 30});
    BOOST_TEST(!f.check(s1, s2));  // would look at a million pairs
    BOOST_TEST(f.validator->counters().undecided == 1u);
    BOOST_TEST(f.validator->counters().queries < 60u);
    BOOST_TEST((f.report(s1, s2).verdict == MotionVerdict::kUndecided));

    const Fixture unstopped(0, withLeastInterval(1e-5));
    asked = 0;
    BOOST_TEST(!unstopped.validator->keepsClearance(s1.get(), s2.get(), 0, [&] { return ++asked > 50; }));
    BOOST_TEST(unstopped.validator->counters().undecided == 1u);
    BOOST_TEST(unstopped.validator->counters().queries < 60u);
}

BOOST_AUTO_TEST_CASE(a_profile_ends_as_soon_as_it_is_stopped) {
    MotionOptions options;
    int asked = 0, most = 0;
    options.isStopped = [&] { return ++asked > most; };
    const Fixture f(0, options);
    const auto s1 = f.at({-90, 0, 30}), s2 = f.at({0, 0, 30}, 1);
    for (most = 0; most < 60; most += 5) {
        asked = 0;
        const MotionProfile profile = f.validator->profile(s1.get(), s2.get());
        BOOST_TEST(profile.points.size() < 300u, "stopped after " << most);
        BOOST_TEST(profile.points.front().time == 0);
        BOOST_TEST(profile.points.back().time == 1);
    }
}

BOOST_AUTO_TEST_CASE(a_collision_reached_by_grazing_is_told_as_one) {
    const Fixture f;
    for (const double depth : {1e-4, 0.01, 0.1}) {
        const auto s1 = f.at({-32.1, -20, 30}), s2 = f.at({-32 + depth, 20, 30});
        BOOST_TEST(!f.check(s1, s2));
        const MotionReport report = f.report(s1, s2);
        BOOST_TEST((report.verdict == MotionVerdict::kInvalid));
        BOOST_TEST(report.upperClearance <= 0);
        BOOST_TEST(report.certifiedTime > 0);
        BOOST_TEST(report.certifiedTime < report.blockedTime);
        BOOST_TEST(report.blockedTime >= 0.1 / (0.1 + depth));
    }
    BOOST_TEST(f.validator->counters().undecided == 0u);
}

BOOST_AUTO_TEST_CASE(a_motion_that_stays_is_valid_however_close_it_is) {
    const Fixture f;
    const auto close = f.at({-32 - 1e-9, 0, 30}, M_PI, Vector3::UnitX());
    BOOST_TEST(f.check(close, close));
    auto negated = close;  // an equal pose with another sign
    for (int i = 3; i < 7; ++i) negated[static_cast<unsigned int>(i)] *= -1;
    BOOST_TEST(f.check(close, negated));
}

BOOST_AUTO_TEST_CASE(a_turn_that_ompl_leaves_out_until_the_end_counts_at_the_end) {
    // The plate's corner is 20 to the side: a turn by 8e-5 brings it 0.0016 nearer.
    const Fixture f(0, withLeastInterval(1e-6));
    for (const double gap : {0.001, 0.01}) {
        const auto s1 = f.at({-32 - gap, 0, 30}), s2 = f.at({-32 - gap, 0, 30}, 8e-5);
        ob::ScopedState<> end(f.space);
        f.space->interpolate(s1.get(), s2.get(), 1, end.get());
        BOOST_TEST((end == s1));
        BOOST_TEST(f.check(s1, s2) == (gap > 20 * 8e-5));
        BOOST_TEST(f.check(s2, s1) == (gap > 20 * 8e-5));
        // s2 is free, but the interpolated states before it keep the turn of s1.
        const auto turned = f.at({-40, 0, 30}, 8e-5), straight = f.at({-32 - gap, 0, 30});
        BOOST_TEST(f.si->isValid(straight.get()));
        BOOST_TEST(f.check(turned, straight) == (gap > 20 * 8e-5));
        const MotionReport report = f.report(turned, straight);
        const double nearest = gap - 20 * 8e-5;
        if (nearest > 0) {
            BOOST_TEST(report.lowerClearance <= nearest * (1 + 1e-6));
            BOOST_TEST(report.lowerClearance >= 0.8 * nearest);
        } else {
            BOOST_TEST(report.closest.collides());
            BOOST_TEST(report.closestTime < 1);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_report_names_the_interpolation_before_the_end_where_only_that_is_blocked) {
    // The interpolation keeps the turn of the start and touches by 1e-5 at its end; s2 is free.
    const Fixture f;
    const auto turned = f.at({-40, 0, 30}, 8e-5), straight = f.at({-32 - 20 * 8e-5 + 1e-5, 0, 30});
    const MotionReport report = f.report(turned, straight);
    BOOST_TEST(f.si->isValid(straight.get()));
    BOOST_TEST((report.verdict == MotionVerdict::kInvalid));
    BOOST_TEST(report.blockedTime < 1);
    ob::ScopedState<> blocked(f.space);
    f.space->interpolate(turned.get(), straight.get(), report.blockedTime, blocked.get());
    BOOST_TEST(!f.si->isValid(blocked.get()));
    BOOST_TEST(report.upperClearance <= 0);
}

BOOST_AUTO_TEST_CASE(a_turn_that_ompl_leaves_out_does_not_blur_the_clearance_at_the_end) {
    // The turn moves the plate's corner by 0.0016.
    const Fixture f;
    const MotionValidator byClearance(f.si, SharedScene(f.window.scene, stateToPose(*f.space),
                                                        displacementBound(*f.space, f.window.scene.part)));
    const auto from = f.at({-40, 0, 30}), to = f.at({-32 - 0.01, 0, 30}, 8e-5);
    const MotionValidator* const validators[] = {f.validator.get(), &byClearance};
    for (const MotionValidator* validator : validators) {
        const MotionReport report = validator->report(from.get(), to.get());
        BOOST_TEST((report.verdict == MotionVerdict::kValid));
        BOOST_TEST(report.upperClearance == 0.01 - 20 * 8e-5, boost::test_tools::tolerance(1e-4));
        BOOST_TEST(report.lowerClearance <= report.upperClearance);
        BOOST_TEST(report.lowerClearance >= 0.9 * report.upperClearance);
    }
}

BOOST_AUTO_TEST_CASE(in_the_plane_the_shorter_turn_is_taken_across_the_seam) {
    // In the plane z = 0 the window is 64 wide, the part 60 x 40: inside, it turns a little.
    const Fixture f(0, {}, Space::kSe2);
    BOOST_TEST(f.check(f.at({0, 0, 0}, M_PI - 0.1), f.at({0, 0, 0}, -M_PI + 0.1)));
    BOOST_TEST(!f.check(f.at({0, 0, 0}, 0.1), f.at({0, 0, 0}, M_PI - 0.1)));
    BOOST_TEST(f.check(f.at({-60, 60, 0}, 0.1), f.at({-60, 60, 0}, M_PI - 0.1)));
    const MotionReport report = f.report(f.at({-60, 60, 0}, M_PI - 0.4), f.at({-60, 60, 0}, -M_PI + 0.4));
    const double corner = std::hypot(30, 20);  // reaches its nearest at atan2(20, 30) = 0.588 > 0.4
    const double nearest = 58 - corner * std::cos(std::atan2(20, 30) - 0.4);
    BOOST_TEST(report.upperClearance == nearest, boost::test_tools::tolerance(1e-2));
    BOOST_TEST(report.lowerClearance <= nearest);
    BOOST_TEST(report.lowerClearance >= 0.98 * nearest);
}

BOOST_AUTO_TEST_CASE(last_valid_is_close_to_what_blocks_and_can_be_gone_on_from) {
    for (const double margin : {0.0, 2.0}) {
        const Fixture f(margin);
        const auto s1 = f.at({-90, 0, 30}), s2 = f.at({0, 0, 30}, M_PI / 2);
        ob::ScopedState<> reached(f.space);
        std::pair<ob::State*, double> lastValid(reached.get(), -1);
        BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get(), lastValid));
        const double clearance = f.si->getStateValidityChecker()->clearance(reached.get());
        BOOST_TEST(clearance > f.validator->leastInterval());
        BOOST_TEST(clearance < 100 * f.validator->leastInterval());
        BOOST_TEST(f.check(s1, reached));
        BOOST_TEST(f.check(reached, s1));
    }
}

BOOST_AUTO_TEST_CASE(the_bounds_end_a_motion_where_they_are) {
    const Fixture f;
    const auto s1 = f.at({-60, 0, 0}), inside = f.at({-100, 60, -60}, 1), outside = f.at({-160, 0, 0}, 1);
    BOOST_TEST(f.check(s1, inside));
    BOOST_TEST(!f.check(s1, outside));
    BOOST_TEST(!f.check(outside, s1));
    std::pair<ob::State*, double> lastValid(nullptr, -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), outside.get(), lastValid));
    BOOST_TEST(lastValid.second <= 0.4);
    BOOST_TEST(lastValid.second > 0.398);
    BOOST_TEST(!f.validator->checkMotion(outside.get(), s1.get(), lastValid));
    BOOST_TEST(lastValid.second == 0);
    BOOST_TEST(f.validator->counters().invalidStarts == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
