// Plans with objectives of clearance.
#include <boost/test/unit_test.hpp>

#include "clearway/planning/objectives.h"
#include "clearway/planning/plan.h"
#include "planning/plan/plan_setup.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/planar_scenes.h"
#include "support/processor_time.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(plan_objective_test)

using testing::gatesScene;
using Outcome = PlanReport::Outcome;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kTunnelSeconds = 150;  // enough under a sanitizer
#else
constexpr double kTunnelSeconds = 4;
#endif

PlanOptions withObjective(const std::string& objective, double seconds) {
    PlanOptions options;
    options.objective = objective;
    options.seconds = seconds;
    return options;
}

PlanReport found(const Problem& problem, const Scene& scene, PlanOptions options) {
    const PlanReport report =
        options.iterations
            ? plan(problem, scene, options)
            : testing::withProcessorTime(options.seconds.value_or(kDefaultSeconds), [&](double seconds) {
                  options.seconds = seconds;
                  return plan(problem, scene, options);
              });
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.audit.isValid());
    return report;
}

BOOST_AUTO_TEST_CASE(the_least_clearance_is_the_cost_and_shortening_keeps_it) {
    const auto gates = gatesScene();
    const PlanReport report = found(gates.problem, gates.scene, withObjective("max_min_clearance", 1.5));
    BOOST_TEST(report.planners == std::vector<std::string>{"RisingFloor"}, boost::test_tools::per_element());
    BOOST_TEST(report.objective == "max_min_clearance");
    BOOST_TEST(report.cost > 4);  // the first path of the same planners has less: see anytime_clearance
    BOOST_TEST(report.cost <= report.audit.upperClearance);
    BOOST_TEST(report.cost >= 0.9 * report.audit.lowerClearance);
    BOOST_TEST(report.cost <= testing::kWideGates);
    BOOST_TEST(report.path.size() <= report.statesBefore);
}

BOOST_AUTO_TEST_CASE(the_least_clearance_claimed_is_there_by_the_oracle) {
    const Problem problem = readProblem(CLEARWAY_DATA_DIR "/tunnel-console-small/tunnel-console.cfg");
    const Mesh part = loadPart(problem), environment = loadEnvironment(problem);
    const Scene scene{Model::build(part), Model::build(environment), problem.margin};
    const PlanReport report = found(problem, scene, withObjective("max_min_clearance", kTunnelSeconds));
    const testing::MeshOracle oracle(part, environment);
    const double least = testing::leastDistance(oracle, report.path, problem, 60) - problem.margin;
    BOOST_TEST(report.audit.lowerClearance > 0);
    BOOST_TEST(report.audit.lowerClearance <= least);
    BOOST_TEST(report.cost <= least);
}

BOOST_AUTO_TEST_CASE(the_problem_names_the_objective_unless_the_options_do) {
    auto gates = gatesScene();
    gates.problem.planning.objective = "max_min_clearance";
    gates.problem.planning.objectiveThreshold = 1;
    PlanOptions options;
    options.seconds = 20;
    PlanReport report;
    const double seconds =
        testing::processorSecondsOf([&] { report = found(gates.problem, gates.scene, options); });
    BOOST_TEST(report.objective == "max_min_clearance");
    BOOST_TEST(report.cost > 1);
    BOOST_TEST(seconds < 10);  // ends when the wanted clearance is reached

    gates.problem.planning.objectiveThreshold.reset();
    options = withObjective("Length_With_Clearance", 1);
    options.wantedClearance = 3;
    const PlanReport wanted = found(gates.problem, gates.scene, options);
    BOOST_TEST(wanted.objective == "length_with_clearance");
    BOOST_TEST(wanted.cost >= wanted.length);
    BOOST_TEST(wanted.warnings.empty());

    gates.problem.planning.objective = "beauty";
    gates.problem.meshes.asOmplApp = true;  // as in OMPL.app's files, which know no [clearway]
    gates.problem.meshes.isReadingStated = false;
    const PlanReport unknown = found(gates.problem, gates.scene, {});
    BOOST_TEST(unknown.objective == "");
    BOOST_REQUIRE(unknown.warnings.size() == 1u);
    BOOST_TEST(unknown.warnings[0].find("unknown objective 'beauty', expected one of length, ") == 0u);
    BOOST_TEST(unknown.warnings[0].find("; paths are judged by length") != std::string::npos);

    gates.problem.planning.objective = "lenght";
    gates.problem.meshes.asOmplApp = false;  // as in a file with a section [clearway]
    testing::requireRefusedBy([&] { plan(gates.problem, gates.scene, {}); },
                              {"unknown objective 'lenght' (did you mean 'length'?)"});
}

