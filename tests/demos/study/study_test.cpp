#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "program/bench/benchmark_log.h"
#include "program/cli/window_folder.h"
#include "support/full_run.h"

namespace clearway::testing {

using study::Benchmark;
using study::readBenchmarkLog;

BOOST_AUTO_TEST_SUITE(study_test)

namespace {

/// Eight runs: two planners, two strategies, two seeds. RRTstar takes all of its time.
constexpr const char* kStudy =
    "window.cfg --short --time 0.3 --planner RRTConnect --planner rrtstar "
    "--general-split sah --leaf-split none --leaf-split all";

Outcome runStudy(const TemporaryFolder& folder, const std::string& arguments) {
    return runIn(folder, arguments, kStudyProgram);
}

using StudyFolder = WindowProblemFolder;

using Rows = std::vector<std::vector<std::string>>;

/// The rows of a table, without the head.
Rows rowsOf(const std::string& table) {
    std::istringstream in(table);
    Rows rows;
    for (std::string line; std::getline(in, line);) {
        std::istringstream values(line);
        rows.emplace_back();
        for (std::string value; std::getline(values, value, ',');) rows.back().push_back(value);
    }
    if (!rows.empty()) rows.erase(rows.begin());
    return rows;
}

Rows readRows(const std::string& file) {
    return rowsOf(readText(file));
}

/// Each row's scene, planner, strategy and seed.
std::vector<std::string> keys(const Rows& rows) {
    std::vector<std::string> all;
    for (const auto& row : rows)
        all.push_back(row[0] + " " + row[1] + " " + row[2] + "/" + row[3] + " " + row[4]);
    return all;
}

/// The values of RRTConnect's runs that a seed decides: length, states and motions checked. A run may find no path in its time,
/// here or in `others`, which are the same runs; then the clock decides them.
std::vector<std::string> decided(const Rows& rows, const Rows& others) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& row = rows[i];
        const bool bothFoundPath = row[5] == "1" && others.at(i)[5] == "1";
        if (row[1] == "RRTConnect" && bothFoundPath) all.push_back(row[12] + " " + row[15] + " " + row[16]);
    }
    return all;
}

/// The first columns of replays and of trees, which identify a row.
std::multiset<std::string> trees(const Rows& rows) {
    std::multiset<std::string> all;
    for (const auto& row : rows)
        all.insert(row[0] + " " + row[1] + " " + row[2] + " " + row[3] + " " + row[4]);
    return all;
}

