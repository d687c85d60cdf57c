// One question asked at many poses: the answers, their times, and how both are printed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"

namespace clearway::cli {

struct Question {
    enum class Kind { kDistance, kCollide, kWithin };
    Kind kind = Kind::kDistance;
    double within = 0;
    DistanceOptions distance;
    bool isCold = false;
    std::optional<std::uint64_t> shuffleSeed;
};

struct Answer {
    DistanceResult distance;       ///< of kDistance
    bool verdict = false;          ///< of the others
    std::int64_t nanoseconds = 0;  ///< the query alone
};

struct QueryRun {
    std::vector<Answer> answers;  ///< in the poses' order
    QueryCounters counters;       ///< summed over all queries
};

/// Asks at every pose, in their order or in the shuffled one, with one workspace. There is at least one pose.
QueryRun ask(const Question& question, const Model& part, const Model& environment,
             const std::vector<Pose>& poses);

/// How many collide or are within, the least and the largest distance.
void printSummary(const Question& question, const QueryRun& run);

/// Queries/s, work per query (volume tests, triangle tests, pairs that needed double and those that needed
/// more), bytes per triangle, build seconds.
void printCosts(const QueryRun& run, const Model& part, const Model& environment);

/// A header and one row a pose, 17 digits. Throws as replaceFile does.
void writeCsv(const Question& question, const QueryRun& run, const std::string& file);

}  // namespace clearway::cli
