#include "clearway/planning/motion_validator.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clearway/scene_clearance.h"
#include "planning/space/ompl_states.h"
#include "support/full_run.h"
#include "support/motion_window.h"
#include "support/ompl_log.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(motion_validator_use_test)

using Fixture = testing::MotionWindow;
using testing::withLeastInterval;

BOOST_AUTO_TEST_CASE(a_report_tells_what_blocks_and_where) {
    const Fixture f(0.5);
    const MotionReport blocked = f.report(f.at({-62.5, 0, 30}), f.at({37.5, 0, 30}));
    BOOST_TEST((blocked.verdict == MotionVerdict::kInvalid));
    BOOST_TEST(blocked.certifiedTime < 0.3);
    BOOST_TEST(blocked.certifiedTime > 0.2999);
    BOOST_TEST(blocked.lowerClearance == -0.5);
    BOOST_TEST(blocked.upperClearance <= 0);
    BOOST_TEST(blocked.closestTime >= 0.3);
    BOOST_REQUIRE(blocked.closest.witness);
    const auto& components = f.window.scene.obstacles[0].model.components();
    BOOST_TEST(components[static_cast<std::size_t>(blocked.closest.witness->environmentComponent)].name ==
               "above");
    BOOST_TEST(blocked.closest.witness->partComponent == 0);
    BOOST_TEST(blocked.queries > 2u);
    BOOST_TEST(f.validator->counters().invalid == 0u);  // reports are not counted

    const MotionReport start = f.report(f.at({0, 0, 30}), f.at({37.5, 0, 30}));
    BOOST_TEST((start.verdict == MotionVerdict::kInvalid));
    BOOST_TEST(start.certifiedTime == 0);
}

BOOST_AUTO_TEST_CASE(a_report_bounds_the_clearance_of_a_valid_motion) {
    for (const double margin : {0.0, 2.0}) {
        const Fixture f(margin);
        // Through the window, 11 from its upper and lower side, 12 from the others; then aside.
        const MotionReport through = f.report(f.at({-60, 0, 0}), f.at({60, 0, 0}));
        BOOST_TEST((through.verdict == MotionVerdict::kValid));
        BOOST_TEST(through.certifiedTime == 1);
        BOOST_TEST(through.upperClearance == 11 - margin, boost::test_tools::tolerance(1e-9));
        BOOST_TEST(through.lowerClearance <= 11 - margin);
        BOOST_TEST(through.lowerClearance >= 0.99 * (11 - margin) - 1e-3 * 73);
        BOOST_TEST(through.closest.distance == 11, boost::test_tools::tolerance(1e-9));
        const MotionReport close =
            f.report(f.at({-32.01 - margin, -20, 30}), f.at({-40, 20, 40}, 0.1, Vector3::UnitX()));
        BOOST_TEST(close.upperClearance == 0.01, boost::test_tools::tolerance(1e-9));
        BOOST_TEST(close.lowerClearance <= 0.01);
        BOOST_TEST(close.lowerClearance >= 0.009);
        const MotionReport off = f.report(f.at({-60, 0, 30}), f.at({-90, 10, 40}, 1));
        BOOST_TEST(off.upperClearance == 28 - margin, boost::test_tools::tolerance(1e-2));
        BOOST_TEST(off.lowerClearance >= 0.98 * (28 - margin) - 1e-3 * 73);
    }
}

BOOST_AUTO_TEST_CASE(a_profile_bounds_the_clearance_from_each_pose_to_the_next) {
    const Fixture f(1);
    const auto s1 = f.at({-60, 0, 0}), s2 = f.at({-42, 30, 20}, 2.5, {1, 2, 3});
    const MotionProfile profile = f.validator->profile(s1.get(), s2.get());
    const std::vector<ProfilePoint>& points = profile.points;
    BOOST_REQUIRE((profile.report.verdict == MotionVerdict::kValid));
    BOOST_REQUIRE(points.size() > 3u);
    BOOST_TEST(points.front().time == 0);
    BOOST_TEST(points.back().time == 1);
    ob::ScopedState<> between(f.space);
    double least = points[0].clearance;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const ProfilePoint &here = points[k], &next = points[k + 1];
        BOOST_TEST(here.time < next.time);
        BOOST_TEST(here.lowerToNext >= 0.79 * std::min(here.clearance, next.clearance));
        BOOST_TEST(here.lowerToNext >= profile.report.lowerClearance);
        for (int i = 0; i <= 10; ++i) {
            const double time = here.time + (next.time - here.time) * i / 10;
            f.space->interpolate(s1.get(), s2.get(), time, between.get());
            BOOST_TEST(f.si->getStateValidityChecker()->clearance(between.get()) >= here.lowerToNext - 1e-9);
        }
        least = std::min(least, next.clearance);
    }
    BOOST_TEST(profile.report.upperClearance == least, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(profile.report.travel >= (Vector3(18, 30, 20)).norm());
}

