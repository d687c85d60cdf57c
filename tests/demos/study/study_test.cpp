#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/full_run.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(study_test)

/// RRTConnect takes some 20 ms for a path through the window. 3 general splits less one, 5 leaf splits, 15 seeds: 150 paired runs.
constexpr const char* kStudy = "window/window.cfg --short --planner RRTConnect --seeds 15 --out study";
constexpr std::size_t kRuns = 150;

Outcome runStudy(const TemporaryFolder& folder, const std::string& arguments) {
    return runIn(folder, arguments, kStudyProgram);
}

/// A folder with a problem of the data.
struct StudyFolder : TemporaryFolder {
    StudyFolder() { std::filesystem::copy(CLEARWAY_DATA_DIR "/window", file("window")); }
};

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

/// Each row's scene, planner, tree and seed, and what a seed decides where it found a path: its length, and how many states and motions
/// it asked about.
std::multiset<std::string> decided(const Rows& rows) {
    std::multiset<std::string> all;
    for (const auto& row : rows)
        all.insert(row[0] + " " + row[1] + " " + row[2] + "/" + row[3] + " " + row[4] + " " + row[5] + " " +
                   (row[5] == "1" ? row[12] + " " + row[15] + " " + row[16] : ""));
    return all;
}

/// The first columns of replays, which identify a row.
std::multiset<std::string> samples(const Rows& rows) {
    std::multiset<std::string> all;
    for (const auto& row : rows) {
        std::string key;
        for (std::size_t i = 0; i < 8; ++i) key += row[i] + " ";
        all.insert(key);
    }
    return all;
}

