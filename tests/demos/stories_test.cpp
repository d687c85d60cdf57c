#include <sys/wait.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "clearway/planning/check_path.h"
#include "clearway/problem.h"
#include "support/full_run.h"
#include "support/invalid_words.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(stories_test)

const std::string kGates = CLEARWAY_DATA_DIR "/gates/gates.cfg";
const std::string kConsole = CLEARWAY_DATA_DIR "/tunnel-console-small/tunnel-console.cfg";

struct Story {
    int code = -1;
    std::string out, err;
};

Story run(const TemporaryFolder& folder, const std::string& command) {
    const int status = std::system(
        (command + " > '" + folder.file("out") + "' 2> '" + folder.file("err") + "' < /dev/null").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readText(folder.file("out")),
            readText(folder.file("err"))};
}

Story tell(const TemporaryFolder& folder, const std::string& demo, const std::string& arguments) {
    Story story = run(folder, CLEARWAY_DEMOS "/demo_" + demo + " " + arguments);
    BOOST_TEST_MESSAGE(story.out);
    BOOST_TEST(story.code == 0, demo << " ended with " << story.code << ": " << story.err);
    return story;
}

/// The numbers that the pattern's groups hold in the first place of the text that it fits.
std::vector<double> numbers(const std::string& text, const std::string& pattern) {
    std::smatch found;
    BOOST_TEST_REQUIRE(std::regex_search(text, found, std::regex(pattern)),
                       "no " << pattern << " in " << text);
    std::vector<double> values;
    for (std::size_t i = 1; i < found.size(); ++i) values.push_back(std::stod(found[i]));
    return values;
}

const std::string kNumber = "(-?[0-9.]+)";

/// No more than the oracle finds along the path in a file.
void requireClearance(double claimed, const std::string& problemFile, const std::string& pathFile) {
    const Problem problem = readProblem(problemFile);
    const std::vector<PartState> path = readPath(pathFile, problem.space);
    BOOST_TEST_REQUIRE(path.size() >= 2u);
    BOOST_TEST((path.front().position - problem.start.position).norm() < 1e-9);
    BOOST_TEST((path.back().position - problem.goal.position).norm() < 1e-9);
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
    BOOST_TEST(leastDistance(oracle, path, problem, 100) > claimed - 0.006);  // less printed digits
}

BOOST_AUTO_TEST_CASE(console_keeps_a_clearance_of_ten_and_comes_no_closer_than_it_says) {
    const TemporaryFolder folder;
    for (int seed = 1; seed <= (testing::isFullRun() ? 6 : 1); ++seed) {
        const Story story =
            tell(folder, "console",
                 "'" + kConsole + "' '" + folder.file("console.path") + "' " + std::to_string(seed));
        const std::size_t second = story.out.find("the path with the most clearance:");
        BOOST_TEST_REQUIRE(second != std::string::npos, story.out);
        const std::string least =
            "after " + kNumber + " s, by [\\s\\S]*?clearance " + kNumber + ", certified";
        const double planned = numbers(story.out, least)[1];
        const double kept = numbers(story.out.substr(second), least)[1];
        BOOST_TEST(kept > planned);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they make everything slower
        BOOST_TEST(kept >= 10);
#endif
        requireClearance(kept, kConsole, folder.file("console.path"));
    }
}

