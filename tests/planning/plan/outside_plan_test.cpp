#include <ompl/geometric/SimpleSetup.h>

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/planning/check_path.h"
#include "clearway/planning/outside_goal.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/problem_setup.h"
#include "planning/plan/finish.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(outside_plan_test)

using Outcome = PlanReport::Outcome;

/// The window's plate, to be brought to the other side of the wall, wherever.
testing::WindowScene throughTheWindow() {
    auto window = testing::windowScene();
    window.problem.outside = Outside{sideNamed("+x")};
    window.problem.goal.position = {-1e9, 0, 0};  // has no meaning
    return window;
}

/// How far the part's lowest point along x is beyond the wall, which ends at 2.
double beyondWall(const testing::WindowScene& window, const PartState& state) {
    double least = 1e9;
    for (const Vector3& vertex : window.partMesh.vertices)
        least = std::min(least, (poseOf(state) * vertex).x());
    return least - 2;
}

/// Floors that no state outside keeps within the bounds are the planner's own matter.
BOOST_AUTO_TEST_CASE(bounds_that_leave_little_room_outside_give_no_warning) {
    auto window = throughTheWindow();
    window.problem.volume = Box(Vector3(-80, -60, -60), Vector3(40, 60, 60));
    PlanOptions options;
    options.seconds = 2;
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.warnings.empty());
}

BOOST_AUTO_TEST_CASE(a_path_outside_is_free_by_the_oracle_and_ends_beyond_the_side) {
    const auto window = throughTheWindow();
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        PlanOptions options;
        options.iterations = 200000;
        options.seed = seed;
        const PlanReport report = plan(window.problem, window.scene, options);
        BOOST_REQUIRE((report.outcome == Outcome::kFound));
        BOOST_TEST(report.audit.isValid());
        BOOST_TEST(report.warnings.empty());
        BOOST_TEST(report.path.front().position == window.problem.start.position);
        BOOST_TEST(beyondWall(window, report.path.back()) > 0);
        const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
        BOOST_TEST(testing::collisionsAlong(oracle, report.path, window.problem, 500) == 0);
        const PathCheck check = checkPath(window.problem, window.scene, report.path);
        BOOST_TEST(check.audit.isValid());
        BOOST_TEST(check.endsAtGoal());
        BOOST_TEST(check.offGoal == 0);
        for (std::size_t i = 0; i + 1 < report.path.size(); ++i) {
            const PathCheck first =
                checkPath(window.problem, window.scene, {report.path.begin(), report.path.begin() + i + 1});
            BOOST_TEST(!first.endsAtGoal(), "state " << i << " of " << report.path.size());
        }
    }
}

BOOST_AUTO_TEST_CASE(a_planners_path_is_cut_at_its_first_state_outside) {
    const auto window = throughTheWindow();
    PlanReport report;
    const PlanSetup setup = makePlanSetup(window.problem, window.scene, PlanOptions(), report);
    const auto further = std::make_shared<ompl::geometric::PathGeometric>(setup.si);
    for (const double x : {-60.0, 20.0, 50.0, 60.0, 70.0}) {
        PartState state = window.problem.start;
        state.position.x() = x;
        further->append(pathThrough(setup.si, {state}).getState(0));
    }
    const auto path = pathOf(setup, ompl::base::PlannerSolution(further));
    BOOST_REQUIRE(path.getStateCount() == 3u);
    BOOST_TEST(partStates(path).back().position.x() == 50);
}

BOOST_AUTO_TEST_CASE(a_checked_path_that_ends_inside_is_off_the_goal_by_the_overlap) {
    const auto window = throughTheWindow();
    PartState inside = window.problem.start;
    inside.position.x() += 10;
    const PathCheck check = checkPath(window.problem, window.scene, {window.problem.start, inside});
    BOOST_TEST(check.audit.isValid());
    BOOST_TEST(!check.endsAtGoal());
    BOOST_TEST(check.offGoal == 82, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(any_planner_that_finds_a_path_ends_it_outside) {
    auto window = throughTheWindow();
    window.problem.start = {{20, 0, 0}, {1, 0, 0, 0}};  // flat within the window, half way
    int found = 0;
    for (const std::string& name : plannerNames()) {
        PlanOptions options;
        options.planner = name;
        options.seconds = 0.2;
        BOOST_TEST_CONTEXT(name) {
            const PlanReport report = plan(window.problem, window.scene, options);
            if (report.outcome != Outcome::kFound) continue;
            ++found;
            BOOST_TEST(beyondWall(window, report.path.back()) > 0);
            BOOST_TEST(report.audit.isValid());
        }
    }
    BOOST_TEST(found > 15);
}

BOOST_AUTO_TEST_CASE(paths_of_more_clearance_end_outside_too) {
    auto window = throughTheWindow();
    PlanOptions options;
    options.seconds = 100;
    window.problem.planning.objective = "max_min_clearance";
    window.problem.planning.objectiveThreshold = 0.5;  // ends the planning, however busy the machine is
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.foundBy == "RisingFloor");
    BOOST_TEST(report.planningSeconds < 50);
    BOOST_TEST(report.cost >= 0.5);
    BOOST_TEST(beyondWall(window, report.path.back()) > 0);
}

BOOST_AUTO_TEST_CASE(with_derived_bounds_the_part_has_room_outside) {
    auto window = throughTheWindow();
    window.problem.volume.reset();
    window.problem.start = {{20, 0, 0}, {1, 0, 0, 0}};
    PlanOptions options;
    options.iterations = 200000;
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(beyondWall(window, report.path.back()) > 0);
    const auto reach =
        planningRange(window.problem, options, window.scene.part, window.scene.environmentBox());
    BOOST_TEST(reach->positions.max().x() > 2 + window.scene.part.radiusAboutOrigin());
}

BOOST_AUTO_TEST_CASE(a_start_outside_is_the_path_and_is_warned_of) {
    auto window = throughTheWindow();
    window.problem.outside = Outside();
    PlanOptions options;
    options.iterations = 1000;
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.path.size() == 1u);
    BOOST_TEST(report.audit.isValid());
    BOOST_TEST(!report.widening);
    BOOST_REQUIRE(report.warnings.size() == 1u);
    BOOST_TEST(report.warnings[0] == "the start is outside already, so the path ends there");
}

BOOST_AUTO_TEST_CASE(ompls_setup_of_a_problem_takes_a_goal_outside) {
    const auto window = throughTheWindow();
    const auto setup = makeSetup(window.problem, window.scene);
    BOOST_TEST(dynamic_cast<const OutsideGoal*>(setup.getGoal().get()) != nullptr);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
