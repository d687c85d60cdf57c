#include <chrono>
#include <filesystem>

#include "program/cli/window_folder.h"
#include "support/invalid_words.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(plan_test)

constexpr const char* kPlan = "plan window.cfg --path out.path --iterations 200000";

std::string added(const std::string& more) {
    return std::string(kPlan) + " " + more;
}

BOOST_AUTO_TEST_CASE(a_path_is_found_written_and_free_by_the_oracle) {
    const WindowProblemFolder folder;
    const Outcome outcome = runIn(folder, added("--json facts.json"));
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");  // no progress line either, because this is no terminal
    BOOST_TEST(row(outcome, "repeatable") == "yes");
    BOOST_TEST(holds(row(outcome, "audit"), "valid", "certified"));
    BOOST_TEST(std::stod(row(outcome, "floor")) == 1e-3 * Vector3(60, 40, 10).norm(),
               boost::test_tools::tolerance(1e-3));
    const auto path = readPath(folder.file("out.path"), Space::kSe3);
    const auto facts = jsonIn(folder, "facts.json");
    BOOST_TEST(facts["planners"][0] == "PlannerTeam");
    BOOST_TEST(facts["seed"] == 1);
    BOOST_TEST(facts["audit"]["verdict"] == "valid");
    BOOST_TEST(facts["audit"]["clearance"]["lower"].get<double>() > 0);
    BOOST_TEST(facts["audit"]["closest"]["pair"]["part"]["mesh"] == "plate");
    BOOST_TEST(facts["path"]["length"].get<double>() >= 120);
    BOOST_TEST(facts["path"]["states"] == path.size());
    BOOST_TEST(path.front().position == folder.window.problem.start.position);
    BOOST_TEST(path.back().position == folder.window.problem.goal.position);
    const Problem problem = readProblem(folder.file("window.cfg"));
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
    BOOST_TEST(leastDistance(oracle, path, problem, 1000) > 0);
}

BOOST_AUTO_TEST_CASE(the_same_seed_and_iterations_write_the_same_bytes) {
    const WindowProblemFolder folder;
    const auto pathOf = [&](const std::string& seed) {
        BOOST_TEST(runIn(folder, added("--seed " + seed)).code == 0);
        return readText(folder.file("out.path"));
    };
    const std::string first = pathOf("7");
    BOOST_TEST(pathOf("7") == first);
    BOOST_TEST(pathOf("8") != first);
}

BOOST_AUTO_TEST_CASE(options_reach_the_planner) {
    const WindowProblemFolder folder;
    const auto facts = factsOf(
        folder,
        "plan window.cfg --path out.path --time 100 --planner rrt --planner-param range=15 --planner-param "
        "goal_bias=0.1 --margin 1 --objective length --general-split mean --leaf-split chain "
        "--leaf-size 3 --target scalar");
    BOOST_TEST(facts["found_by"] == "RRT");
    BOOST_TEST(facts["obstacles"][0]["margin"] == 1.0);
    BOOST_TEST(facts["audit"]["verdict"] == "valid");
    const Outcome twins =
        runIn(folder, "plan window.cfg --path out.path --time 100 --quick --planner RRTConnect --threads 2");
    BOOST_TEST(row(twins, "planner") == "2 RRTConnect, seed 1");
    const Outcome floored = runIn(folder, added("--floor 0.5 --ompl-weights"));
    BOOST_TEST(row(floored, "floor") == "0.5");
    BOOST_TEST(floored.code == 0, floored.err);
}

BOOST_AUTO_TEST_CASE(an_objective_is_planned_for_and_its_cost_told) {
    const WindowProblemFolder folder;
    Problem problem = folder.window.problem;
    problem.planning.objective = "max_min_clearance";
    problem.planning.objectiveThreshold = 0.01;  // ends the planning, however busy the machine is
    folder.rewrite(problem);
    const Outcome outcome = runIn(
        folder, "plan window.cfg --path out.path --time 100 --objective Min_Clearance --json facts.json");
    BOOST_TEST(outcome.code == 0, outcome.err);
    const std::string objective = row(outcome, "objective");
    BOOST_TEST_REQUIRE(objective.rfind("max_min_clearance, cost ", 0) == 0, objective);
    BOOST_TEST(std::stod(objective.substr(24)) > 0);
    BOOST_TEST(std::stod(objective.substr(24)) <=
               jsonIn(folder, "facts.json")["audit"]["clearance"]["upper"].get<double>() * (1 + 1e-5));
}