BOOST_AUTO_TEST_CASE(certificate_refuses_what_checks_at_states_pass_and_bounds_what_is_valid) {
    const TemporaryFolder folder;
    const std::string out = tell(folder, "certificate", "").out;
    BOOST_TEST(holds(out, "   1 % of the space apart:  valid (", "0.12 % of the space apart:  valid ("));
    BOOST_TEST(std::regex_search(out, std::regex("certified: +not valid \\(")));
    // The cover's front meets the panel's side after 150 of 304.
    const auto blocked = numbers(out, "Valid up to t = " + kNumber + "\\. At t = " + kNumber + " it is " +
                                          beginningOf(WhyInvalid::Kind::kCollides));
    BOOST_TEST(blocked[0] < 150. / 304);
    BOOST_TEST(blocked[0] > 150. / 304 - 1e-4);
    BOOST_TEST(blocked[1] > 150. / 304 - 1e-6);
    BOOST_TEST(holds(out, "'cover'", "'panel'"));
    const auto bounds = numbers(out, "certified: valid.* between " + kNumber + " and " + kNumber);
    BOOST_TEST(bounds[0] <= 1);  // at the middle, where the cover stands straight
    BOOST_TEST(bounds[0] >= 0.9);
    BOOST_TEST(bounds[1] >= bounds[0]);
}

BOOST_AUTO_TEST_CASE(clearance_optimal_gains_clearance_and_keeps_what_it_says) {
    const TemporaryFolder folder;
    const Story story =
        tell(folder, "clearance_optimal", "'" + kGates + "' '" + folder.file("gates.path") + "'");
    std::vector<double> gained;
    std::istringstream lines(story.out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        double iterations, seconds, clearance;
        if (words >> iterations >> seconds >> clearance) gained.push_back(clearance);
    }
    BOOST_TEST_REQUIRE(gained.size() >= 2u);
    BOOST_TEST(std::is_sorted(gained.begin(), gained.end()));
    BOOST_TEST(gained.back() > gained.front());
    BOOST_TEST(gained.back() > 6);  // through the widest gate
    const double audited = numbers(story.out, "valid along the whole path, least clearance " + kNumber)[0];
    BOOST_TEST(audited > 0.98 * gained.back());
    requireClearance(audited, kGates, folder.file("gates.path"));
}

BOOST_AUTO_TEST_CASE(leaf_strategies_plan_by_the_same_motions_in_trees_with_every_split_and_answer) {
    const TemporaryFolder folder;
    const Story story = tell(folder, "leaf_strategies", "'" + kConsole + "'");
    std::vector<std::string> names;
    std::vector<double> seconds, leaves;
    std::set<std::vector<double>> decisions;
    std::istringstream lines(story.out);
    for (std::string line; std::getline(lines, line);) {
        std::smatch row;
        const std::regex form("(\\w+) +" + kNumber + " +" + kNumber + " +" + kNumber +
                              " +(\\d+) +(\\d+) +(\\d+) +(\\d+)");
        if (!std::regex_match(line, row, form)) continue;
        names.push_back(row[1]);
        seconds.push_back(std::stod(row[3]));
        BOOST_TEST(std::stod(row[2]) > seconds.back());
        BOOST_TEST(std::stod(row[4]) > 0);
        BOOST_TEST(std::stod(row[4]) < seconds.back());
        decisions.insert({std::stod(row[5]), std::stod(row[6])});
        leaves.push_back(std::stod(row[8]));
    }
    BOOST_TEST(names == leafSplitNames(), boost::test_tools::per_element());
    BOOST_TEST(decisions.size() == 1u);
    BOOST_TEST(*std::max_element(leaves.begin(), leaves.end()) > 2 * leaves.at(0));
    const double ratio = numbers(story.out, "the planner takes " + kNumber + " times as long as")[0];
    BOOST_TEST(std::abs(ratio - *std::min_element(seconds.begin() + 1, seconds.end()) / seconds[0]) <
               0.01 + 0.001 / seconds[0]);
}

BOOST_AUTO_TEST_CASE(replan_says_where_the_old_path_is_blocked_and_finds_another) {
    const TemporaryFolder folder;
    const Story story = tell(folder, "replan", "'" + kGates + "' '" + folder.path() + "'");
    BOOST_TEST(std::regex_search(story.out,
                                 std::regex("old path's segment [0-9]+ is valid up to .*'forgotten box'")));
    const std::string with = folder.file("with_box.cfg");
    BOOST_TEST(readProblem(with).meshes.furtherWorlds.size() == 1u);
    const std::size_t appeared = story.out.find("a box appears");
    BOOST_TEST_REQUIRE(appeared != std::string::npos);
    requireClearance(numbers(story.out.substr(appeared), "certified least clearance " + kNumber)[0], with,
                     folder.file("new.path"));
    BOOST_CHECK_NE(readText(folder.file("old.path")), readText(folder.file("new.path")));
}

