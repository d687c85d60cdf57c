#include "program/bench/benchmark.h"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <set>

#include "clearway/planning/ompl_messages.h"
#include "program/bench/benchmark_log.h"
#include "support/processor_time.h"
#include "support/temporary_folder.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::study {
BOOST_AUTO_TEST_SUITE(benchmark_test)

using testing::TemporaryFolder;
using testing::windowScene;

BenchmarkOptions quick() {
    BenchmarkOptions options;
    options.seconds = 5;
    options.runs = 2;
    return options;
}

/// Options for planners that solve the problem within a second. Only a planner that hangs reaches this limit.
BenchmarkOptions patient() {
    BenchmarkOptions options = quick();
    options.seconds = 100;
    return options;
}

Benchmark logOf(const Benchmark& benchmark) {
    const TemporaryFolder folder;
    std::ofstream out(folder.file("a.log"));
    writeBenchmarkLog(benchmark, out);
    out.close();
    return readBenchmarkLog(folder.file("a.log"));
}

BOOST_AUTO_TEST_CASE(every_planner_runs_as_often_as_asked_and_the_log_reads_back) {
    auto window = windowScene();
    window.problem.name = "through a window";
    window.problem.planning.planners = {
        {"rrtconnect"}, {"rrtconnect", {{"name", "RRTC; fine"}, {"range", "5"}}}, {"rrt"}};
    const Benchmark benchmark = runBenchmark(window.problem, window.scene, patient());
    BOOST_TEST(benchmark.isComplete());
    const Benchmark log = logOf(benchmark);
    BOOST_TEST(log.experiment == "through_a_window");
    BOOST_TEST(log.options.seed == 1u);
    BOOST_TEST(log.options.seconds == 100);
    BOOST_TEST(log.options.megabytes == 4096);
    BOOST_TEST(log.options.runs == 2);
    BOOST_TEST(log.parameters.count("margin REAL") == 1u);
    BOOST_TEST_REQUIRE(log.planners.size() == 3u);
    BOOST_TEST(log.planners[0].name == "geometric_RRTConnect");
    BOOST_TEST(log.planners[1].name == "geometric_RRTC; fine");
    BOOST_TEST(log.planners[1].settings.at("range") == "5");
    BOOST_TEST(log.planners[0].settings.at("range") != "5");
    BOOST_TEST(log.planners[2].name == "geometric_RRT");
    for (const auto& planner : log.planners) {
        BOOST_TEST_REQUIRE(planner.runs.size() == 2u);
        for (const auto& run : planner.runs) {
            const Properties& values = run.properties;
            BOOST_TEST(values.at("solved BOOLEAN") == "1");
            BOOST_TEST(values.at("status ENUM") == "6");
            BOOST_TEST(values.at("correct solution strict BOOLEAN") == "1");
            BOOST_TEST(values.at("simplified correct solution strict BOOLEAN") == "1");
            BOOST_TEST(std::stod(values.at("least clearance REAL")) > 0);
            BOOST_TEST(std::stod(values.at("time REAL")) > 0);
            BOOST_TEST(std::stod(values.at("time REAL")) <= benchmark.seconds);
            BOOST_TEST(std::stod(values.at("state checks INTEGER")) > 0);
            BOOST_TEST(std::stod(values.at("motion queries INTEGER")) > 0);
            BOOST_TEST(std::stod(values.at("valid motions INTEGER")) > 0);
            BOOST_TEST(std::stod(values.at("simplified solution length REAL")) <=
                       std::stod(values.at("solution length REAL")));
        }
        BOOST_TEST(planner.runs[0].properties.at("seed INTEGER") == "1");
        BOOST_TEST(planner.runs[1].properties.at("seed INTEGER") == "2");
    }
}

BOOST_AUTO_TEST_CASE(the_same_seeds_give_the_same_paths) {
    auto window = windowScene();
    window.problem.planning.planners = {{"rrtconnect"}, {"rrt"}};
    BenchmarkOptions options = patient();
    options.seed = 7;
    const Benchmark first = runBenchmark(window.problem, window.scene, options);
    const Benchmark second = runBenchmark(window.problem, window.scene, options);
    for (std::size_t i = 0; i < first.planners.size(); ++i) {
        for (std::size_t run = 0; run < 2; ++run) {
            const BenchmarkRun &a = first.planners[i].runs[run], &b = second.planners[i].runs[run];
            BOOST_TEST(a.isSolved);
            BOOST_TEST(a.length == b.length);
        }
        BOOST_TEST(first.planners[i].runs[0].length != first.planners[i].runs[1].length);
    }
}