BOOST_AUTO_TEST_CASE(what_no_position_within_the_bounds_can_come_near_is_left_out_and_counted) {
    const WindowProblemFolder folder;
    // Sliding planners and bands go by distances whose last digits differ from tree to tree.
    const std::string verdictsAlone = "--planner RRTConnect --quick";
    BOOST_TEST(runIn(folder, added(verdictsAlone)).code == 0);
    const std::string path = readText(folder.file("out.path"));
    const Mesh far = translated(folder.window.wallMesh, {1000, 0, 0});
    saveMesh(joined(folder.window.wallMesh, far), folder.file("wall.obj"));
    for (int run = 0; run < 2; ++run) {  // the second one reads the cache
        const Outcome outcome = runIn(folder, added(verdictsAlone + " --cache trees"));
        BOOST_TEST(outcome.code == 0, outcome.err);
        BOOST_TEST(holds(row(outcome, "environment"), "432 out of range"), outcome.out);
        BOOST_TEST(readText(folder.file("out.path")) == path);
    }
    BOOST_TEST(factsOf(folder, "info window.cfg")["environment"]["tree"]["out_of_range"] == 432);

    saveMesh(far, folder.file("wall.obj"));
    const std::string least = row(runIn(folder, kPlan), "least clearance");
    BOOST_TEST(holds(least, " or more"), least);
}

BOOST_AUTO_TEST_CASE(no_path_is_exit_code_1_and_no_file) {
    const WindowProblemFolder folder;
    const auto before = folder.names();
    const std::string narrow = "plan window.cfg --path out.path --export out.glb --margin 12 --time ";
    const Outcome outcome = runIn(folder, narrow + "0.3");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "path") == "none found");
    BOOST_TEST(interruptIn(folder, narrow + "300").code == 1);
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused_in_one_line) {
    const WindowProblemFolder folder;
    requireRefused(folder, "plan window.cfg", {"--path is missing"});
    requireRefused(folder, "plan nowhere.cfg --path out.path", {"nowhere.cfg"});
    requireRefused(folder, "plan window.cfg --path nowhere/out.path", {"nowhere/out.path"});
    requireRefused(folder, added("--planner RTRConnect"), {"'RTRConnect'", "RRTConnect", "PRMstar"});
    requireRefused(folder, added("--planner-param rnage=1"), {"'rnage'", "range"});
    requireRefused(folder, added("--planner-param range=far"), {"'far'", "a number"});
    requireRefused(folder, added("--planner-param range"), {"--planner-param is 'range'", "NAME=VALUE"});
    requireRefused(folder, added("--time 3"), {"--time and --iterations"});
    requireRefused(folder, "plan window.cfg --path out.path --iterations 1.5", {"--iterations is '1.5'"});
    requireRefused(folder, added("--wanted-clearance 0"), {"--wanted-clearance is '0'"});
    requireRefused(folder, added("--margin -1"), {"--margin is '-1'"});
    requireRefused(folder, added("--floor -1"), {"--floor is '-1'"});
    requireRefused(folder, added("--quick --objective length"), {"--quick and --objective", "expected one"});
    requireRefused(folder, added("--objective clearance"), {"'clearance'", "length, max_min_clearance, "});
}

BOOST_AUTO_TEST_CASE(a_report_and_an_animation_of_the_path_are_written_beside_it) {
    const WindowProblemFolder folder;
    const Outcome outcome = runIn(folder, added("--quick --report out.html --export out.glb"));
    BOOST_TEST(outcome.code == 0, outcome.err);
    const std::string page = readText(folder.file("out.html"));
    BOOST_TEST(holds(page, "</html>", "PlannerTeam, seed 1", "valid along the whole path", "plate"));
    BOOST_TEST(readText(folder.file("out.glb")).substr(0, 4) == "glTF");
    requireRefused(folder, added("--export out.obj"), {"out.obj", "ends in .glb"});
    requireRefused(folder, added("--export out.glb --swept out.glb"),
                   {"--swept is 'out.glb'", "another file"});
    requireRefused(folder, added("--report nowhere/out.html"), {"nowhere/out.html"});
    requireRefused(folder, added("--report out.path"), {"--report is 'out.path'", "another file"});
    requireRefused(folder, added("--report ./wall.obj"), {"--report is './wall.obj'", "input file"});
}