BOOST_AUTO_TEST_CASE(distance_in_c_tells_the_distances_of_the_library) {
    const TemporaryFolder folder;
    const std::string part = CLEARWAY_DATA_DIR "/window/plate.obj",
                      wall = CLEARWAY_DATA_DIR "/window/wall.obj";
    const Story story = tell(folder, "distance", "'" + part + "' '" + wall + "'");
    const MeshOracle oracle(loadMesh(part), loadMesh(wall));
    int far = 0, touching = 0;
    std::istringstream lines(story.out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        double x, distance;
        if (!(words >> x >> distance)) continue;
        const double truth = oracle.distance({Matrix3::Identity(), {x, 0, 12}}).distance;
        BOOST_TEST(std::abs(distance - truth) < 1e-4);  // printed digits
        ++(distance > 0 ? far : touching);
    }
    BOOST_TEST(far >= 6);
    BOOST_TEST(touching >= 3);
    const Story missing = run(folder, CLEARWAY_DEMOS "/demo_distance nothing.stl '" + wall + "'");
    BOOST_TEST(missing.code == 2);
    BOOST_TEST(holds(missing.err, "cannot read", "'nothing.stl'"), missing.err);
}

BOOST_AUTO_TEST_CASE(demos_take_problems_whose_obstacles_count_apart_or_not_at_all) {
    const TemporaryFolder folder;
    Problem problem = readProblem(CLEARWAY_DATA_DIR "/window/window.cfg");
    const std::string file = folder.file("window.cfg");
    const std::string console = "'" + file + "' '" + folder.file("a.path") + "'";
    problem.rules.margins["left"] = 0.5;
    writeProblem(problem, file);
    const std::string both = tell(folder, "console", console).out;
    BOOST_TEST(holds(both, "324 triangles, margin 0\n", "108 triangles, margin 0.5\n"), both);
    problem.rules.ignored = {"left", "right", "above", "below"};
    writeProblem(problem, file);
    tell(folder, "console", console);
    if (testing::isFullRun()) {
        tell(folder, "replan", "'" + file + "' '" + folder.path() + "'");
    }
    problem.rules.ignored = {"right"};
    writeProblem(problem, file);
    tell(folder, "replan", "'" + file + "' '" + folder.path() + "'");
    if (!testing::isFullRun()) return;  // the other demo takes six seconds for any problem
    const std::string splits = tell(folder, "leaf_strategies", "'" + file + "'").out;
    BOOST_TEST(holds(splits, "plitting leaves"), splits);  // an answer, or too quick to tell
}