void overwrite(const std::string& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// Ends the study by the signal when this many runs are in its table.
Outcome runAndEnd(const StudyFolder& folder, const char* signal, int runs) {
    const std::string countLines = "$(cat '" + folder.file("study/runs.csv") + "' 2>/dev/null | wc -l)";
    return runStudy(folder, std::string(kStudy) + " --out study & program=$!; while [ " + countLines +
                                " -le " + std::to_string(runs) + " ]; do sleep 0.02; done; kill -" + signal +
                                " $program; wait $program");
}

void requireTablesAndLogs(const StudyFolder& folder, const Outcome& outcome) {
    BOOST_TEST(holds(outcome.out, "cost of the answers", "the thesis's claims", "95 % interval"));
    BOOST_TEST(holds(outcome.err, "run 1 of 8, RRTConnect sah/none seed 1"), outcome.err);
    for (const char* split : {"none", "all"}) {
        const Benchmark log =
            readBenchmarkLog(folder.file(std::string("study/logs/window_sah_") + split + ".log"));
        BOOST_TEST(log.experiment == "window");
        BOOST_TEST(log.parameters.at("leaf_split VARCHAR") == split);
        BOOST_TEST(log.parameters.at("general_split VARCHAR") == "sah");
        BOOST_TEST_REQUIRE(log.planners.size() == 2u);
        BOOST_TEST(log.planners[0].name == "geometric_RRTConnect");
        BOOST_TEST_REQUIRE(log.planners[0].runs.size() == 2u);
        BOOST_TEST(log.planners[0].runs[1].properties.at("seed INTEGER") == "2");
        for (const auto& row : readRows(folder.file("study/runs.csv"))) {
            if (row[1] == "RRTConnect" && row[3] == split && row[4] == "1")
                BOOST_TEST(log.planners[0].runs[0].properties.at("solved BOOLEAN") == row[5]);
        }
    }
    std::set<std::string> trees;
    for (const auto& row : readRows(folder.file("study/replay.csv")))
        trees.insert(row[1] + " " + row[2] + " " + row[3]);
    for (const char* tree : {"sah 4 8", "sah 8 8", "sah 16 8", "sah 4 2", "mean 4 8"})
        BOOST_TEST(trees.count(tree) == 1u, tree);
    for (const char* table : {"statistics.csv", "summary.csv", "claims.csv", "trees.csv"})
        BOOST_TEST(!readRows(folder.file(std::string("study/") + table)).empty(), table);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_study_that_was_stopped_or_killed_goes_on_without_losing_or_repeating_runs) {
    const StudyFolder whole, stopped;
    const Outcome atOnce = runStudy(whole, std::string(kStudy) + " --out study");
    BOOST_TEST_REQUIRE(atOnce.code == 0, atOnce.err);
    requireTablesAndLogs(whole, atOnce);
    const Rows expected = readRows(whole.file("study/runs.csv"));
    BOOST_TEST_REQUIRE(expected.size() == 8u);

    const Outcome interrupted = runAndEnd(stopped, "INT", 2);
    BOOST_TEST(interrupted.code == 1, interrupted.err);
    BOOST_TEST(holds(row(interrupted, "study"), "interrupted"));
    const std::string first = readText(stopped.file("study/runs.csv"));
    BOOST_TEST(readRows(stopped.file("study/runs.csv")).size() < 8u);

    runAndEnd(stopped, "KILL", 5);
    const std::string second = readText(stopped.file("study/runs.csv"));
    BOOST_TEST(second.find(first) == 0u);
    {  // as if the machine had gone down while a line was written
        std::ofstream cut(stopped.file("study/runs.csv"), std::ios::app);
        cut << "window,RRTConnect,sah,all";
    }
    const Outcome last = runStudy(stopped, std::string(kStudy) + " --out study");
    BOOST_TEST(last.code == 0, last.err);
    BOOST_TEST(readText(stopped.file("study/runs.csv")).find(second) == 0u);
    const Rows rows = readRows(stopped.file("study/runs.csv"));
    BOOST_TEST(keys(rows) == keys(expected), boost::test_tools::per_element());
    BOOST_TEST(decided(rows, expected) == decided(expected, rows), boost::test_tools::per_element());
    const auto replayed = [](const StudyFolder& folder) {
        const auto all = trees(readRows(folder.file("study/replay.csv")));
        return std::set<std::string>(all.begin(), all.end());
    };
    BOOST_TEST(replayed(stopped) == replayed(whole), boost::test_tools::per_element());

    // As if the study had been killed there.
    for (const char* table : {"study/replay.csv", "study/trees.csv"}) {
        const std::string text = readText(stopped.file(table));
        const std::size_t cut = text.rfind('\n', text.size() - 2) + 1;
        overwrite(stopped.file(table), text.substr(0, cut));
        BOOST_TEST(runStudy(stopped, std::string(kStudy) + " --out study").code == 0);
        const std::string again = readText(stopped.file(table));
        BOOST_TEST(std::count(again.begin(), again.end(), '\n') ==
                   std::count(text.begin(), text.end(), '\n'));
        BOOST_TEST(trees(rowsOf(again)) == trees(rowsOf(text)), boost::test_tools::per_element());
    }

    const std::string before =
        readText(stopped.file("study/replay.csv")) + readText(stopped.file("study/runs.csv"));
    BOOST_TEST(runStudy(stopped, std::string(kStudy) + " --out study").code == 0);
    BOOST_TEST(readText(stopped.file("study/replay.csv")) + readText(stopped.file("study/runs.csv")) ==
               before);
}

BOOST_AUTO_TEST_CASE(other_options_than_those_of_the_folder_and_a_run_that_is_there_twice_are_refused) {
    const StudyFolder folder;
    const std::string command =
        "window.cfg --short --planner RRTConnect --seeds 1 --time 2 "
        "--general-split sah --leaf-split none --leaf-split all --out study";
    BOOST_TEST_REQUIRE(runStudy(folder, command).code == 0);
    const auto other = [&](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    requireRefused(folder, other(command, "--time 2", "--time 3"), {"seconds '2', not '3'", "another folder"},
                   kStudyProgram);
    requireRefused(folder, other(command, "--seeds 1", "--seeds 2"), {"seeds '1', not '2'"}, kStudyProgram);
    requireRefused(folder, other(command, "split none --leaf-split all", "split none --leaf-split edge"),
                   {"leaf splits 'none all', not 'none edge'"}, kStudyProgram);
    requireRefused(folder, other(command, " --leaf-split none --leaf-split all", ""),
                   {"leaf splits 'none all', not 'none chain edge all'"}, kStudyProgram);
    const std::string runs = readText(folder.file("study/runs.csv"));
    overwrite(folder.file("study/runs.csv"), runs + runs.substr(runs.rfind('\n', runs.size() - 2) + 1));
    const Outcome twice = runStudy(folder, command);
    BOOST_TEST(twice.code == 2);
    BOOST_TEST(holds(twice.err, "RRTConnect sah/all seed 1 in window twice"), twice.err);
    overwrite(folder.file("study/runs.csv"), runs);
    Problem problem = readProblem(folder.file("window.cfg"));
    std::filesystem::rename(folder.file("plate.obj"), folder.file("moved.obj"));
    problem.meshes.robot = folder.file("moved.obj");
    folder.rewrite(problem);
    BOOST_TEST(runStudy(folder, command).code == 0, "the same scene in another file is taken for another");
    problem.start.position.x() += 1;
    folder.rewrite(problem);
    requireRefused(folder, command, {"scene window"}, kStudyProgram);
    problem.start.position.x() -= 1;
    problem.planning.planners = {{"RRTConnect", {{"range", "7"}}}};
    folder.rewrite(problem);
    requireRefused(folder, command, {"scene window"}, kStudyProgram);
}

/// In the short form the console is a smaller one, which the folder holds as if a stopped study had made it.
BOOST_AUTO_TEST_CASE(without_a_problem_a_short_study_makes_its_scenes_and_replays_their_poses) {
    const TemporaryFolder folder;
    if (!testing::isFullRun()) {
        const std::filesystem::path kept = folder.file("study/scenes/tunnel-console-3");
        std::filesystem::create_directories(kept.parent_path());
        std::filesystem::copy(CLEARWAY_DATA_DIR "/tunnel-console-small", kept);
        std::ofstream(kept / "complete") << "tunnel-console.cfg\n";
    }
    const std::string command =
        "--short --seeds 1 --time 0.2 --planner RRTConnect --general-split "
        "axis "
        "--leaf-split none --leaf-split chain --out study";
    const Outcome outcome = runStudy(folder, command);
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    BOOST_TEST(holds(outcome.out, "study/scenes/tunnel-console-3") == testing::isFullRun());
    std::set<std::string> scenes;
    for (const auto& row : readRows(folder.file("study/trees.csv"))) {
        scenes.insert(row[0]);
        if (row[0] == "tunnel-console")
            BOOST_TEST(std::stod(row[14]) >= testing::inForm(50, 40), row[14] << " of 100 poses collide");
    }
    BOOST_TEST(scenes == std::set<std::string>({"cembox", "tunnel-console"}),
               boost::test_tools::per_element());
    BOOST_TEST(readRows(folder.file("study/runs.csv")).size() == 4u);
}

BOOST_AUTO_TEST_CASE(bad_input_is_one_line_and_exit_code_2) {
    const StudyFolder folder;
    const auto refused = [&](const std::string& arguments, const std::vector<std::string>& words) {
        requireRefused(folder, arguments, words, kStudyProgram);
    };
    refused("window.cfg", {"--out is missing"});
    refused("none.cfg --out study", {"none.cfg"});
    refused("window.cfg --out study --seeds 0", {"--seeds is '0'"});
    refused("window.cfg --out study --time 0", {"--time is '0'"});
    refused("window.cfg --out study --planner RRTConnect:speed", {"unknown objective 'speed'"});
    refused("window.cfg --out study --planner nonesuch", {"unknown planner 'nonesuch'"});
    refused("window.cfg --out study --leaf-split some", {"--leaf-split is 'some'", "chain"});
    refused("window.cfg window.cfg --out study", {"two problems are named 'window'"});
    refused("window.cfg --out study --leaf-split all", {"one leaf split, expected at least two"});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
