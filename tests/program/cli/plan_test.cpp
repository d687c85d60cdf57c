#include <chrono>
#include <filesystem>
#include <fstream>

#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(plan_test)

namespace {

/// The wall with a window as files, and these files as they are read back.
struct WindowFolder : TemporaryFolder {
    WindowFolder() {
        saveMesh(window.partMesh, file("plate.obj"));
        saveMesh(window.wallMesh, file("wall.obj"));
        window.problem.robot = file("plate.obj");
        window.problem.world = file("wall.obj");
        window.problem.asOmplApp = false;
        write(window.problem);
    }

    using TemporaryFolder::write;
    void write(const Problem& problem, const std::string& name = "window.cfg") const {
        writeProblem(problem, file(name));
    }

    WindowScene window = windowScene();
};

constexpr const char* kPlan = "plan window.cfg --path out.path --iterations 200000";

std::string added(const std::string& more) {
    return std::string(kPlan) + " " + more;
}

BOOST_AUTO_TEST_CASE(a_path_is_found_written_and_free_by_the_oracle) {
    const WindowFolder folder;
    const Outcome outcome = runIn(folder, kPlan);
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");  // no progress line either, because this is no terminal
    BOOST_TEST(row(outcome, "planner") == "PlannerTeam, seed 1");
    BOOST_TEST(row(outcome, "repeatable") == "yes");
    BOOST_TEST(row(outcome, "motions") == "certified along their whole length");
    BOOST_TEST(std::stod(row(outcome, "planning time")) > 0);
    BOOST_TEST(std::stod(row(outcome, "length")) >= 120);
    BOOST_TEST(std::stod(row(outcome, "least clearance")) > 0);
    BOOST_TEST(row(outcome, "audit") == "valid along the whole path, certified");
    BOOST_TEST(row(outcome, "  on the part").find(" of 'plate', at (") != std::string::npos);
    BOOST_TEST(std::stod(row(outcome, "floor")) == 1e-3 * Vector3(60, 40, 10).norm(),
               boost::test_tools::tolerance(1e-3));
    BOOST_TEST(row(outcome, "path") == "out.path");

    const auto path = readPath(folder.file("out.path"), Space::kSe3);
    BOOST_TEST(std::to_string(path.size()) ==
               row(outcome, "states").substr(0, std::to_string(path.size()).size()));
    BOOST_TEST(path.front().position == folder.window.problem.start.position);
    BOOST_TEST(path.back().position == folder.window.problem.goal.position);
    const Problem problem = readProblem(folder.file("window.cfg"));
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
    BOOST_TEST(leastDistance(oracle, path, problem, 1000) > 0);
    BOOST_TEST(readText(folder.file("out.path")).find('.') != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_same_seed_and_iterations_write_the_same_bytes) {
    const WindowFolder folder;
    BOOST_TEST(runIn(folder, added("--seed 7")).code == 0);
    const std::string first = readText(folder.file("out.path"));
    BOOST_TEST(runIn(folder, added("--seed 7")).code == 0);
    BOOST_TEST(readText(folder.file("out.path")) == first);
    BOOST_TEST(runIn(folder, added("--seed 8")).code == 0);
    BOOST_TEST(readText(folder.file("out.path")) != first);
}

BOOST_AUTO_TEST_CASE(options_reach_the_planner) {
    const WindowFolder folder;
    const Outcome outcome = runIn(
        folder,
        "plan window.cfg --path out.path --time 100 --planner rrt --planner-param range=15 --planner-param "
        "goal_bias=0.1 --margin 1 --objective length --general-split mean --leaf-split chain "
        "--leaf-size 3 --target scalar");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(row(outcome, "found by") == "RRT");
    BOOST_TEST(row(outcome, "margin") == "1");
    BOOST_TEST(row(outcome, "motions") == "certified along their whole length");
    BOOST_TEST(row(outcome, "audit") == "valid along the whole path, certified");
    BOOST_TEST(std::stod(row(outcome, "least clearance")) > 0);
    const Outcome floored = runIn(folder, added("--floor 0.5"));
    BOOST_TEST(row(floored, "floor") == "0.5");
    BOOST_TEST(row(floored, "audit") == "valid along the whole path, certified");
    BOOST_TEST(runIn(folder, added("--ompl-weights")).code == 0);
}

BOOST_AUTO_TEST_CASE(an_objective_is_planned_for_and_its_cost_told) {
    const WindowFolder folder;
    Problem problem = folder.window.problem;
    problem.objective = "max_min_clearance";
    problem.objectiveThreshold = 0.01;  // ends the planning, however busy the machine is
    folder.write(problem);
    const Outcome outcome =
        runIn(folder, "plan window.cfg --path out.path --time 100 --objective Min_Clearance");
    BOOST_TEST(outcome.code == 0, outcome.err);
    const std::string objective = row(outcome, "objective"), least = row(outcome, "least clearance");
    BOOST_TEST(objective.rfind("max_min_clearance, cost ", 0) == 0, objective);
    BOOST_TEST(std::stod(objective.substr(24)) > 0);
    BOOST_TEST(std::stod(objective.substr(24)) <= std::stod(least.substr(least.find(" to ") + 4)));
}

BOOST_AUTO_TEST_CASE(what_no_position_within_the_bounds_can_come_near_is_left_out_and_counted) {
    const WindowFolder folder;
    // Sliding planners and bands go by distances whose last digits differ from tree to tree.
    const std::string verdictsAlone = "--planner RRTConnect --quick";
    BOOST_TEST(row(runIn(folder, added(verdictsAlone)), "environment") == "wall.obj, 432 triangles");
    const std::string path = readText(folder.file("out.path"));
    const Mesh far = transformed(folder.window.wallMesh, {Matrix3::Identity(), {1000, 0, 0}});
    saveMesh(joined(folder.window.wallMesh, far), folder.file("wall.obj"));
    const Outcome outcome = runIn(folder, added(verdictsAlone + " --cache trees"));
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(row(outcome, "environment") == "wall.obj, 432 triangles, 432 out of reach left out");
    BOOST_TEST(readText(folder.file("out.path")) == path);
    BOOST_TEST(row(runIn(folder, added("--cache trees")), "environment") == row(outcome, "environment"));
    const std::string reach = row(runIn(folder, "info window.cfg"), "out of reach");
    BOOST_TEST(reach.find("432 triangles, never within ") == 0, reach);

    saveMesh(far, folder.file("wall.obj"));
    const std::string least = row(runIn(folder, kPlan), "least clearance");
    BOOST_TEST(least.find(" or more") != std::string::npos, least);
}

BOOST_AUTO_TEST_CASE(no_path_is_exit_code_1_and_no_file) {
    const WindowFolder folder;
    const auto before = folder.names();
    const Outcome outcome = runIn(folder, "plan window.cfg --path out.path --time 0.3 --margin 12");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "path") == "none found");
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_interrupt_ends_the_planning_with_exit_code_1_and_no_file) {
    const WindowFolder folder;
    const auto before = folder.names();
    BOOST_TEST(interruptIn(folder, "plan window.cfg --path out.path --time 300 --margin 12").code == 1);
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused_in_one_line) {
    const WindowFolder folder;
    requireRefused(folder, "plan window.cfg", {"--path is missing"});
    requireRefused(folder, "plan nowhere.cfg --path out.path", {"nowhere.cfg"});
    requireRefused(folder, "plan window.cfg --path nowhere/out.path", {"nowhere/out.path"});
    requireRefused(folder, added("--planner RTRConnect"),
                   {"unknown planner 'RTRConnect'", "RRTConnect", "PRMstar"});
    requireRefused(folder, added("--planner-param rnage=1"), {"no parameter 'rnage'", "range"});
    requireRefused(folder, added("--planner-param range=far"), {"'far'", "expected a number"});
    requireRefused(folder, added("--planner-param range"), {"--planner-param is 'range'", "NAME=VALUE"});
    requireRefused(folder, added("--time 3"), {"--time and --iterations"});
    requireRefused(folder, "plan window.cfg --path out.path --time soon", {"--time is 'soon'"});
    requireRefused(folder, "plan window.cfg --path out.path --iterations 1.5", {"--iterations is '1.5'"});
    requireRefused(folder, added("--wanted-clearance 0"), {"--wanted-clearance is '0'"});
    requireRefused(folder, added("--seed 0"), {"--seed is '0'"});
    requireRefused(folder, added("--margin -1"), {"--margin is '-1'"});
    requireRefused(folder, added("--floor -1"), {"--floor is '-1'"});
    requireRefused(folder, added("--quick --objective length"), {"--quick and --objective", "expected one"});
    requireRefused(folder, added("--objective clearance"),
                   {"unknown objective 'clearance'", "length, max_min_clearance, "});
    requireRefused(folder, added("--general-split best"), {"best", "axis"});
    requireRefused(folder, added("--target abacus"), {"abacus", "scalar"});
}