BOOST_AUTO_TEST_CASE(with_iterations_a_run_alone_gives_the_values_that_it_gives_among_others) {
    auto window = windowScene();
    window.problem.planning.planners = {{"rrtconnect"}, {"rrtstar"}};  // RRTstar uses up its iterations
    BenchmarkOptions options = quick();
    options.iterations = 300;
    options.seconds = 1e-3;  // does not count
    const Benchmark all = runBenchmark(window.problem, window.scene, options);
    const planning::OmplMessages unobserved;
    const DoRun doRun = runsOf(window.problem, window.scene, options);
    for (const std::size_t number : {3u, 0u, 2u, 1u}) {
        const auto alone = doRun(number);
        BOOST_TEST_REQUIRE(alone.has_value());
        BOOST_TEST(alone->number == number);
        const BenchmarkRun& among = all.planners.at(number / 2).runs.at(number % 2);
        BOOST_TEST(seedOf(among) == 1 + number % 2);
        for (const char* name : {"seed INTEGER", "status ENUM", "state checks INTEGER",
                                 "motion queries INTEGER", "graph states INTEGER", "solution length REAL"}) {
            BOOST_TEST(alone->run.properties.at(name) == among.properties.at(name),
                       name << " of run " << number);
        }
    }
    BOOST_TEST(std::stod(all.planners[1].runs[0].properties.at("graph states INTEGER")) > 50);
    const Benchmark log = logOf(all);
    BOOST_TEST(log.parameters.at("iterations INTEGER") == "300");
    BOOST_TEST(std::isinf(log.options.seconds));
    options.iterations = 3;
    const auto few = runBenchmark(window.problem, window.scene, options).planners[1].runs[0];
    BOOST_TEST(std::stod(few.properties.at("graph states INTEGER")) < 50);
}

BOOST_AUTO_TEST_CASE(planners_that_tell_of_their_progress_have_it_in_the_log) {
    auto window = windowScene();
    window.problem.planning.planners = {{"rrtstar"}};
    BenchmarkOptions options = quick();
    options.simplify = false;
    const Benchmark log = testing::withProcessorTime(1, [&](double seconds) {  // for two runs
        options.seconds = seconds / 2;
        return logOf(runBenchmark(window.problem, window.scene, options));
    });
    BOOST_TEST_REQUIRE(log.planners.size() == 1u);
    BOOST_TEST_REQUIRE(log.planners[0].runs.size() == 2u);
    for (const BenchmarkRun& run : log.planners[0].runs) {
        BOOST_TEST_REQUIRE(run.progress.size() >= 3u);
        double before = 0;
        for (const auto& moment : run.progress) {
            BOOST_TEST(std::stod(moment.at("time REAL")) > before);
            before = std::stod(moment.at("time REAL"));
            BOOST_TEST(moment.count("best cost REAL") == 1u);
        }
    }
    BOOST_TEST(log.planners[0].runs[0].properties.count("simplification time REAL") == 0u);
}

BOOST_AUTO_TEST_CASE(a_planner_without_a_path_ends_at_its_limit_of_time_or_memory) {
    auto window = windowScene();
    const Scene closed{Model::build(window.partMesh), Model::build(window.wallMesh), 12};  // half its height
    window.problem.planning.planners = {{"rrt"}};
    BenchmarkOptions options = quick();
    options.runs = 1;
    options.seconds = 0.3;
    const Properties timed = runBenchmark(window.problem, closed, options).planners[0].runs[0].properties;
    BOOST_TEST(std::stod(timed.at("time REAL")) >= 0.3);
    BOOST_TEST(timed.at("solved BOOLEAN") == "0");
    BOOST_TEST(timed.count("simplified solution length REAL") == timed.count("solution length REAL"));

    const RunLimits full{/*seconds*/ 1000, /*bytes*/ 1, false, {}};  // ends within seconds, or ctest gives up
    planning::PlanOptions one;
    one.threads = 1;
    std::vector<std::string> warnings;
    const auto run = runOnce(window.problem, closed, one, full, warnings);
    BOOST_TEST_REQUIRE(run.has_value());
    BOOST_TEST(run->properties.at("solved BOOLEAN") == "0");
}

