// One run of one planner in a benchmark.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/planning/plan.h"
#include "program/study/benchmark.h"

namespace clearway::study {

struct RunLimits {
    double seconds = 0;
    unsigned long long bytes = 0;  ///< of the whole process
    bool simplify = true;
    std::function<bool()> isStopped;
    std::optional<CallSampling> trace =
        {};  ///< counts and times the planner's queries, and samples its calls
};

/// Plans the problem, which names one planner, with that planner and the options' seed. Nothing when it was
/// stopped. A planner that throws has status "Crash" and a warning. Throws what makePlanSetup() throws.
std::optional<BenchmarkRun> runOnce(const Problem& problem, const Scene& scene,
                                    const planning::PlanOptions& options, const RunLimits& limits,
                                    std::vector<std::string>& warnings);

}  // namespace clearway::study