BOOST_AUTO_TEST_CASE(a_report_and_an_animation_of_the_path_are_written_beside_it) {
    const WindowFolder folder;
    const Outcome outcome = runIn(folder, added("--report out.html"));
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(row(outcome, "report").find("out.html, ") == 0);
    const std::string page = readText(folder.file("out.html"));
    for (const char* text :
         {"</html>", "PlannerTeam, seed 1", "valid along the whole path, certified", "plate"})
        BOOST_TEST(page.find(text) != std::string::npos, text);
    BOOST_TEST(
        runIn(folder, "plan window.cfg --path other.path --export other.glb --time 0.3 --margin 12").code !=
        0);
    BOOST_TEST(readText(folder.file("other.glb")) == "");
    BOOST_TEST(runIn(folder, added("--export out.glb")).code == 0);
    BOOST_TEST(readText(folder.file("out.glb")).substr(0, 4) == "glTF");
    requireRefused(folder, added("--export out.obj"), {"out.obj", "expected a name that ends in .glb"});
    requireRefused(folder, added("--export out.glb --swept out.glb"),
                   {"--swept is 'out.glb'", "another file"});
    requireRefused(folder, added("--report nowhere/out.html"), {"nowhere/out.html"});
    requireRefused(folder, added("--report out.path"), {"--report is 'out.path'", "another file"});
    requireRefused(folder, added("--report ./wall.obj"), {"--report is './wall.obj'", "input file"});
}

