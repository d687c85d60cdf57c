// The figures of a scene as text for people and as CSV files.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/builds.h"
#include "bench/clearway_series.h"
#include "bench/judge.h"

namespace clearway::testing {

/// All that was measured of one scene.
struct BenchReport {
    const BenchTask& task;
    const std::vector<Series>& all;  ///< clearway's plain distances first
    const Judgement& judgement;
    const std::vector<BuildRow>& builds;
};

void printReport(std::ostream& out, const BenchReport& report);

/// Rows of comparisons(): ratio of times with its least and largest over the repetitions, time and work of a
/// query on both sides, and how many answers were wrong on both sides.
std::string summaryHeader();
std::string summaryRows(const BenchReport& report);

std::string buildsHeader();
std::string buildsRows(const BenchReport& report);

/// One row a pose: true distance, who said so, clearway's interval, then each series' answer and median time
/// in ns, and clearway's node visits.
std::string posesTable(const BenchReport& report);

}  // namespace clearway::testing