BOOST_AUTO_TEST_CASE(a_profile_by_clearances_holds_up_to_the_last_valid_pose) {
    const Fixture f;
    const MotionValidator byClearance(f.si, SharedScene(f.window.scene, stateToPose(*f.space),
                                                        displacementBound(*f.space, f.window.scene.part)));
    ob::ScopedState<> between(f.space);
    for (int seed = 1; seed <= testing::inForm(20, 8); ++seed) {
        testing::Random random(seed);
        const auto s1 = f.at(Vector3(-60, 0, 0) + random.inBox(20), random.uniform(0, 3));
        const auto s2 = f.at({0, 0, 30}, random.uniform(0, 3));
        const MotionProfile profile = byClearance.profile(s1.get(), s2.get());
        BOOST_TEST(profile.points.front().time == 0);
        for (std::size_t k = 0; k + 1 < profile.points.size(); ++k) {
            const ProfilePoint &here = profile.points[k], &next = profile.points[k + 1];
            f.space->interpolate(s1.get(), s2.get(), here.time + 0.999 * (next.time - here.time),
                                 between.get());
            const double clearance = f.si->getStateValidityChecker()->clearance(between.get());
            BOOST_TEST(here.lowerToNext <= clearance + 1e-9, "seed " << seed << ", at time " << here.time);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_profile_goes_on_behind_what_blocks) {
    const Fixture f;
    const auto s1 = f.at({-60, 0, 30}), s2 = f.at({60, 0, 30}), outside = f.at({-160, 0, 30});
    const MotionProfile through = f.validator->profile(s1.get(), s2.get());
    BOOST_TEST((through.report.verdict == MotionVerdict::kInvalid));
    BOOST_TEST((through.report.whyInvalid.kind == WhyInvalid::Kind::kCollides));
    BOOST_TEST(through.report.blockedTime >= through.report.certifiedTime);
    BOOST_TEST(through.report.upperClearance == 0);
    BOOST_TEST(through.points.back().time == 1);
    BOOST_TEST(through.points.back().clearance == 28, boost::test_tools::tolerance(1e-9));
    int blocked = 0;
    for (const ProfilePoint& point : through.points) {
        blocked += point.clearance <= 0;
        if (point.time >= through.report.certifiedTime) BOOST_TEST(point.lowerToNext <= 0);
    }
    BOOST_TEST(blocked > 3);

    const MotionReport out = f.report(s1, outside);
    BOOST_TEST((out.verdict == MotionVerdict::kInvalid));
    BOOST_TEST((out.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds));
    const MotionProfile in = f.validator->profile(outside.get(), s1.get());
    BOOST_TEST((in.report.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds));
    BOOST_TEST(in.report.blockedTime == 0);
    for (const ProfilePoint& point : in.points) BOOST_TEST((point.clearance > 0) == (point.time >= 0.6));
    const auto nowhere = f.at({std::nan(""), 0, 0});
    const MotionProfile none = f.validator->profile(s1.get(), nowhere.get());
    BOOST_TEST(none.points.empty());
    BOOST_TEST((none.report.whyInvalid.kind == WhyInvalid::Kind::kNoPose));
}

// The part starts less than a least interval from a block and slides along a plate, so that 0 is its least clearance.
BOOST_AUTO_TEST_CASE(a_motion_from_a_tight_start_along_a_plate_takes_no_longer_than_others) {
    const auto boxAt = [](const Vector3& halfSides, const Vector3& place) {
        return testing::translated(testing::box(halfSides), place);
    };
    const Mesh blockAndPlate =
        testing::joined(boxAt({1, 9, 3}, {-5, 0, 0}), boxAt({90, 9, 1}, {99, 0, -1.5}));
    const Scene scene(Model::build(testing::box({3, 2, 0.5})), Model::build(blockAndPlate));
    const testing::PartInSpace space(scene);
    const auto s1 = space.at({-1 + 1e-6, 0, 0}), s2 = space.at({250, 0, 0});
    takeQueryTally();
    BOOST_TEST((space.validator->report(s1.get(), s2.get()).verdict == MotionVerdict::kInvalid));
    BOOST_TEST(takeQueryTally().work.triangleTests < 20000u);
}

BOOST_AUTO_TEST_CASE(a_motion_keeps_a_clearance_when_it_is_valid_with_larger_margins) {
    const Fixture f(1), more(3.5);
    testing::Random random(7);
    int kept = 0, lost = 0;
    for (int i = 0; i < 300; ++i) {
        const auto state = [&] {
            const Vector3 position = Vector3(-53, 0, 0) + random.inBox(18);
            const double angle = random.uniform(-3, 3);
            return f.at(position, angle, random.direction());
        };
        const auto s1 = state(), s2 = state();
        const bool keeps = f.validator->keepsClearance(s1.get(), s2.get(), 2.5);
        BOOST_TEST(keeps == more.check(s1, s2), "seed 7, motion " << i);
        BOOST_TEST(f.validator->keepsClearance(s1.get(), s2.get(), 0) == f.check(s1, s2));
        ++(keeps ? kept : lost);
    }
    BOOST_TEST(kept > 20);
    BOOST_TEST(lost > 20);
    const auto s1 = f.at({-60, 0, 0});
    BOOST_CHECK_THROW(f.validator->keepsClearance(s1.get(), s1.get(), -1), std::invalid_argument);
    BOOST_CHECK_THROW(f.validator->keepsClearance(s1.get(), s1.get(), std::nan("")), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(every_outcome_is_counted) {
    const Fixture f;
    const auto start = f.at({-60, 0, 0}), near = f.at({-50, 0, 0}), in = f.at({0, 0, 30});
    f.check(start, near);
    f.check(start, in);
    f.check(in, start);
    f.check(f.at({-32 - 1e-12, 0, 30}), f.at({-32 - 1e-12, 10, 30}));
    const MotionCounters counters = f.validator->counters();
    BOOST_TEST(counters.valid == 1u);
    BOOST_TEST(counters.invalid == 3u);
    BOOST_TEST(counters.undecided == 1u);
    BOOST_TEST(counters.invalidStarts == 1u);
    BOOST_TEST(counters.unusable == 0u);
    BOOST_TEST(counters.queries >= 7u);
    BOOST_TEST(f.validator->getValidMotionCount() == 1u);
    BOOST_TEST(f.validator->getInvalidMotionCount() == 3u);
}

BOOST_AUTO_TEST_CASE(another_space_is_refused_by_name_and_works_through_callbacks) {
    const Fixture f;
    const auto line = std::make_shared<ob::RealVectorStateSpace>(1);  // along x, lying flat
    line->setBounds(-100, 100);
    line->setName("rail");
    const auto si = std::make_shared<ob::SpaceInformation>(line);
    testing::requireRefusedBy([&] { MotionValidator(si, f.window.scene); }, {"'rail'"});
    const auto car = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::DubinsStateSpace>());
    testing::requireRefusedBy([&] { MotionValidator(car, f.window.scene); },
                              {"displacement bound of its own"});

    const auto xOf = [](const ob::State* state) {
        return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
    };
    const auto railAt = [&](double z) {
        return SharedScene(
            f.window.scene,
            [xOf, z](const ob::State* s) {
                return Pose{Matrix3::Identity(), {xOf(s), 0, z}};
            },
            [xOf](const ob::State* a, const ob::State* b) { return std::abs(xOf(a) - xOf(b)); });
    };
    const MotionValidator onRail(si, railAt(0)), raised(si, railAt(12));
    ob::ScopedState<ob::RealVectorStateSpace> a(line), b(line), outside(line);
    a[0] = -60;
    b[0] = 60;
    outside[0] = 101;
    BOOST_TEST(onRail.checkMotion(a.get(), b.get()));
    BOOST_TEST(!onRail.checkMotion(a.get(), outside.get()));
    BOOST_TEST(!raised.checkMotion(a.get(), b.get()));
}

BOOST_AUTO_TEST_CASE(a_motion_shorter_than_any_number_of_use_is_still_looked_at) {
    const testing::WindowScene window = testing::windowScene();
    const auto space = makeSpace(Space::kSe2, Box(Vector3::Constant(-90), Vector3::Constant(90)), 1);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const MotionValidator validator(si, window.scene);
    for (const double turn : {4.9e-324, 1e-320, 1e-310, 1e-300}) {
        for (const double y : {0.0, 40.0}) {  // in the window, and in the wall
            ob::ScopedState<ob::SE2StateSpace> a(space), b(space);
            a->setXY(0, y);
            b->setXY(0, y);
            a->setYaw(0);
            b->setYaw(turn);
            std::pair<ob::State*, double> lastValid(nullptr, 1);
            BOOST_TEST(validator.checkMotion(a.get(), b.get()) == (y == 0), "turn " << turn);
            BOOST_TEST(validator.checkMotion(a.get(), b.get(), lastValid) == (y == 0), "turn " << turn);
            if (y > 0) BOOST_TEST(!validator.keepsClearance(a.get(), b.get(), 1));
        }
    }
}

BOOST_AUTO_TEST_CASE(nothing_is_thrown_by_a_motion_that_cannot_be_judged) {
    const Fixture f;
    const auto s1 = f.at({-60, 0, 0}), s2 = f.at({-50, 0, 0});
    const auto fails = [](const ob::State*) -> Pose { throw std::runtime_error("no kinematics here"); };
    const auto nowhere = [](const ob::State*) {
        return Pose{Matrix3::Constant(std::nan("")), Vector3::Constant(std::nan(""))};
    };
    const DisplacementBound bound = displacementBound(*f.space, f.window.scene.part);
    const DisplacementBound none = [](const ob::State*, const ob::State*) { return HUGE_VAL; };
    const struct {
        StateToPose toPose;
        DisplacementBound bound;
        std::string words;
    } cases[] = {{fails, bound, "no kinematics here"},
                 {nowhere, bound, "pose"},
                 {stateToPose(*f.space), none, "no finite displacement bound"}};
    for (const auto& wrong : cases) {
        const MotionValidator validator(f.si, SharedScene(f.window.scene, wrong.toPose, wrong.bound));
        testing::OmplLog log;
        std::pair<ob::State*, double> lastValid(nullptr, -1);
        BOOST_TEST(!validator.checkMotion(s1.get(), s2.get()));
        BOOST_TEST(!validator.checkMotion(s1.get(), s2.get(), lastValid));
        BOOST_TEST(lastValid.second == 0);
        BOOST_TEST(validator.counters().unusable == 2u);
        BOOST_TEST(validator.counters().invalid == 2u);
        BOOST_TEST(log.lines.size() == 1u);
        BOOST_TEST(log.lines.at(0).find(wrong.words) != std::string::npos);
        const MotionReport report = validator.report(s1.get(), s2.get());
        BOOST_TEST((report.verdict == MotionVerdict::kInvalid));
        BOOST_TEST(report.whyInvalid.isUnusable());
        BOOST_TEST(report.whyInvalid.reason.find(wrong.words) != std::string::npos);
    }
}

BOOST_AUTO_TEST_CASE(an_environment_within_reach_gives_the_same_verdicts) {
    for (const double margin : {0.0, 2.0}) {
        const Fixture f(margin);
        Mesh environment =
            testing::joined(f.window.wallMesh, testing::translated(f.window.wallMesh, {400, 0, 0}));
        const double radius = f.window.scene.part.radiusAboutOrigin();
        QueryRange range{Box(Vector3(-101, -61, -61), Vector3(101, 61, 61)), radius, margin + 1};
        const auto scene = [&] {
            return Scene{f.window.scene.part, Model::build(environment, {}, range), margin};
        };
        BOOST_TEST(scene().obstacles[0].model.range().has_value());
        const MotionValidator validator(f.si, scene());
        for (int seed = 1; seed <= testing::inForm(200, 70); ++seed) {
            testing::Random random(seed);
            const auto s1 = f.at(Vector3(-60, 0, 0) + random.inBox(40), random.uniform(0, 3));
            const auto s2 = f.at(Vector3(-30, 0, 0) + random.inBox(40), random.uniform(0, 3));
            BOOST_TEST_CONTEXT("seed " << seed << ", margin " << margin) {
                BOOST_TEST(validator.checkMotion(s1.get(), s2.get()) == f.check(s1, s2));
            }
        }
        const MotionReport report = validator.report(f.at({-90, 0, 0}).get(), f.at({-50, 0, 0}).get());
        BOOST_TEST((report.verdict == MotionVerdict::kValid));
        BOOST_TEST(report.lowerClearance > 0.9);
        BOOST_TEST(report.lowerClearance <= 1);
        BOOST_TEST(std::isinf(report.upperClearance));
        BOOST_TEST(!report.closest.witness);
        const auto beyondRange = f.at({-120, 0, 0});
        const MotionProfile from = validator.profile(beyondRange.get(), f.at({-50, 0, 0}).get());
        BOOST_TEST((from.report.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds));
        range.cap = margin;
        testing::requireRefusedBy([&] { MotionValidator(f.si, scene()); },
                                  {"expected at least the margin and the least interval"});
    }
}

Mesh sheet(double halfSide) {
    Mesh mesh;
    mesh.vertices = {{-halfSide, -halfSide, 0},
                     {halfSide, -halfSide, 0},
                     {halfSide, halfSide, 0},
                     {-halfSide, halfSide, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

BOOST_AUTO_TEST_CASE(a_face_that_meets_a_sheet_all_at_once_is_told_as_a_collision) {
    const testing::PartInSpace space(
        Scene(Model::build(testing::box({0.005, 0.005, 0.005})), Model::build(sheet(1))));
    const MotionReport report =
        space.validator->report(space.at({0, 0, 0.2}).get(), space.at({0, 0, -0.2}, 2e-4).get());
    BOOST_TEST((report.verdict == MotionVerdict::kInvalid));
    BOOST_TEST(report.certifiedTime == 0.195 / 0.4, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(report.blockedTime < report.certifiedTime + 1e-4);
    BOOST_TEST(report.upperClearance == 0);
}

BOOST_AUTO_TEST_CASE(a_long_way_far_from_everything_takes_few_queries) {
    const testing::PartInSpace space(
        Scene(Model::build(testing::box({1, 1, 1})), Model::build(testing::box({5, 5, 5}))), 1e9);
    const double end = testing::inForm(100000000, 1000000);
    const MotionProfile profile =
        space.validator->profile(space.at({0, 0, 20}).get(), space.at({0, 0, end}, 1).get());
    BOOST_TEST((profile.report.verdict == MotionVerdict::kValid));
    BOOST_TEST(profile.report.queries < 1000u);
    for (const ProfilePoint& point : profile.points) {
        const double height = 20 + point.time * (end - 20);
        if (point.time == 1) continue;
        BOOST_TEST(point.lowerToNext <= height - 6);
        BOOST_TEST(point.lowerToNext > 0.5 * (height - 7));
    }
}

BOOST_AUTO_TEST_CASE(wrong_options_and_empty_callbacks_are_refused) {
    const Fixture f;
    for (const double length : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        testing::requireRefusedBy([&] { MotionValidator(f.si, f.window.scene, withLeastInterval(length)); },
                                  {"leastInterval is "});
    }
    for (const double margin : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        Scene scene = f.window.scene;
        scene.obstacles[0].margin = margin;
        testing::requireRefusedBy([&] { MotionValidator(f.si, scene); }, {"margin is "});
    }
    const DisplacementBound bound = displacementBound(*f.space, f.window.scene.part);
    const SharedScene shared(f.window.scene);
    const StateToPose pose = stateToPose(*f.space);
    testing::requireRefusedBy([&] { SharedScene(shared, StateToPose(), bound); }, {"stateToPose"});
    testing::requireRefusedBy([&] { SharedScene(shared, pose, DisplacementBound()); },
                              {"displacement bound is empty"});
    testing::requireRefusedBy([&] { SharedScene(shared, pose, bound, StateMotion()); },
                              {"state motion is empty"});
    testing::requireRefusedBy([&] { MotionValidator(f.si, SharedScene(shared, pose)); },
                              {"displacement bound is empty"});
    testing::requireRefusedBy([&] { SharedScene(std::shared_ptr<const SceneClearance>()); },
                              {"scene clearance is null"});
    BOOST_TEST(MotionValidator(f.si, f.window.scene).leastInterval() == 1e-5 * Vector3(60, 40, 10).norm(),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
