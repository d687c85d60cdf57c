#include "clearway/planning/explain.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/obstacle_groups.h"
#include "support/door_scene.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(explain_test)

using Outcome = PlanReport::Outcome;

PlanOptions withIterations(std::uint64_t iterations) {
    PlanOptions options;
    options.iterations = iterations;
    return options;
}

Scene loaded(const Problem& problem) {
    return loadScene(problem).scene;
}

/// Plans in vain, then explains.
Explanation explained(const Problem& problem, const std::function<Scene(const Problem&)>& load,
                      const PlanOptions& options) {
    const PlanReport report = plan(problem, load(problem), options);
    BOOST_REQUIRE((report.outcome == Outcome::kNotFound));
    BOOST_REQUIRE(report.whyNoPath.has_value());
    return explain(problem, *report.whyNoPath, {options, /*seconds*/ 300, load});
}

std::function<Scene(const Problem&)> loaderOf(const testing::DoorScene& door) {
    return [door](const Problem& problem) {
        const ObstacleGroups obstacles = groupObstacles({door.box}, problem.margin, problem.rules);
        return makeScene(Model::build(door.part), nullptr, obstacles, problem.rules, poseOf(problem.start),
                         poseOf(problem.goal), [](const Mesh& mesh) { return Model::build(mesh); });
    };
}

BOOST_AUTO_TEST_CASE(a_part_in_a_closed_box_comes_out_without_the_door_alone) {
    const testing::DoorScene door = testing::doorScene();
    const Explanation explanation = explained(door.problem, loaderOf(door), withIterations(1000));
    BOOST_TEST(explanation.areObstaclesTried);
    BOOST_REQUIRE(explanation.withoutThese.size() == 1u);
    BOOST_TEST(explanation.withoutThese[0] == std::vector<std::string>{"door"},
               boost::test_tools::per_element());
    BOOST_TEST(!explanation.isMarginTried);  // there is no margin to scale
    BOOST_TEST(!explanation.marginScale.has_value());
    BOOST_TEST(explanation.path.empty());
    BOOST_TEST(!explanation.isOutOfTime);
}

BOOST_AUTO_TEST_CASE(the_way_outside_is_explained_as_the_way_to_a_pose_is) {
    testing::DoorScene door = testing::doorScene();
    door.problem.outside = Outside{sideNamed("+x")};
    for (const bool isBounded : {true, false}) {
        if (!isBounded) door.problem.volume.reset();
        const Explanation explanation = explained(door.problem, loaderOf(door), withIterations(2000));
        BOOST_REQUIRE(!explanation.withoutThese.empty());
        for (const auto& set : explanation.withoutThese) BOOST_TEST(set.size() == 1u);
        if (isBounded) BOOST_TEST(explanation.withoutThese[0][0] == "door");
    }
}

BOOST_AUTO_TEST_CASE(with_one_obstacle_its_margin_alone_is_scaled) {
    constexpr double kMost = 11, kTooMuch = 12;  // a plate 10 thick in a window 32 high
    for (const char* name : {"wall", ""}) {
        const auto load = [&](const Problem& problem) {
            Mesh wall = loadEnvironment(problem);
            wall.components = {{name, 0, static_cast<std::uint32_t>(wall.triangles.size())}};
            return Scene(Model::build(loadPart(problem)), Model::build(wall), problem.margin);
        };
        Problem problem = readProblem(CLEARWAY_DATA_DIR "/window/window.cfg");
        problem.margin = kTooMuch;
        const Explanation explanation = explained(problem, load, withIterations(3000));
        BOOST_TEST(!explanation.areObstaclesTried);
        BOOST_TEST(explanation.withoutThese.empty());
        BOOST_TEST(explanation.isMarginTried);
        BOOST_REQUIRE(explanation.marginScale.has_value());
        BOOST_TEST(*explanation.marginScale * kTooMuch <= kMost);
        BOOST_TEST(*explanation.marginScale > 0);
    }
}

BOOST_AUTO_TEST_CASE(the_margin_with_which_a_path_is_found_is_the_widest_gates) {
    constexpr double kWidestGate = 12, kTooMuch = 14;
    Problem problem = readProblem(CLEARWAY_DATA_DIR "/gates/gates.cfg");
    problem.margin = kTooMuch;
    PlanOptions options = withIterations(500);
    options.planner = "SlidingRRTConnect";
    const Explanation explanation = explained(problem, loaded, options);
    BOOST_REQUIRE(explanation.marginScale.has_value());
    BOOST_TEST(*explanation.marginScale * kTooMuch <= kWidestGate);
    BOOST_TEST(*explanation.marginScale * kTooMuch >= 0.93 * kWidestGate);
    BOOST_TEST(explanation.refusedScale > *explanation.marginScale);
    BOOST_TEST(explanation.path.empty());
    BOOST_TEST(!explanation.withoutThese.empty());
    for (const auto& set : explanation.withoutThese) {
        // The set does what it is said to do.
        Problem without = problem;
        without.rules.ignored = set;
        without.volume = boundsOf(problem, loaded(problem).environmentBox(), loaded(problem).part.box());
        BOOST_TEST((plan(without, loaded(without), withIterations(20000)).outcome == Outcome::kFound));
    }
}

BOOST_AUTO_TEST_CASE(with_iterations_the_explanation_is_repeatable) {
    Problem problem = readProblem(CLEARWAY_DATA_DIR "/gates/gates.cfg");
    problem.margin = 14;
    const Explanation first = explained(problem, loaded, withIterations(300));
    const Explanation second = explained(problem, loaded, withIterations(300));
    BOOST_TEST(first.trials == second.trials);
    BOOST_TEST(first.trials > 0u);
    BOOST_TEST((first.withoutThese == second.withoutThese));
    BOOST_TEST((first.marginScale == second.marginScale));
    BOOST_TEST(first.refusedScale == second.refusedScale);
}

BOOST_AUTO_TEST_CASE(an_interrupt_ends_the_trials) {
    Problem problem = readProblem(CLEARWAY_DATA_DIR "/gates/gates.cfg");
    problem.margin = 14;
    const PlanReport report = plan(problem, loaded(problem), withIterations(300));
    BOOST_REQUIRE(report.whyNoPath.has_value());
    ExplainOptions options{withIterations(300), 300, loaded};
    options.plan.isStopped = [] { return true; };
    const Explanation explanation = explain(problem, *report.whyNoPath, options);
    BOOST_TEST(explanation.trials == 0u);
    BOOST_TEST(explanation.isOutOfTime);
    BOOST_TEST(explanation.withoutThese.empty());
}

BOOST_AUTO_TEST_CASE(one_obstacle_without_a_margin_is_nothing_to_choose_from) {
    const testing::DoorScene door = testing::doorScene();
    const Scene scene(Model::build(door.part),
                      Model::build(boxMesh({Vector3(4, -4, -4), Vector3(5, 4, 4)}, "door")));
    testing::requireRefusedBy(
        [&] { requireExplainable(scene); },
        {"has 1 obstacle and no margin, expected a margin above 0, or at least two obstacles with names"});
    BOOST_CHECK_NO_THROW(requireExplainable(Scene(Model::build(door.part), Model::build(door.box))));
    BOOST_CHECK_THROW(explain(door.problem, {}, {withIterations(1), /*seconds*/ -1, loaderOf(door)}),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