/// The lower box lies on the floor, below the upper one.
BOOST_AUTO_TEST_CASE(disassemble_writes_paths_that_hold_among_the_parts_still_there_and_says_what_is_held) {
    const TemporaryFolder folder;
    const auto box = [](const char* name, const Vector3& low, const Vector3& high) {
        return boxMesh(Box(low, high), name);
    };
    std::filesystem::create_directory(folder.file("parts"));
    for (const Mesh& part : {box("floor", {0, 0, 0}, {20, 20, 2}), box("lower", {4, 4, 2}, {10, 10, 5}),
                             box("upper", {2, 2, 5.01}, {12, 12, 8})})
        saveMesh(part, folder.file("parts/" + part.components[0].name + ".obj"));
    const std::string words = "'" + folder.file("parts") + "' '" + folder.file("apart") + "' ";
    const std::string program = CLEARWAY_DEMOS "/demo_disassemble ";
    const std::string kept = tell(folder, "disassemble", words + "20 'u*r'").out;
    BOOST_TEST(holds(kept, "2 of 3 parts came out one after the other"), kept);
    BOOST_TEST(numbers(readText(folder.file("apart/disassembly.csv")),
                       "\"([12])\",\"lower\",[^]*\n\"\",\"upper\",[^\n]*\"stays\"")[0] >= 1);
    const std::string apart = tell(folder, "disassemble", words).out;
    BOOST_TEST(holds(apart, "2 of 3 parts came out one after the other"), apart);
    const std::string order = readText(folder.file("apart/disassembly.csv"));
    const std::vector<double> upper = numbers(order, "\"[12]\",\"upper\",\"" + kNumber + "\",\"" + kNumber +
                                                         "\",\"" + kNumber + "\",\"no contact\"");
    BOOST_TEST(upper[2] > 0);
    BOOST_TEST(upper[2] <= 3.01);  // it stands by so much above the floor
    BOOST_TEST(holds(order, "\",\"lower\",", "\"\",\"floor\",\"\",\"\",\"\",\"stays\""), order);
    BOOST_TEST(std::filesystem::exists(folder.file("apart/disassembly.glb")));
    int paths = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("apart"))) {
        if (entry.path().extension() != ".cfg") continue;
        ++paths;
        const Problem problem = readProblem(entry.path().string());
        std::filesystem::path path = entry.path();
        path.replace_extension(".path");
        const planning::PathCheck check =
            planning::checkPath(problem, loadScene(problem).scene, readPath(path.string(), problem.space));
        BOOST_TEST(check.audit.isValid());
        BOOST_TEST(check.beginsAtStart());
        BOOST_TEST(check.endsAtGoal());
    }
    BOOST_TEST(paths == 2);
    const Story unknown = run(folder, program + words + "20 roof"), help = run(folder, program + "--help");
    BOOST_TEST(unknown.code == 2);
    BOOST_TEST(holds(unknown.err, "'roof'", "'floor'"), unknown.err);
    BOOST_TEST(help.code == 0);
    BOOST_TEST(holds(help.out, "SECONDS", "NAME"), help.out);
}

BOOST_AUTO_TEST_CASE(demos_without_their_arguments_say_what_is_expected) {
    const TemporaryFolder folder;
    for (const std::string demo : {"console", "clearance_optimal", "disassemble", "leaf_strategies", "replan",
                                   "distance", "smallest_checker"}) {
        const Story story = run(folder, CLEARWAY_DEMOS "/demo_" + demo);
        BOOST_TEST(story.code == 2);
        BOOST_TEST(holds(story.err, "expected"), story.err);
    }
}

/// demos/run builds before it runs a demo; what it refuses or lists it says at once.
BOOST_AUTO_TEST_CASE(the_runner_lists_every_demo_and_refuses_others) {
    const TemporaryFolder folder;
    const std::string runner = "'" CLEARWAY_DEMO_SOURCES "/run'";
    const Story help = run(folder, runner + " --help"), unknown = run(folder, runner + " nobody"),
                tooMany = run(folder, runner + " console replan");
    BOOST_TEST(help.code == 0);
    BOOST_TEST(unknown.code == 2);
    BOOST_TEST(tooMany.code == 2);
    BOOST_TEST(holds(unknown.err, "'nobody'"), unknown.err);
    int demos = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CLEARWAY_DEMO_SOURCES)) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".c") continue;
        ++demos;
        const std::string name = entry.path().stem().string();
        BOOST_TEST(holds(help.out, "    " + name + " "), name << " in " << help.out);
        BOOST_TEST(holds(unknown.err, name), name << " in " << unknown.err);
    }
    for (const char* other : {"pages", "scene", "study"})  // no file of this folder is their program
        BOOST_TEST(holds(help.out, "    " + std::string(other) + " "));
    BOOST_TEST(demos + 3 == std::count(help.out.begin(), help.out.end(), '\n') - 2);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