void overwrite(const std::string& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// Ends the study by the signal when this many runs are in its table.
Outcome runAndEnd(const StudyFolder& folder, const char* signal, int runs) {
    const std::string countLines = "$(cat '" + folder.file("study/runs.csv") + "' 2>/dev/null | wc -l)";
    return runStudy(folder, std::string(kStudy) + " & program=$!; while [ " + countLines + " -le " +
                                std::to_string(runs) + " ]; do sleep 0.02; done; kill -" + signal +
                                " $program; wait $program");
}

BOOST_AUTO_TEST_CASE(a_study_that_was_stopped_or_killed_goes_on_without_losing_or_repeating_runs) {
    const StudyFolder whole, stopped;
    const Outcome atOnce = runStudy(whole, kStudy);
    BOOST_TEST_REQUIRE(atOnce.code == 0, atOnce.err);
    BOOST_TEST(
        holds(atOnce.out, "For one path, from files to the path, take ", "For thousands of queries, take "),
        atOnce.out);
    BOOST_TEST(std::count(atOnce.out.begin(), atOnce.out.end(), '\n') == 3);  // two sentences and the folder
    BOOST_TEST(readText(whole.file("study/answer.txt")) == atOnce.out.substr(0, atOnce.out.find("study:")));
    const Rows expected = readRows(whole.file("study/runs.csv"));
    BOOST_TEST_REQUIRE(expected.size() == kRuns);
    for (const char* table : {"files.csv", "qualification.csv", "cells.csv", "ratios.csv", "replay.csv"})
        BOOST_TEST(!readRows(whole.file(std::string("study/") + table)).empty(), table);
    BOOST_TEST(readRows(whole.file("study/files.csv")).size() == 10u);
    for (const auto& row : readRows(whole.file("study/cells.csv"))) {
        BOOST_TEST(row[4] == "15");
        BOOST_TEST(row[5] == "15", row[2] << "/" << row[3] << " solved " << row[5]);
        // A planner that does not look at the clock asks the same in every tree.
        BOOST_TEST(row[15] == "15",
                   row[2] << "/" << row[3] << ": equal questions with " << row[15] << " seeds");
    }

    const Outcome interrupted = runAndEnd(stopped, "INT", 10);
    BOOST_TEST(interrupted.code == 1, interrupted.err);
    BOOST_TEST(holds(row(interrupted, "study"), "interrupted"));
    const std::string first = readText(stopped.file("study/runs.csv"));
    BOOST_TEST(rowsOf(first).size() < kRuns);

    runAndEnd(stopped, "KILL", 40);
    const std::string second = readText(stopped.file("study/runs.csv"));
    BOOST_TEST(second.find(first) == 0u);
    {  // as if the machine had gone down while a line was written
        std::ofstream cut(stopped.file("study/runs.csv"), std::ios::app);
        cut << "window,RRTConnect,sah,all";
    }
    const Outcome last = runStudy(stopped, kStudy);
    BOOST_TEST(last.code == 0, last.err);
    BOOST_TEST(readText(stopped.file("study/runs.csv")).find(second) == 0u);
    BOOST_TEST(decided(readRows(stopped.file("study/runs.csv"))) == decided(expected),
               boost::test_tools::per_element());
    const std::string replays = readText(stopped.file("study/replay.csv"));
    BOOST_TEST(samples(rowsOf(replays)) == samples(readRows(whole.file("study/replay.csv"))),
               boost::test_tools::per_element());

    // As if the study had been killed while it wrote a job's rows.
    overwrite(stopped.file("study/replay.csv"),
              replays.substr(0, replays.rfind('\n', replays.size() - 2) + 1));
    const std::string before = readText(stopped.file("study/runs.csv"));
    BOOST_TEST(runStudy(stopped, kStudy).code == 0);
    BOOST_TEST(samples(readRows(stopped.file("study/replay.csv"))) == samples(rowsOf(replays)),
               boost::test_tools::per_element());
    BOOST_TEST(readText(stopped.file("study/runs.csv")) == before);
}

BOOST_AUTO_TEST_CASE(other_options_than_those_of_the_folder_and_a_run_that_is_there_twice_are_refused) {
    const StudyFolder folder;
    const std::string command = "window/window.cfg --short --planner RRTConnect --seeds 2 --out study";
    BOOST_TEST_REQUIRE(runStudy(folder, command).code == 0);
    const auto other = [&](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    requireRefused(folder, other(command, "--seeds 2", "--seeds 3"), {"seeds '2', not '3'", "another folder"},
                   kStudyProgram);
    requireRefused(folder, other(command, "--short", "--short --minutes 2"), {"minutes '1', not '2'"},
                   kStudyProgram);
    requireRefused(folder, other(command, "RRTConnect", "PRM"), {"planners 'RRTConnect', not 'PRM'"},
                   kStudyProgram);
    const std::string runs = readText(folder.file("study/runs.csv"));
    overwrite(folder.file("study/runs.csv"), runs + runs.substr(runs.rfind('\n', runs.size() - 2) + 1));
    const Outcome twice = runStudy(folder, command);
    BOOST_TEST(twice.code == 2);
    BOOST_TEST(holds(twice.err, "in window twice"), twice.err);
    overwrite(folder.file("study/runs.csv"), runs);
    const std::string file = folder.file("window/window.cfg");
    Problem problem = readProblem(file);
    std::filesystem::rename(folder.file("window/plate.obj"), folder.file("window/moved.obj"));
    problem.meshes.robot = folder.file("window/moved.obj");
    writeProblem(problem, file);
    BOOST_TEST(runStudy(folder, command).code == 0, "the same scene in another file is taken for another");
    problem.start.position.x() += 1;
    writeProblem(problem, file);
    requireRefused(folder, command, {"scene window"}, kStudyProgram);
    problem.start.position.x() -= 1;
    problem.planning.planners = {{"RRTConnect", {{"range", "7"}}}};
    writeProblem(problem, file);
    requireRefused(folder, command, {"scene window"}, kStudyProgram);
}

/// A planner that finds no path has no time to one: it is named with its runs, and nothing is said of it.
BOOST_AUTO_TEST_CASE(a_planner_that_does_not_qualify_is_listed_and_has_no_ratios) {
    const StudyFolder folder;
    const Outcome outcome = runStudy(
        folder, "window/window.cfg --short --planner RRTConnect --planner STRIDE --seeds 2 --out study");
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    const Rows rows = readRows(folder.file("study/qualified.csv"));
    BOOST_TEST_REQUIRE(rows.size() == 2u);
    BOOST_TEST(rows[0][5] == "enters");
    const std::set<std::string> verdicts = {"solves too few", "too slow", "enters"};
    BOOST_TEST(verdicts.count(rows[1][5]) == 1u, rows[1][5]);
    for (const auto& row : readRows(folder.file("study/ratios.csv")))
        BOOST_TEST((row[7] != "STRIDE" || rows[1][5] == "enters"));
    BOOST_TEST(holds(outcome.err, "unable: STRIDE") == (rows[1][5] != "enters"), outcome.err);
}

/// Its scene is made, its poses are those beside the scene's path, and the thesis's claims are judged by them.
BOOST_AUTO_TEST_CASE(without_a_problem_a_short_study_takes_its_own) {
    const TemporaryFolder folder;
    const Outcome outcome = runStudy(folder, "--short --seeds 2 --planner RRTConnect --out study");
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    BOOST_TEST(holds(outcome.out, "study/scenes/cembox"), outcome.out);
    const Rows trees = readRows(folder.file("study/trees.csv"));
    BOOST_TEST(trees.size() == 14u);
    for (const auto& row : trees) {
        BOOST_TEST(row[0] == "cembox");
        BOOST_TEST(row[13] == "100");
    }
    BOOST_TEST(readRows(folder.file("study/claims.csv")).size() == 24u);
    std::set<std::string> scenes;
    for (const auto& row : readRows(folder.file("study/files.csv"))) scenes.insert(row[0]);
    BOOST_TEST(scenes == std::set<std::string>({"cembox", "gates", "window"}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(bad_input_is_one_line_and_exit_code_2) {
    const StudyFolder folder;
    const auto refused = [&](const std::string& arguments, const std::vector<std::string>& words) {
        requireRefused(folder, arguments, words, kStudyProgram);
    };
    refused("window/window.cfg", {"--out is missing"});
    refused("none.cfg --out study", {"none.cfg"});
    refused("window/window.cfg --out study --seeds 0", {"--seeds is '0'"});
    refused("window/window.cfg --out study --minutes 0", {"--minutes is '0'"});
    refused("window/window.cfg --out study --planner nonesuch", {"unknown planner 'nonesuch'"});
    refused("window/window.cfg window/window.cfg --out study", {"two problems are named 'window'"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