BOOST_AUTO_TEST_CASE(a_path_never_replaces_a_file_that_is_read) {
    const WindowFolder folder;
    for (const std::string& input : folder.names()) {
        const std::string before = readText(folder.file(input));
        requireRefused(folder, "plan window.cfg --time 1 --path ./" + input,
                       {"--path is './" + input + "'", "input file", "expected another"});
        BOOST_TEST(readText(folder.file(input)) == before);
    }
}

BOOST_AUTO_TEST_CASE(a_start_or_goal_that_cannot_be_is_refused_in_one_line) {
    const WindowFolder folder;
    Problem problem = folder.window.problem;
    problem.start.position.x() = 0;
    folder.write(problem);
    requireRefused(folder, kPlan, {"start is in collision", "plate", "triangle", "touching"});
    problem.start.position.x() = -34;
    folder.write(problem);
    requireRefused(folder, added("--margin 2.5"), {"start is too close", "2 apart", "margin 2.5"});
    problem.start.position.x() = -60;
    problem.goal.position.x() = 81;
    folder.write(problem);
    requireRefused(folder, kPlan, {"goal", "81"});
}

BOOST_AUTO_TEST_CASE(what_a_problem_file_says_in_vain_is_refused) {
    const WindowFolder folder;
    Problem problem = folder.window.problem;
    problem.fineness.reset();
    problem.planners = {{"rrtconnect", {{"max_depth", "3"}}}};
    folder.write(problem);
    requireRefused(folder, kPlan,
                   {"window.cfg: planner RRTConnect has no parameter 'max_depth', expected one of"});

    const auto refusesBoth = [&](const std::string& words) {
        folder.write(problem);
        requireRefused(folder, "info window.cfg", {"clearway: window.cfg: ", words, "expected one of"});
        requireRefused(folder, kPlan, {"clearway: window.cfg: ", words, "expected one of"});
    };
    problem.planners = {{"prm", {}, {{"sampler", "gausian"}}}};
    refusesBoth("unknown sampler 'gausian' (did you mean 'gaussian'?)");
    problem.planners = {{"rrtconnct", {}}};
    refusesBoth("unknown planner 'rrtconnct' (did you mean 'RRTConnect'?)");
    problem.planners.clear();
    problem.objective = "lenght";
    refusesBoth("unknown objective 'lenght' (did you mean 'length'?)");
    problem.objective = "length";

    problem.planners = {{"nonesuch", {}}};
    folder.write(problem);
    std::filesystem::remove(folder.file("out.path"));  // would be set aside
    requireRefused(folder, kPlan, {"window.cfg", "unknown planner 'nonesuch'"});
}

