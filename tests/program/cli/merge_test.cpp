#include <fstream>

#include "program/bench/benchmark_log.h"
#include "program/cli/window_folder.h"

namespace clearway::testing {

using study::Benchmark;
using study::readBenchmarkLog;

BOOST_AUTO_TEST_SUITE(merge_test)

/// Logs of the window: a.log and b.log as a job array makes them, and whole.log with the runs of both.
struct LogFolder : WindowProblemFolder {
    LogFolder() {
        bench("--seed 1 --runs 2 --log a.log");
        bench("--seed 3 --runs 2 --log b.log");
    }

    void bench(const std::string& options) const {
        const Outcome outcome = runIn(*this,
                                      "bench window.cfg --iterations 300 --no-simplify --planner "
                                      "RRTConnect --planner RRTstar " +
                                          options);
        BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    }

    /// A copy of b.log without the last run of RRTstar, as an interrupted benchmark leaves it.
    void writeCutLog(const std::string& name) const {
        Benchmark log = readBenchmarkLog(file("b.log"));
        log.planners.at(1).runs.pop_back();
        std::ofstream out(file(name));
        writeBenchmarkLog(log, out);
    }

    /// b.log with another word.
    void writeWith(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = readText(file("b.log"));
        BOOST_TEST_REQUIRE(text.find(from) != std::string::npos, from);
        write(name, text.replace(text.find(from), from.size(), to));
    }
};

/// The values of runs that seeds and iterations decide.
std::vector<std::string> decided(const Benchmark& log) {
    std::vector<std::string> all;
    for (const auto& planner : log.planners) {
        for (const auto& run : planner.runs) {
            for (const char* name :
                 {"seed INTEGER", "status ENUM", "state checks INTEGER", "graph states INTEGER"})
                all.push_back(planner.name + " " + name + " " + run.properties.at(name));
        }
    }
    return all;
}

BOOST_AUTO_TEST_CASE(logs_of_a_job_array_become_the_log_of_one_benchmark) {
    const LogFolder folder;
    folder.bench("--runs 4 --log whole.log");
    const Outcome outcome = runIn(folder, "bench --merge b.log a.log --log all.log");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(holds(row(outcome, "geometric_RRTstar"), " of 4 runs solved"));
    const Benchmark all = readBenchmarkLog(folder.file("all.log"));
    BOOST_TEST(decided(all) == decided(readBenchmarkLog(folder.file("whole.log"))),
               boost::test_tools::per_element());
    BOOST_TEST(all.options.seed == 1u);
    BOOST_TEST(all.options.runs == 4);
    BOOST_TEST(runIn(folder, "bench --merge all.log --log again.log").code == 0);
    BOOST_TEST(readText(folder.file("again.log")) == readText(folder.file("all.log")));
}

BOOST_AUTO_TEST_CASE(missing_runs_are_named_as_lost_until_they_are_there) {
    const LogFolder folder;
    folder.writeCutLog("cut.log");
    BOOST_TEST(factsOf(folder, "bench --merge a.log cut.log --log all.log", 1)["lost"].dump() ==
               R"([{"planner":"geometric_RRTstar","seeds":[4]}])");
    BOOST_TEST(readBenchmarkLog(folder.file("all.log")).planners.at(1).runs.size() == 3u);

    folder.bench("--seed 7 --runs 1 --log later.log");
    const Outcome gap = runIn(folder, "bench --merge a.log b.log later.log --log gap.log");
    BOOST_TEST(gap.code == 1, gap.err);
    BOOST_TEST(holds(row(gap, "lost"), "seeds 5 to 6"), gap.out);
    folder.bench("--seed 5 --runs 2 --log between.log");
    BOOST_TEST(runIn(folder, "bench --merge gap.log between.log --log filled.log").code == 0);

    folder.bench("--seed 4 --runs 1 --log rest.log");
    const Outcome whole = runIn(folder, "bench --merge all.log rest.log --log whole.log");
    BOOST_TEST(whole.code == 0, whole.out);
    BOOST_TEST(holds(whole.err, "rest.log", "1 run", "left out"), whole.err);
}

BOOST_AUTO_TEST_CASE(logs_that_do_not_belong_together_are_refused_by_name) {
    const LogFolder folder;
    const auto refused = [&](const std::string& log, const std::vector<std::string>& words) {
        requireRefused(folder, "bench --merge a.log " + log + " --log all.log", words);
    };
    folder.writeWith("margin.log", "margin REAL = 0", "margin REAL = 1");
    refused("margin.log", {"margin.log", "'margin REAL = 1'", "'margin REAL = 0'", "a.log"});
    folder.writeWith("time.log", "inf seconds", "30 seconds");
    refused("time.log", {"time.log", "'30 seconds", "expected 'inf seconds"});
    folder.writeWith("planner.log", "\ngeometric_RRTstar\n", "\ngeometric_PRM\n");
    refused("planner.log", {"planner.log", "geometric_PRM'", "expected", "geometric_RRTstar'"});
    folder.writeWith("seed.log", "3 is the random seed", "9 is the random seed");
    refused("seed.log", {"seed.log", "geometric_RRTConnect", "seed 3", "expected 9 to 10"});
    folder.writeWith("other.log", "OMPL version ", "OMPL version 0.");
    refused("other.log", {"other.log:1: 'OMPL version 0.", "expected 'OMPL version "});

    const std::string whole = readText(folder.file("b.log"));
    folder.write("short.log", whole.substr(0, whole.size() / 2));
    refused("short.log", {"short.log:"});
    folder.write("shorter.log", whole.substr(0, whole.find("planners\n") + 9));
    refused("shorter.log", {"shorter.log", "expected a planner"});
    folder.write("two.log", whole + whole);
    refused("two.log", {"two.log:", "expected the end of the log"});
    folder.writeWith("many.log", "2 runs per planner", "2000000000 runs per planner");
    refused("many.log", {"many.log", "2000000000 runs", "at most 1000000"});
    folder.write("empty.log", "");
    refused("empty.log", {"empty.log", "0 lines", "expected 'OMPL version "});
    refused("window.cfg", {"window.cfg:1: ", "expected 'OMPL version "});
    refused("none.log", {"none.log", "No such file"});
    requireRefused(folder, "bench --merge --log all.log", {"LOG is missing"});
    requireRefused(folder, "bench --merge a.log", {"--log is missing"});
    requireRefused(folder, "bench --merge a.log --log a.log", {"--log is 'a.log'", "input file"});

    Problem problem = readProblem(folder.file("window.cfg"));
    problem.start.position.x() += 1;
    writeProblem(problem, folder.file("window.cfg"));
    folder.bench("--seed 5 --runs 1 --log moved.log");
    refused("moved.log", {"moved.log has 'hash_of_files VARCHAR = "});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
