// The figures of a scene as rows of CSV files.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/builds.h"
#include "bench/clearway_series.h"
#include "bench/judge.h"

namespace clearway::testing {

/// All measurements of one scene.
struct BenchReport {
    const BenchTask& task;
    const std::vector<Series>& all;  ///< clearway's plain distances first
    const Judgement& judgement;
    const std::vector<BuildRow>& builds;
};

/// Writes the rows of comparisons(): the ratio of times with its least and largest value over the
/// repetitions; then for both sides the time and work of a query and the number of wrong answers.
std::string summaryHeader();
std::string summaryRows(const BenchReport& report);

std::string buildsHeader();
std::string buildsRows(const BenchReport& report);

/// Writes one row per pose: the true distance and who decided it, clearway's interval, the answer and median
/// time in ns of each series, and clearway's node visits.
std::string posesTable(const BenchReport& report);

}  // namespace clearway::testing
