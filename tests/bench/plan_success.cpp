// Counts how often and how fast a problem is solved: plans the problem with seeds 1 to N, as `clearway plan`
// does. The oracle re-checks every path at 1,000 interpolated states.
//   bench_plan_success PROBLEM.cfg SEEDS SECONDS OUT.csv [PLANNER [PARAMETER=VALUE...]]
#include <exception>
#include <iostream>
#include <string>

#include "clearway/planning/plan.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "support/oracle.h"
#include "support/path_check.h"

namespace clearway::testing {
namespace {

using planning::PlanOptions;
using planning::PlanReport;

constexpr int kCheckedStates = 1000;

PlanOptions optionsFrom(int count, char** words) {
    PlanOptions options;
    options.seconds = parseNumber(words[3]);
    if (count > 5) options.planner = words[5];
    for (int i = 6; i < count; ++i) {
        const std::string word = words[i];
        const std::size_t equals = word.find('=');
        options.parameters.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
    return options;
}

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
    return all;
}

/// Writes one line of the table, and counts the paths found and the free ones.
std::string rowOf(std::uint32_t seed, const PlanReport& report, double leastByOracle) {
    const bool isFound = report.outcome == PlanReport::Outcome::kFound;
    return std::to_string(seed) + "," + joined(report.planners) + "," + formatNumber(report.range) + "," +
           (isFound ? "1," + report.foundBy : "0,") + "," + formatNumber(report.planningSeconds) + "," +
           formatNumber(report.finishingSeconds) + "," + std::to_string(report.checks) + "," +
           std::to_string(report.statesBefore) + "," + std::to_string(report.path.size()) + "," +
           formatNumber(report.length) + "," + formatNumber(isFound ? report.audit.lowerClearance : 0) + "," +
           formatNumber(leastByOracle) + "\n";
}

int run(int count, char** words) {
    if (count < 5) {
        std::cerr
            << "usage: bench_plan_success PROBLEM.cfg SEEDS SECONDS OUT.csv [PLANNER [PARAMETER=VALUE...]]\n";
        return 2;
    }
    const Problem problem = readProblem(words[1]);
    const auto seeds = static_cast<std::uint32_t>(parseInteger(words[2]).value());
    PlanOptions options = optionsFrom(count, words);
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
    const Scene scene{Model::build(loadPart(problem)), Model::build(loadEnvironment(problem)),
                      problem.margin};

    std::string table =
        "seed,planners,range,found,found_by,planning_seconds,finishing_seconds,checks,states_before,states,"
        "length,"
        "least_clearance,oracle_least\n";
    std::uint32_t solved = 0;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        options.seed = seed;
        const PlanReport report = plan(problem, scene, options);
        double least = 0;
        if (!report.path.empty()) least = leastDistance(oracle, report.path, problem, kCheckedStates);
        solved += least > scene.largestMargin();
        const std::string row = rowOf(seed, report, least);
        std::cout << row << std::flush;
        table += row;
    }
    std::cout << solved << " of " << seeds << " seeds solved, every path re-checked by the oracle\n";
    replaceFile(words[4], [&](std::ostream& out) { out << table; });
    return 0;
}

}  // namespace
}  // namespace clearway::testing

int main(int count, char** words) {
    try {
        return clearway::testing::run(count, words);
    } catch (const std::exception& error) {
        std::cerr << "bench_plan_success: " << error.what() << "\n";
        return 2;
    }
}