BOOST_AUTO_TEST_CASE(planning_ends_when_no_path_can_have_more_clearance_for_its_ends_have_not) {
    auto gates = gatesScene();
    gates.problem.start.position = {-43, 0, 0};  // 43 - 32 - 10 = 1 in front of the wall, or beside the gate
    gates.problem.start.position.y() = 18;
    PlanReport report;
    const double seconds = testing::processorSecondsOf(
        [&] { report = found(gates.problem, gates.scene, withObjective("max_min_clearance", 20)); });
    BOOST_TEST(seconds < 10);
    BOOST_TEST(report.cost <= 1);
    BOOST_TEST(report.cost >= 0.9);
}

BOOST_AUTO_TEST_CASE(with_iterations_the_path_for_an_objective_is_repeatable) {
    const auto gates = gatesScene();
    PlanOptions options;
    options.iterations = 250;
    options.parameters = {{"range", "60"}};
    options.objective = "max_min_clearance";
    const PlanReport first = found(gates.problem, gates.scene, options);
    BOOST_TEST(first.planners.at(0) == "RRTstar");
    BOOST_TEST(first.isRepeatable);
    const PlanReport second = found(gates.problem, gates.scene, options);
    BOOST_TEST(first.cost == second.cost);
    BOOST_TEST(first.length == second.length);
    BOOST_TEST(first.path.size() == second.path.size());
}

BOOST_AUTO_TEST_CASE(objectives_are_known_by_name_in_any_case) {
    BOOST_TEST(objectiveName("MAX_MIN_CLEARANCE") == "max_min_clearance");
    BOOST_TEST(objectiveName("min_clearance") == "max_min_clearance");
    BOOST_TEST(testing::refusalBy([] { objectiveName("shortest"); }) ==
               "unknown objective 'shortest', expected one of length, max_min_clearance, clearance_integral, "
               "length_with_clearance, mechanical_work");
    const auto gates = gatesScene();
    for (const std::string& name : objectiveNames()) {
        PlanOptions options = withObjective(name, 0.5);
        options.planner = "AnytimePathShortening";
        const PlanReport report = found(gates.problem, gates.scene, options);
        BOOST_TEST(report.objective == name);
        BOOST_TEST(report.cost > 0, name);
    }
}

/// A cube of side 1 between walls that are 5 apart: clearance 2, more than the cube's diagonal.
BOOST_AUTO_TEST_CASE(clearances_above_the_diagonal_of_the_part_count_too) {
    const Model cube = Model::build(boxMesh({Vector3(-0.5, -0.5, -0.5), Vector3(0.5, 0.5, 0.5)}));
    Scene scene(cube, Model::build(boxMesh({Vector3(-20, -9, 2.5), Vector3(20, 9, 3)})));
    scene.obstacles.push_back({Model::build(boxMesh({Vector3(-20, -9, -3), Vector3(20, 9, -2.5)}))});
    scene.obstacles.push_back({Model::build(boxMesh({Vector3(-1, -9, -2.5), Vector3(1, -1, 2.5)}))});
    Problem problem;
    problem.start.position = {-8, 0, 0};
    problem.goal.position = {8, 0, 0};
    problem.volume = Box(Vector3(-12, -8, -2), Vector3(12, 8, 2));
    for (const std::uint32_t seed : {1, 2, 3}) {
        PlanOptions options = withObjective("max_min_clearance", 3);
        options.seed = seed;
        const PlanReport report = found(problem, scene, options);
        BOOST_TEST(report.audit.upperClearance <= 2 * (1 + 1e-9));
        BOOST_TEST(report.audit.lowerClearance > 1.9, "seed " << seed);
    }
}

