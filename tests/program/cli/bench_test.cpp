#include <filesystem>

#include "program/bench/benchmark_log.h"
#include "program/cli/window_folder.h"

namespace clearway::testing {

using study::Benchmark;
using study::readBenchmarkLog;

BOOST_AUTO_TEST_SUITE(bench_test)

/// Two planners, one run each.
struct BenchFolder : WindowProblemFolder {
    BenchFolder() {
        window.problem.planning.planners = {{"rrtconnect"}, {"rrt", {{"name", "RRT*?"}}}};
        window.problem.benchmark.timeLimit = 20;
        window.problem.benchmark.runCount = 1;
        rewrite();
    }
};

BOOST_AUTO_TEST_CASE(the_problems_planners_are_run_and_the_log_lies_beside_it) {
    const BenchFolder folder;
    const Outcome outcome = runIn(folder, "bench window.cfg --json facts.json");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(holds(row(outcome, "geometric_RRT*?"), "1 of 1 run solved"));
    const auto facts = jsonIn(folder, "facts.json");
    BOOST_TEST(facts["log"] == "window.log");
    BOOST_TEST(facts["planners"][0]["runs"][0]["solved"] == true);
    const Benchmark log = readBenchmarkLog(folder.file("window.log"));
    BOOST_TEST(log.experiment == "window");
    BOOST_TEST(log.options.seconds == 20);
    BOOST_TEST(log.options.runs == 1);
    BOOST_TEST_REQUIRE(log.planners.size() == 2u);
    BOOST_TEST(log.planners[0].runs.at(0).properties.at("correct solution strict BOOLEAN") == "1");
}

BOOST_AUTO_TEST_CASE(options_go_before_what_the_problem_says) {
    BenchFolder folder;
    folder.window.problem.planning.planners[0].parameters = {{"range", "13"}};
    folder.rewrite();
    const Outcome outcome =
        runIn(folder,
              "bench window.cfg --log sub.log --time 15 --memory 500 --runs 2 --planner "
              "RRTConnect --planner pdst --seed 5 --margin 1 --no-simplify --save-paths all "
              "--target scalar --leaf-split chain");
    BOOST_TEST(outcome.code == 0, outcome.err);
    const Benchmark log = readBenchmarkLog(folder.file("sub.log"));
    BOOST_TEST(log.options.seconds == 15);
    BOOST_TEST(log.options.megabytes == 500);
    BOOST_TEST(log.options.seed == 5u);
    BOOST_TEST(log.parameters.at("margin REAL") == "1");
    BOOST_TEST(log.parameters.at("leaf_split VARCHAR") == "chain");
    BOOST_TEST(log.parameters.at("hash_of_files VARCHAR").rfind("0x", 0) == 0u);
    BOOST_TEST_REQUIRE(log.planners.size() == 2u);
    BOOST_TEST(log.planners[0].settings.at("range") == "13");
    BOOST_TEST(log.planners[1].name == "geometric_PDST");
    BOOST_TEST_REQUIRE(log.planners[0].runs.size() == 2u);
    BOOST_TEST(log.planners[0].runs[1].properties.at("seed INTEGER") == "6");
    BOOST_TEST(log.planners[0].runs[0].properties.count("simplification time REAL") == 0u);
    for (const char* path : {"window_geometric_RRTConnect_0.path", "window_geometric_RRTConnect_1.path"}) {
        const auto states = readPath(folder.file(path), Space::kSe3);
        BOOST_TEST(states.front().position == folder.window.problem.start.position);
        BOOST_TEST(states.back().position == folder.window.problem.goal.position);
    }
}

BOOST_AUTO_TEST_CASE(the_problem_says_where_the_log_goes_and_which_paths_are_kept) {
    BenchFolder folder;
    folder.window.problem.benchmark.outputFolder = "results";
    folder.window.problem.benchmark.savedPaths = SavedPaths::kShortest;
    folder.window.problem.planning.planners = {{"rrtconnect"}, {"rrtconnect"}};
    folder.window.problem.benchmark.runCount = 2;
    folder.rewrite();
    BOOST_TEST(runIn(folder, "bench window.cfg").code == 0);
    readBenchmarkLog(folder.file("results/window.log"));
    int paths = 0;
    for (const char* planner : {"RRTConnect", "RRTConnect-2"}) {
        for (const char* run : {"_0.path", "_1.path"})
            paths += std::filesystem::exists(
                folder.file(std::string("results/window_geometric_") + planner + run));
    }
    BOOST_TEST(paths == 2);
}

BOOST_AUTO_TEST_CASE(an_interrupt_leaves_a_log_of_the_runs_that_ended) {
    BenchFolder folder;
    folder.window.problem.planning.planners = {{"rrtconnect"}, {"rrtstar"}};  // RRTstar takes all its time
    folder.window.problem.benchmark.timeLimit = 300;
    folder.rewrite();
    const Outcome outcome =
        runIn(folder, "bench window.cfg & program=$!; sleep 4; kill -INT $program; wait $program");
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(holds(row(outcome, "took"), "interrupted"));
    const Benchmark log = readBenchmarkLog(folder.file("window.log"));
    BOOST_TEST_REQUIRE(log.planners.size() == 2u);
    BOOST_TEST(log.planners[1].runs.empty());
}

BOOST_AUTO_TEST_CASE(bad_input_is_one_line_and_exit_code_2) {
    BenchFolder folder;
    const auto refused = [&](const std::string& arguments, const std::vector<std::string>& words) {
        requireRefused(folder, "bench window.cfg " + arguments, words);
    };
    refused("--runs 0", {"--runs is '0'", "1 to 1000000"});
    refused("--time 0", {"--time is '0'", "above 0"});
    refused("--memory -1", {"--memory is '-1'"});
    refused("--seed 0", {"--seed is '0'"});
    refused("--iterations 0", {"--iterations is '0'"});
    refused("--iterations 5 --time 5", {"--time and --iterations are both given"});
    refused("--planner nonesuch", {"unknown planner 'nonesuch'", "RRTConnect"});
    refused("--save-paths some", {"--save-paths is 'some'", "shortest"});
    refused("--log window.cfg", {"--log is 'window.cfg'", "input file"});
    refused("--log none/x.log", {"none/x.log", "a folder that exists"});
    requireRefused(folder, "bench none.cfg", {"none.cfg", "No such file"});
    std::filesystem::rename(folder.file("window.cfg"), folder.file("window.log"));
    requireRefused(folder, "bench window.log", {"the log is 'window.log'", "input file"});
    folder.window.problem.planning.planners.push_back({"lightning"});
    folder.rewrite();
    refused("", {"window.cfg", "unknown planner 'lightning'"});
    folder.window.problem.planning.planners.back() = {"rrt", {{"range", "far"}}};
    folder.rewrite();
    refused("", {"range", "'far'", "a number"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
