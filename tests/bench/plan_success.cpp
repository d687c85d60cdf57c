// Counts how often and how fast problems are solved: plans each problem with seeds 1 to N, as `clearway plan` does. The
// oracle checks poses of every path, outside the times.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "program/options/command_line.h"
#include "program/options/print.h"
#include "support/oracle.h"
#include "support/path_check.h"

namespace clearway::testing::plan_success {

using planning::PlanOptions;
using planning::PlanReport;

struct Choices {
    std::vector<std::string> problems;
    PlanOptions plan;
    std::uint32_t seeds = 20;
    int oracleStates = 100;
    std::string out;
};

bool readChoices(int count, char** words, Choices& to) {
    cli::CommandLine line(
        "benchmarks plan_success [PROBLEM.cfg...] [options]",
        "Plans each problem with several seeds and prints a line for each run, then medians.");
    line.argument("[PROBLEM.cfg...]", cli::appendedTo(to.problems));
    line.option("--seeds N", "each problem is planned with seeds 1 to N (20)",
                cli::integer<std::uint32_t>(to.seeds, 1, UINT32_MAX));
    line.option("--time S", "seconds of each run (30)", cli::positive(to.plan.seconds));
    line.option("--iterations N", "in place of --time",
                cli::integer<std::uint64_t>(to.plan.iterations, 1, INT64_MAX));
    line.exclude("--time", "--iterations");
    line.option("--planner NAME", "a planner's name (PlannerTeam, or the objective's)",
                cli::to(to.plan.planner));
    line.option("--threads N", "planners side by side (one a core, at most 4)",
                cli::integer<int>(to.plan.threads, 1, 256));
    line.option("--objective NAME", "an objective's name (none)", cli::to(to.plan.objective));
    line.flag("--quick", "takes the first path: makes no room", to.plan.quick);
    line.option("--oracle-states N", "poses of each path that the oracle is asked about (100)",
                cli::integer<int>(to.oracleStates, 1, INT32_MAX));
    line.option("--out FILE", "table of all runs, CSV", cli::to(to.out));
    if (!line.parse({words + 1, words + count})) return false;
    if (to.problems.empty()) throw std::invalid_argument("no PROBLEM.cfg is given, expected at least one");
    return true;
}

struct Run {
    std::uint32_t seed = 1;
    PlanReport report;
    int colliding = 0;  ///< poses, by the oracle

    bool isFound() const { return report.outcome == PlanReport::Outcome::kFound; }
};

constexpr const char* kHeader =
    "problem,seed,found,found_by,planning_seconds,room_seconds,finishing_seconds,states_checked,room_before,"
    "room_after,"
    "least_clearance,cost,rotation_degrees,length,states,colliding_by_oracle\n";

std::string rowOf(const std::string& problem, const Run& run) {
    const PlanReport& report = run.report;
    const planning::WideningReport room = report.widening.value_or(planning::WideningReport{});
    std::string row = problem + "," + std::to_string(run.seed) + "," + (run.isFound() ? "1," : "0,");
    std::string by = report.foundBy;
    std::replace(by.begin(), by.end(), ',', ';');
    row += by;
    for (const double value :
         {report.planningSeconds, room.seconds, report.finishingSeconds, static_cast<double>(report.checks),
          room.before, room.after, run.isFound() ? report.audit.lowerClearance : 0, report.cost,
          report.rotation * 180 / M_PI, report.length, static_cast<double>(report.path.size()),
          static_cast<double>(run.colliding)}) {
        row += "," + shortNumber(value);
    }
    return row + "\n";
}

/// The value in the middle; runs without a path count as infinite.
template <class Value>
double medianOf(const std::vector<Run>& runs, const Value& value) {
    std::vector<double> values;
    for (const Run& run : runs) {
        values.push_back(run.isFound() ? value(run.report) : std::numeric_limits<double>::infinity());
    }
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void printMedians(const std::string& problem, const std::vector<Run>& runs) {
    double worst = 0;
    int found = 0, colliding = 0;
    for (const Run& run : runs) {
        if (run.isFound()) worst = std::max(worst, run.report.planningSeconds);
        found += run.isFound();
        colliding += run.colliding > 0;
    }
    const auto median = [&](auto value) { return cli::shortened(medianOf(runs, value)); };
    std::cout << problem << ": " << found << " of " << runs.size() << " found, " << colliding
              << " refuted by the oracle; medians: planning "
              << median([](auto& r) { return r.planningSeconds; }) << " s (worst " << shortNumber(worst)
              << "), clearance " << median([](auto& r) { return r.audit.lowerClearance; }) << ", turned "
              << median([](auto& r) { return r.rotation * 180 / M_PI; }) << " degrees\n";
}

std::vector<Run> planAll(const Choices& choices, const std::string& file, const std::string& name,
                         std::string& table) {
    const Problem problem = readProblem(file);
    const Scene scene = loadScene(problem).scene;
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
    std::vector<Run> runs;
    for (std::uint32_t seed = 1; seed <= choices.seeds; ++seed) {
        PlanOptions options = choices.plan;
        options.seed = seed;
        Run run{seed, plan(problem, scene, options)};
        if (run.isFound())
            run.colliding = collisionsAlong(oracle, run.report.path, problem, choices.oracleStates);
        const std::string row = rowOf(name, run);
        std::cout << row << std::flush;
        table += row;
        runs.push_back(std::move(run));
    }
    return runs;
}

int run(int count, char** words) {
    Choices choices;
    if (!readChoices(count, words, choices)) return 0;
    std::string table = kHeader;
    std::cout << table;
    std::vector<std::pair<std::string, std::vector<Run>>> all;
    for (const std::string& file : choices.problems) {
        const std::filesystem::path path = std::filesystem::absolute(file);
        const std::string name = path.parent_path().filename().string() + "/" + path.stem().string();
        all.emplace_back(name, planAll(choices, file, name, table));
        // So that nothing is lost when the run is stopped.
        if (!choices.out.empty()) replaceFile(choices.out, [&](std::ostream& out) { out << table; });
    }
    for (const auto& [name, runs] : all) printMedians(name, runs);
    return 0;
}

}  // namespace clearway::testing::plan_success