BOOST_AUTO_TEST_CASE(an_objective_is_improved_until_the_time_is_up_by_the_default_planner_too) {
    const auto gates = gatesScene();
    for (const std::string& name : objectiveNames()) {
        const PlanReport report = plan(gates.problem, gates.scene, withObjective(name, 1.2));
        BOOST_TEST(report.planners.at(0) != "PlannerTeam");
        BOOST_TEST(report.planningSeconds > 0.85, name);
    }
}

std::string refusalOf(const Problem& problem, const Scene& scene, const PlanOptions& options) {
    return testing::refusalBy([&] { plan(problem, scene, options); });
}

BOOST_AUTO_TEST_CASE(a_threshold_that_no_path_meets_is_refused_with_the_bound) {
    auto gates = gatesScene();
    gates.problem.file = "gates.cfg";
    gates.problem.planning.objective = "max_min_clearance";
    gates.problem.planning.objectiveThreshold = 1000;
    const std::string least = refusalOf(gates.problem, gates.scene, withObjective("", 1));
    BOOST_TEST(
        least.find("gates.cfg: objective.threshold is 1000, which no path meets: max_min_clearance is at "
                   "best 38.") == 0u,
        least);
    gates.problem.planning.objective = "length";
    gates.problem.planning.objectiveThreshold = 100;
    const std::string length = refusalOf(gates.problem, gates.scene, withObjective("", 1));
    BOOST_TEST(length.find("length is at best 160 between") != std::string::npos, length);
    BOOST_TEST(found(gates.problem, gates.scene, withObjective("max_min_clearance", 0.3)).cost > 0);
    gates.problem.planning.objectiveThreshold = 0;  // OMPL's word for none
    BOOST_TEST(found(gates.problem, gates.scene, withObjective("", 0.3)).cost >= 160);
}

BOOST_AUTO_TEST_CASE(the_threshold_0_of_a_least_clearance_stands_for_none) {
    auto gates = gatesScene();
    gates.problem.planning.objective = "max_min_clearance";
    const auto thresholdOf = [&] {
        PlanReport report;
        const PlanSetup setup = makePlanSetup(gates.problem, gates.scene, {}, report, [] { return true; });
        return setup.definition->getOptimizationObjective()->getCostThreshold().value();
    };
    const double own = thresholdOf();
    BOOST_TEST(own > testing::kWideGates);
    gates.problem.planning.objectiveThreshold = 0;
    BOOST_TEST(thresholdOf() == own);
    gates.problem.planning.objectiveThreshold = 5;
    BOOST_TEST(thresholdOf() == 5);
}

BOOST_AUTO_TEST_CASE(planning_ends_with_the_first_path_that_meets_the_threshold) {
    auto gates = gatesScene();
    gates.problem.planning.objective = "max_min_clearance";
    gates.problem.planning.objectiveThreshold =
        0.9 * testing::kWideGates;  // no path keeps 1.15 times as much
    const PlanReport report = found(gates.problem, gates.scene, withObjective("", 40));
    BOOST_TEST(report.cost >= 0.99 * 0.9 * testing::kWideGates);
    BOOST_TEST(report.planningSeconds < 20);
}

BOOST_AUTO_TEST_CASE(a_planner_for_clearance_has_all_of_the_time_for_its_first_path) {
    auto gates = gatesScene();
    gates.scene.obstacles.front().margin = testing::kWideGates + 1;
    const PlanReport report = plan(gates.problem, gates.scene, withObjective("max_min_clearance", 1));
    BOOST_TEST((report.outcome == Outcome::kNotFound));
    BOOST_TEST(report.planningSeconds > 0.99);
}

BOOST_AUTO_TEST_CASE(a_wanted_clearance_without_its_objective_is_refused) {
    auto gates = gatesScene();
    PlanOptions options = withObjective("max_min_clearance", 1);
    options.wantedClearance = 1;
    BOOST_TEST(refusalOf(gates.problem, gates.scene, options) ==
               "a wanted clearance is given with the objective max_min_clearance, expected the objective "
               "length_with_clearance");
    options.objective.clear();
    BOOST_TEST(
        refusalOf(gates.problem, gates.scene, options) ==
        "a wanted clearance is given without an objective, expected the objective length_with_clearance");
    gates.problem.planning.objective = "length_with_clearance";
    options.seconds = 0.3;
    BOOST_TEST(found(gates.problem, gates.scene, options).objective == "length_with_clearance");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
