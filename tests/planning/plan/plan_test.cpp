#include "clearway/planning/plan.h"

#include <ompl/base/ScopedState.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <thread>

#include "clearway/planning/planners.h"
#include "planning/space/ompl_states.h"
#include "support/full_run.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/processor_time.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(plan_test)

using testing::windowScene;
using Outcome = PlanReport::Outcome;

bool same(const std::vector<PartState>& a, const std::vector<PartState>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PartState& x, const PartState& y) {
        return x.position == y.position && x.rotation.coeffs() == y.rotation.coeffs();
    });
}

PlanOptions withIterations(std::uint64_t iterations, std::uint32_t seed = 1) {
    PlanOptions options;
    options.iterations = iterations;
    options.seed = seed;
    return options;
}

BOOST_AUTO_TEST_CASE(the_path_keeps_the_margin_at_interpolated_states_by_the_oracle) {
    const int states = testing::isFullRun() ? 1000 : 200;
    for (const double margin : {0.0, 2.0}) {
        for (std::uint32_t seed = 1; seed <= (testing::isFullRun() ? 3 : 1); ++seed) {
            auto window = windowScene();
            window.scene.obstacles[0].margin = margin;
            const PlanReport report = plan(window.problem, window.scene, withIterations(200000, seed));
            BOOST_TEST_CONTEXT("margin " << margin << ", seed " << seed) {
                BOOST_REQUIRE((report.outcome == Outcome::kFound));
                BOOST_TEST(report.path.front().position == window.problem.start.position);
                BOOST_TEST(report.path.back().position == window.problem.goal.position);
                const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
                const double least = testing::leastDistance(oracle, report.path, window.problem, states);
                BOOST_TEST(least > margin);
                const PathAudit& audit = report.audit;
                BOOST_TEST(audit.isValid());
                BOOST_TEST(audit.lowerClearance > 0);
                BOOST_TEST(audit.lowerClearance <= least - margin);
                BOOST_TEST(audit.upperClearance >= audit.lowerClearance);
                BOOST_TEST(audit.upperClearance <= audit.lowerClearance + 0.1 * audit.upperClearance + 1e-3);
                BOOST_TEST(audit.queries > 10u);
                BOOST_TEST(audit.segments.at(audit.closest).partMesh == "plate");
                BOOST_TEST(audit.segments.size() + 1 == report.path.size());
                BOOST_TEST(report.length >= 120);
                BOOST_TEST(report.warnings.empty());
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_sheet_without_thickness_is_not_planned_through) {
    auto window = windowScene();
    Mesh sheet;
    sheet.vertices = {{0, -200, -200}, {0, 200, -200}, {0, 0, 400}};
    sheet.triangles = {{0, 1, 2}};
    window.scene.obstacles[0].model = Model::build(sheet);
    window.problem.fineness = 100;  // this fineness only sets the length of edges, 20 times as long
    BOOST_TEST((plan(window.problem, window.scene, withIterations(2000)).outcome == Outcome::kNotFound));
}

BOOST_AUTO_TEST_CASE(repeatable_planners_give_the_same_path_bit_by_bit_and_it_is_free) {
    const auto window = windowScene();
    const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
    int found = 0;
    for (const std::string& name : plannerNames()) {
        if (!isRepeatable(name)) continue;
        PlanOptions options = withIterations(testing::isFullRun() ? 1000 : 400, 8);
        options.planner = name;
        const PlanReport first = plan(window.problem, window.scene, options);
        const std::vector<char> elsewhere(1 << 20);  // so that the second run's memory lies elsewhere
        const PlanReport second = plan(window.problem, window.scene, options);
        BOOST_TEST_CONTEXT(name << ", " << elsewhere.size()) {
            BOOST_TEST(first.planners.at(0) == name);
            BOOST_TEST(first.isRepeatable);
            BOOST_TEST((first.outcome == second.outcome));
            BOOST_TEST(first.checks == second.checks);
            BOOST_TEST(same(first.path, second.path));
            if (first.outcome != Outcome::kFound) continue;
            BOOST_TEST(testing::collisionsAlong(oracle, first.path, window.problem, 200) == 0);
            ++found;
        }
    }
    BOOST_TEST(found > 5);
}

BOOST_AUTO_TEST_CASE(planners_with_threads_end_in_time_and_what_they_find_is_free) {
    const auto window = windowScene();
    const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
    for (const std::string& name : plannerNames()) {
        if (isRepeatable(name)) continue;
        PlanOptions options;
        options.planner = name;
        options.seconds = 0.25;
        PlanReport report;
        const double seconds =
            testing::secondsOnAllProcessors([&] { report = plan(window.problem, window.scene, options); });
        BOOST_TEST_CONTEXT(name) {
            BOOST_TEST(!report.isRepeatable);
            BOOST_TEST(seconds < 10);
            if (report.outcome != Outcome::kFound) continue;
            BOOST_TEST(testing::collisionsAlong(oracle, report.path, window.problem, 200) == 0);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_path_gets_room_and_shortening_keeps_it_unless_it_has_to_be_quick) {
    const auto window = windowScene();
    for (const std::uint32_t seed : {1u, 2u}) {
        PlanOptions options = withIterations(200000, seed);
        const PlanReport wide = plan(window.problem, window.scene, options);
        options.quick = true;
        const PlanReport quick = plan(window.problem, window.scene, options);
        BOOST_TEST_CONTEXT("seed " << seed) {
            BOOST_REQUIRE((wide.outcome == Outcome::kFound));
            BOOST_REQUIRE((quick.outcome == Outcome::kFound));
            BOOST_TEST(!quick.widening.has_value());
            BOOST_TEST_REQUIRE(wide.widening.has_value());
            BOOST_TEST(wide.widening->after > wide.widening->before);
            BOOST_TEST(wide.widening->after > quick.audit.upperClearance);
            BOOST_TEST(wide.audit.upperClearance >= wide.widening->after);
            BOOST_TEST(wide.audit.lowerClearance >= wide.widening->after);
            const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
            BOOST_TEST(testing::leastDistance(oracle, wide.path, window.problem, 300) >=
                       wide.audit.lowerClearance);
        }
    }
}

BOOST_AUTO_TEST_CASE(in_time_the_room_takes_its_share_and_no_more) {
    const auto window = windowScene();
    PlanOptions options;
    options.seconds = 20;
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST_REQUIRE(report.widening.has_value());
    BOOST_TEST(report.widening->after > report.widening->before);
    BOOST_TEST(report.widening->seconds < report.finishingSeconds);
    BOOST_TEST(report.widening->seconds < 10);  // 5, and as much for a busy machine
}

BOOST_AUTO_TEST_CASE(no_path_is_no_path) {
    auto window = windowScene();
    window.scene.obstacles[0].margin = 12;  // the window leaves 12 at the plate's sides, 11 above and below
    PlanOptions options;
    options.seconds = 0.5;
    PlanReport report;
    const double seconds =
        testing::processorSecondsOf([&] { report = plan(window.problem, window.scene, options); });
    BOOST_TEST((report.outcome == Outcome::kNotFound));
    BOOST_TEST(report.path.empty());
    BOOST_TEST(seconds < 3);
}

BOOST_AUTO_TEST_CASE(a_stop_ends_the_planning_without_a_path) {
    auto window = windowScene();
    window.scene.obstacles[0].margin = 12;
    int asked = 0;
    PlanOptions options;
    options.isStopped = [&] { return ++asked > 100; };
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_TEST((report.outcome == Outcome::kStopped));
    BOOST_TEST(report.path.empty());
}

BOOST_AUTO_TEST_CASE(time_ends_a_motion_that_slides_along_a_face_too) {
    const Pose below{Matrix3::Identity(), {0, -10 - 1e-4, 0}};
    const Mesh plate = testing::transformed(testing::box({200, 5, 20}), below);
    const Scene scene(Model::build(testing::box({10, 5, 5})), Model::build(plate));
    Problem problem;
    problem.space = Space::kSe2;
    problem.start.position = {-80, 0, 0};
    problem.goal.position = {80, 0, 0};
    problem.volume = Box(Vector3(-100, -1, 0), Vector3(100, 50, 0));
    PlanOptions options;
    options.planner = "PRM";  // PRM tries the motion from start to goal at once: two million queries
    options.seconds = 0.3;
    BOOST_TEST(testing::processorSecondsOf([&] { plan(problem, scene, options); }) < 4);
}

BOOST_AUTO_TEST_CASE(a_start_that_all_but_touches_is_planned_from) {
    auto window = windowScene();
    window.problem.start.position.x() = -32 - 1e-5;
    const PlanReport report = plan(window.problem, window.scene, withIterations(200000));
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.warnings.empty());
    BOOST_TEST(report.audit.lowerClearance > 0);
    BOOST_TEST(report.audit.lowerClearance <= 1.01e-5);
    const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
    BOOST_TEST(testing::collisionsAlong(oracle, report.path, window.problem, 1000) == 0);
}

BOOST_AUTO_TEST_CASE(a_start_too_close_to_be_certified_is_warned_of) {
    auto window = windowScene();
    window.problem.start.position.x() = -32 - 1e-9;
    const PlanReport report = plan(window.problem, window.scene, withIterations(100));
    BOOST_REQUIRE(!report.warnings.empty());
    BOOST_TEST(testing::holds(report.warnings[0], "may be too close to be certified"));
}

BOOST_AUTO_TEST_CASE(edges_are_20_times_the_fineness_long_or_a_quarter_of_the_parts_diagonal) {
    auto window = windowScene();
    window.problem.fineness.reset();
    const PlanReport report = plan(window.problem, window.scene, withIterations(10));
    BOOST_TEST(report.warnings.empty());
    BOOST_TEST(report.range == Vector3(60, 40, 10).norm() / 4, boost::test_tools::tolerance(1e-12));
    window.problem.fineness = 0.75;
    BOOST_TEST(plan(window.problem, window.scene, withIterations(10)).range == 15);
}

BOOST_AUTO_TEST_CASE(wrong_planners_and_parameters_of_a_file_are_refused_and_those_of_omplapp_warned_of) {
    auto window = windowScene();
    window.problem.file = "window.cfg";
    PlanOptions options = withIterations(10);
    const auto planIt = [&] { plan(window.problem, window.scene, options); };
    options.planner = "RRTConnect";
    window.problem.planning.planners = {
        {"rrtconnect", {{"name", "mine"}, {"max_failures", "3"}, {"range", "7"}}}};
    BOOST_TEST(testing::holds(testing::refusalBy(planIt),
                              "RRTConnect has no parameter 'max_failures', expected one of"));
    window.problem.meshes.isReadingStated = false;  // as OMPL.app's files, which know no [clearway]
    const PlanReport report = plan(window.problem, window.scene, options);
    BOOST_REQUIRE(report.warnings.size() == 1u);
    BOOST_TEST(
        testing::holds(report.warnings[0], "window.cfg: planner RRTConnect has no parameter 'max_failures'"));
    window.problem.meshes.isReadingStated = true;

    window.problem.planning.planners = {{"nonesuch", {}}};
    BOOST_TEST(testing::holds(testing::refusalBy(planIt), "window.cfg: unknown planner 'nonesuch'"));
}

BOOST_AUTO_TEST_CASE(the_problems_only_planner_is_used_unless_another_is_asked_for) {
    auto window = windowScene();
    window.problem.planning.planners = {{"kpiece", {}}};
    using Names = std::vector<std::string>;
    BOOST_TEST((plan(window.problem, window.scene, withIterations(5)).planners == Names{"KPIECE1"}));
    window.problem.planning.planners.push_back({"est", {}});
    BOOST_TEST((plan(window.problem, window.scene, withIterations(5)).planners == Names{"PlannerTeam"}));
    PlanOptions options = withIterations(5);
    options.planner = "stride";
    BOOST_TEST((plan(window.problem, window.scene, options).planners == Names{"STRIDE"}));
}

BOOST_AUTO_TEST_CASE(planners_run_side_by_side_until_one_has_a_path) {
    const auto window = windowScene();
    const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
    PlanOptions options;
    options.threads = 3;
    for (int seed = 1; seed <= testing::inForm(3, 1); ++seed) {
        options.seed = static_cast<std::uint32_t>(seed);
        PlanReport report;
        const double seconds =
            testing::processorSecondsOf([&] { report = plan(window.problem, window.scene, options); });
        BOOST_TEST((report.planners == std::vector<std::string>{"PlannerTeam"}));
        BOOST_REQUIRE((report.outcome == Outcome::kFound));
        BOOST_TEST(testing::holds(report.foundBy, "RRTConnect"));
        BOOST_TEST(!report.isRepeatable);
        BOOST_TEST(seconds < 20);
        BOOST_TEST(testing::collisionsAlong(oracle, report.path, window.problem, 1000) == 0);
    }
    options.planner = "RRT";
    options.seconds = 0.1;
    BOOST_TEST(plan(window.problem, window.scene, options).planners.size() == 3u);
    options.planner = "pRRT";  // has threads of its own
    BOOST_TEST(plan(window.problem, window.scene, options).planners.size() == 1u);
}

BOOST_AUTO_TEST_CASE(with_iterations_one_seed_gives_one_path_whatever_else_the_machine_does) {
    const auto window = windowScene();
    std::vector<PlanReport> reports;
    for (const int others : {0, 4}) {
        std::atomic<bool> isOver{false};
        std::vector<std::thread> load;
        for (int i = 0; i < others; ++i)
            load.emplace_back([&] {
                while (!isOver) std::this_thread::yield();
            });
        reports.push_back(plan(window.problem, window.scene, withIterations(20000)));
        isOver = true;
        for (std::thread& thread : load) thread.join();
    }
    BOOST_TEST(reports[0].isRepeatable);
    BOOST_REQUIRE((reports[0].outcome == Outcome::kFound));
    BOOST_TEST(reports[0].foundBy == reports[1].foundBy);
    BOOST_TEST(same(reports[0].path, reports[1].path));
}

BOOST_AUTO_TEST_CASE(a_team_in_threads_is_not_called_repeatable) {
    const auto window = windowScene();
    PlanOptions options = withIterations(100);
    options.parameters = {{"threads", "2"}};
    BOOST_TEST(!plan(window.problem, window.scene, options).isRepeatable);
    options.parameters = {{"threads", "1"}};
    BOOST_TEST(plan(window.problem, window.scene, options).isRepeatable);
}

BOOST_AUTO_TEST_CASE(a_planar_problem_is_planned_in_se2) {
    auto window = windowScene();
    window.problem.space = Space::kSe2;
    window.scene.obstacles[0].margin = 3;
    window.problem.start.rotation =
        Eigen::AngleAxisd(M_PI / 2, Vector3::UnitZ());  // must turn: 60 across 64 leaves 2
    window.problem.goal.rotation = window.problem.start.rotation;
    window.problem.volume = Box(Vector3(-80, -80, 0), Vector3(80, 80, 0));
    const PlanReport report = plan(window.problem, window.scene, withIterations(200000));
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.rotation > 1);
    const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
    BOOST_TEST(testing::leastDistance(oracle, report.path, window.problem, 1000) > 3);
    for (const PartState& state : report.path) BOOST_TEST(state.position.z() == 0);
}

BOOST_AUTO_TEST_CASE(options_that_contradict_are_refused) {
    const auto window = windowScene();
    PlanOptions twice = withIterations(10), quick = twice;
    twice.seconds = 1;
    quick.quick = true;
    quick.objective = "max_min_clearance";
    for (const auto& [options, words] :
         {std::pair(twice, "expected one of them"),
          {quick, "both quick and an objective are given, expected one of them"},
          {withIterations(10, 0), "seed is 0"}})
        testing::requireRefusedBy([&, &options = options] { plan(window.problem, window.scene, options); },
                                  {words});
}

/// The thread of plan() is held up after a path is found, and before one is.
BOOST_AUTO_TEST_CASE(what_was_found_is_told_from_another_thread_when_planning_overruns) {
    const auto window = windowScene();
    for (const PlanPhase held : {PlanPhase::kWidening, PlanPhase::kPlanning}) {
        PlanOptions options;
        options.planner = "RRTConnect";
        options.seconds = 100;
        std::atomic<bool> isStopped{false}, isTold{false};
        options.isStopped = [&] { return isStopped.load(); };
        options.onPhase = [&](PlanPhase phase) {
            if (phase != held) return;
            isStopped = true;
            for (int i = 0; i < 6000 && !isTold; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
        };
        const std::thread::id caller = std::this_thread::get_id();
        PlanReport soFar;
        std::thread::id teller = caller;
        options.onOverrun = [&](const PlanReport& report) {
            soFar = report;
            teller = std::this_thread::get_id();
            isTold = true;
        };
        const PlanReport whole = plan(window.problem, window.scene, options);
        BOOST_REQUIRE(isTold);
        BOOST_TEST((teller != caller));
        BOOST_TEST(soFar.isStopped);
        const bool isFound = held == PlanPhase::kWidening;
        BOOST_TEST((soFar.outcome == (isFound ? Outcome::kFound : Outcome::kStopped)));
        BOOST_TEST((whole.outcome == soFar.outcome));
        if (!isFound) continue;
        BOOST_TEST(soFar.audit.isValid());
        BOOST_TEST(soFar.path.front().position == window.problem.start.position);
        BOOST_TEST(soFar.path.back().position == window.problem.goal.position);
        BOOST_TEST(soFar.foundBy == "RRTConnect");
    }
}

BOOST_AUTO_TEST_CASE(planning_that_ends_in_time_tells_nothing_before) {
    const auto window = windowScene();
    PlanOptions options = withIterations(100000);
    bool isTold = false;
    options.onOverrun = [&](const PlanReport&) { isTold = true; };
    BOOST_TEST((plan(window.problem, window.scene, options).outcome == Outcome::kFound));
    BOOST_TEST(!isTold);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