BOOST_AUTO_TEST_CASE(where_nothing_counts_there_is_nothing_to_keep_clear_of) {
    const WindowFolder folder;
    Problem problem = folder.window.problem;
    problem.rules.ignored = {"below", "above", "left", "right"};
    folder.write(problem);
    BOOST_TEST(row(runIn(folder, kPlan), "least clearance") == "nothing to keep clear of");
    BOOST_TEST(row(runIn(folder, "check window.cfg out.path"), "least clearance") ==
               "nothing to keep clear of");
}

/// OMPL's LazyPRMstar does not look at its end for minutes, once it has worked for two seconds; on a busy machine it may come to
/// its end by itself before.
BOOST_AUTO_TEST_CASE(a_planner_that_does_not_end_is_ended_with_the_program) {
    const TemporaryFolder folder;
    const std::string plan = "plan '" CLEARWAY_DATA_DIR
                             "/puzzle/puzzle.cfg' --path out.path "
                             "--planner LazyPRMstar --json facts.json ";
    std::ofstream(folder.file("out.path")) << "of an earlier run\n";
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = runIn(folder, plan + "--time 4");
    const Outcome interrupted = interruptIn(folder, plan + "--time 1000");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    BOOST_TEST(seconds < 60);  // 9 on an idle machine
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST_MESSAGE(outcome.err);
    BOOST_TEST(row(outcome, "path") == "none found");
    BOOST_TEST(row(outcome, "old path").find("moved to ") == 0u);
    BOOST_TEST(interrupted.code == 1);
    BOOST_TEST(row(interrupted, "path") == "none, interrupted");
    BOOST_TEST(readText(folder.file("facts.json")).find("\"interrupted\": true") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_proof_that_there_is_no_path_is_told_at_once) {
    const WindowFolder folder;
    Mesh shell = transformed(box({45, 40, 45}, 1), {Matrix3::Identity(), {-60, 0, 0}});
    shell.components = {{"shell", 0, static_cast<std::uint32_t>(shell.triangles.size())}};
    saveMesh(shell, folder.file("wall.obj"));
    const Outcome outcome = runIn(folder, "plan window.cfg --path out.path --nearest miss.path --json -");
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(outcome.out.find("\"obstacle\": \"shell\"") != std::string::npos, outcome.out);
    const Outcome told = runIn(folder, "plan window.cfg --path out.path --nearest miss.path");
    BOOST_TEST(row(told, "path") == "none: there is none");
    BOOST_TEST(row(told, "proof") == "the start is inside 'shell', a closed surface, and the goal is not");
    BOOST_TEST(row(told, "nearest") == "not written: nothing was planned, because there is no path");
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