BOOST_AUTO_TEST_CASE(stopped_it_keeps_the_runs_that_have_ended) {
    auto window = windowScene();
    window.problem.planning.planners = {{"rrtconnect"}, {"est"}};
    BenchmarkOptions options = quick();
    int begun = 0;
    options.tell = [&](const BenchmarkProgress& at) {
        begun = at.run + 1;
        BOOST_TEST(at.runs == 4);
        BOOST_TEST(at.left > 0);
    };
    std::size_t kept = 0;
    options.keep = [&](const Benchmark& soFar) {
        ++kept;
        BOOST_TEST(soFar.planners[0].runs.size() + soFar.planners[1].runs.size() == kept);
    };
    options.isStopped = [&] { return begun == 4; };
    const Benchmark benchmark = runBenchmark(window.problem, window.scene, options);
    BOOST_TEST(!benchmark.isComplete());
    const Benchmark log = logOf(benchmark);
    BOOST_TEST(log.planners[0].runs.size() == 2u);
    BOOST_TEST(log.planners[1].runs.size() == 1u);
    BOOST_TEST(kept == 3u);
    BOOST_TEST(missingSeeds(benchmark.planners[0], benchmark).empty());
    BOOST_TEST(missingSeeds(benchmark.planners[1], benchmark) == std::set<std::uint32_t>{2},
               boost::test_tools::per_element());
    options.isStopped = [] { return true; };
    for (const auto& planner : logOf(runBenchmark(window.problem, window.scene, options)).planners) {
        BOOST_TEST(planner.runs.empty());
    }
}

BOOST_AUTO_TEST_CASE(settings_for_one_planner_are_its_own) {
    auto window = windowScene();
    window.problem.planning.settings = {{"longest_valid_segment_fraction", "0.02"}, {"no_such", "1"}};
    window.problem.planning.planners = {{"rrt"},
                                        {"rrtconnect", {}, {{"longest_valid_segment_fraction", "0.05"}}},
                                        {"kpiece", {}, {{"projection.cellsize_factor", "2"}}},
                                        {"prm", {}, {{"sampler", "gaussian"}, {"standard_deviation", "20"}}}};
    BenchmarkOptions options = quick();
    options.runs = 1;
    options.seconds = 0.2;
    const Benchmark benchmark = runBenchmark(window.problem, window.scene, options);
    const auto setting = [&](std::size_t planner, const char* name) {
        return benchmark.planners[planner].settings.at(name);
    };
    BOOST_TEST(setting(0, "longest_valid_segment_fraction") == "0.02");
    BOOST_TEST(setting(1, "longest_valid_segment_fraction") == "0.05");
    const auto cell = [&](std::size_t planner) {
        return std::stod(setting(planner, "projection.cellsize.0"));
    };
    BOOST_TEST(cell(2) == 2 * cell(0), boost::test_tools::tolerance(1e-5));
    BOOST_TEST_REQUIRE(benchmark.warnings.size() == 1u);
    BOOST_TEST(testing::holds(benchmark.warnings[0], "'no_such'"));
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_any_planner_is_refused_before_the_first_run) {
    auto window = windowScene();
    BenchmarkOptions options = quick();
    options.tell = [](const BenchmarkProgress&) { BOOST_ERROR("a run has begun"); };
    const auto refused = [&](const PlannerChoice& last, const std::vector<std::string>& words) {
        window.problem.planning.planners = {{"rrtconnect"}, last};
        testing::requireRefusedBy([&] { runBenchmark(window.problem, window.scene, options); }, words);
    };
    refused({"nonesuch"}, {"unknown planner 'nonesuch'"});
    refused({"rrt", {{"range", "far"}}}, {"'far'", "a number"});
    refused({"prm", {}, {{"sampler", "lucky"}}}, {"unknown sampler 'lucky'"});
}

BOOST_AUTO_TEST_CASE(the_log_keeps_its_form_whatever_values_hold) {
    Benchmark benchmark;
    benchmark.experiment = "x";
    benchmark.setup = "two\nlines";
    benchmark.started = "2026-01-02 03:04:05";
    benchmark.planners.resize(2);
    benchmark.planners[0].name = "odd";
    benchmark.planners[0].settings = {{"a", "b = c\nd"}};
    benchmark.planners[0].progressNames = {"best cost REAL", "time REAL"};
    BenchmarkRun run;
    run.properties = {{"time REAL", "1"}, {"note VARCHAR", "x; y\nz"}};
    run.progress = {{{"time REAL", "0.1"}, {"best cost REAL", "1,5;"}}, {{"time REAL", "0.2"}}};
    BenchmarkRun other;
    other.properties = {{"note VARCHAR", "-inf"}};
    benchmark.planners[0].runs = {run, other};
    benchmark.planners[1].name = "none";
    const Benchmark log = logOf(benchmark);
    BOOST_TEST(log.setup == "two\nlines\n");
    BOOST_TEST(log.planners[0].settings.at("a") == "b = c d");
    const std::vector<BenchmarkRun>& runs = log.planners[0].runs;
    BOOST_TEST(runs[0].properties.at("note VARCHAR") == "x, y z");
    BOOST_TEST(runs[1].properties.empty());
    BOOST_TEST(runs[0].progress[0].at("best cost REAL") == "1 5 ");
    BOOST_TEST(runs[0].progress[1].count("best cost REAL") == 0u);
    BOOST_TEST(runs[1].progress.empty());
    BOOST_TEST(log.planners[1].runs.empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::study