BOOST_AUTO_TEST_CASE(a_path_never_replaces_a_file_that_is_read) {
    const WindowProblemFolder folder;
    for (const std::string& input : folder.names()) {
        const std::string before = readText(folder.file(input));
        requireRefused(folder, "plan window.cfg --time 1 --path ./" + input,
                       {"--path is './" + input + "'", "input file", "expected another"});
        BOOST_TEST(readText(folder.file(input)) == before);
    }
}

BOOST_AUTO_TEST_CASE(a_start_or_goal_that_cannot_be_is_refused_in_one_line) {
    const WindowProblemFolder folder;
    Problem problem = folder.window.problem;
    problem.start.position.x() = 0;
    folder.rewrite(problem);
    requireRefused(folder, kPlan, {"start is " + beginningOf(WhyInvalid::Kind::kCollides), "plate"});
    problem.start.position.x() = -34;
    folder.rewrite(problem);
    requireRefused(folder, added("--margin 2.5"),
                   {"start is " + beginningOf(WhyInvalid::Kind::kTooClose), "2.5"});
    problem.start.position.x() = -60;
    problem.goal.position.x() = 81;
    folder.rewrite(problem);
    requireRefused(folder, kPlan, {"goal", "81"});
}

BOOST_AUTO_TEST_CASE(what_a_problem_file_says_in_vain_is_refused) {
    const WindowProblemFolder folder;
    Problem problem = folder.window.problem;
    problem.fineness.reset();
    problem.planning.planners = {{"rrtconnect", {{"max_depth", "3"}}}};
    folder.rewrite(problem);
    requireRefused(folder, kPlan, {"window.cfg", "RRTConnect", "'max_depth'", "expected one of"});

    const auto refusesBoth = [&](const std::string& wrong, const std::string& meant) {
        folder.rewrite(problem);
        for (const char* command : {"info window.cfg", kPlan})
            requireRefused(folder, command, {"window.cfg", "'" + wrong + "'", "'" + meant + "'", "expected"});
    };
    problem.planning.planners = {{"prm", {}, {{"sampler", "gausian"}}}};
    refusesBoth("gausian", "gaussian");
    problem.planning.planners = {{"rrtconnct", {}}};
    refusesBoth("rrtconnct", "RRTConnect");
    problem.planning.planners.clear();
    problem.planning.objective = "lenght";
    refusesBoth("lenght", "length");
}

BOOST_AUTO_TEST_CASE(where_nothing_counts_there_is_nothing_to_keep_clear_of) {
    const WindowProblemFolder folder;
    Problem problem = folder.window.problem;
    problem.rules.ignored = {"below", "above", "left", "right"};
    folder.rewrite(problem);
    for (const char* command : {kPlan, "check window.cfg out.path"})
        BOOST_TEST(row(runIn(folder, command), "least clearance") == "nothing to keep clear of");
}

/// OMPL's LazyPRMstar does not look at its end for minutes, once it has worked for two seconds; on a busy machine it may come to
/// its end by itself before.
BOOST_AUTO_TEST_CASE(a_planner_that_does_not_end_is_ended_with_the_program) {
    const TemporaryFolder folder;
    const std::string plan = "plan '" CLEARWAY_DATA_DIR
                             "/puzzle/puzzle.cfg' --path out.path "
                             "--planner LazyPRMstar --json facts.json ";
    folder.write("out.path", "of an earlier run\n");
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = runIn(folder, plan + "--time 3");
    const Outcome interrupted = interruptIn(folder, plan + "--time 1000");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    BOOST_TEST(seconds < 60);  // 6 on an idle machine
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(row(outcome, "old path").find("moved to ") == 0u);
    BOOST_TEST(interrupted.code == 1);
    BOOST_TEST(jsonIn(folder, "facts.json")["interrupted"] == true);
}

BOOST_AUTO_TEST_CASE(a_proof_that_there_is_no_path_is_told_at_once) {
    const WindowProblemFolder folder;
    saveMesh(named(translated(box({45, 40, 45}, 1), {-60, 0, 0}), "shell"), folder.file("wall.obj"));
    const std::string plan = "plan window.cfg --path out.path --nearest miss.path";
    BOOST_TEST(factsOf(folder, plan, 1)["proof"]["obstacle"] == "shell");
    const Outcome told = runIn(folder, plan);
    BOOST_TEST(holds(row(told, "proof"), "start is inside 'shell'"), told.out);
    BOOST_TEST(holds(row(told, "nearest"), "not written"), told.out);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
