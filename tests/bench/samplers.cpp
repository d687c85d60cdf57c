// Measures how much each sampler of valid states helps a roadmap: plans problems by PRM with each sampler and
// seeds 1 to N, and writes how many paths were found and how soon.
//   benchmarks samplers PROBLEM.cfg SEEDS SECONDS OUT.csv [SAMPLER...]
#include <iostream>
#include <string>
#include <vector>

#include "bench/series.h"
#include "clearway/planning/plan.h"
#include "core/number.h"
#include "core/replace_file.h"

namespace clearway::testing::samplers {

using planning::PlanReport;

const std::vector<std::string> kSamplers = {"uniform", "gaussian", "bridge_test", "contact_normal",
                                            "narrow_gap"};

int run(int count, char** words) {
    if (count < 5) {
        std::cerr << "usage: benchmarks samplers PROBLEM.cfg SEEDS SECONDS OUT.csv [SAMPLER...]\n";
        return 2;
    }
    Problem problem = readProblem(words[1]);
    const auto seeds = static_cast<std::uint32_t>(parseInteger(words[2]).value());
    const Scene scene(Model::build(loadPart(problem)), Model::build(loadEnvironment(problem)),
                      problem.margin);
    planning::PlanOptions options;
    options.planner = "PRM";
    options.seconds = parseNumber(words[3]);

    std::string table = "sampler,seed,found,planning_seconds,checks,length,least_clearance\n";
    const std::vector<std::string> asked(words + 5, words + count);
    for (const std::string& sampler : asked.empty() ? kSamplers : asked) {
        problem.planning.sampler = sampler;
        std::vector<double> seconds;
        int found = 0;
        for (options.seed = 1; options.seed <= seeds; ++options.seed) {
            const PlanReport report = plan(problem, scene, options);
            const bool isFound = report.outcome == PlanReport::Outcome::kFound;
            found += isFound;
            seconds.push_back(isFound ? report.planningSeconds : *options.seconds);
            table += sampler + "," + std::to_string(options.seed) + "," + (isFound ? "1" : "0") + "," +
                     formatNumber(report.planningSeconds) + "," + std::to_string(report.checks) + "," +
                     formatNumber(report.length) + "," +
                     formatNumber(isFound ? report.audit.lowerClearance : 0) + "\n";
        }
        std::cout << sampler << ": " << found << " of " << seeds << " found, median " << median(seconds)
                  << " s\n"
                  << std::flush;
    }
    replaceFile(words[4], [&](std::ostream& out) { out << table; });
    return 0;
}

}  // namespace clearway::testing::samplers
