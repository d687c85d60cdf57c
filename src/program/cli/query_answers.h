// The answers of `clearway query`, as facts and as a table of a CSV file.
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
    DistanceResult distance;       ///< the answer of kDistance
    bool verdict = false;          ///< the answer of the other kinds
    std::int64_t nanoseconds = 0;  ///< time of the query alone
};

struct QueryRun {
    std::vector<Answer> answers;  ///< in the poses' order
    QueryCounters counters;       ///< summed over all queries
};

/// Statistics of the answers of distance.
struct DistanceStatistics {
    std::size_t colliding = 0, beyond = 0;   ///< beyond the cap
    std::optional<std::size_t> least, most;  ///< poses; empty when all are beyond the cap
    double widest = 0;                       ///< interval
};

DistanceStatistics statisticsOf(const std::vector<Answer>& answers);

/// How many answers are yes, to a question of another kind than distance.
std::size_t countYes(const QueryRun& run);

double queriesPerSecond(const QueryRun& run);

/// The component's name; empty for a mesh without components.
std::string nameAt(const Model& model, std::int64_t component);

/// Keeps the meshes, the poses and an answer for each among the facts.
void keepAnswers(const Question& question, const std::vector<Pose>& poses, const QueryRun& run,
                 const Model& part, const Model& environment);

/// Writes a header and one row a pose, with 17 digits.
void writeAnswers(const Question& question, const std::vector<Pose>& poses, const QueryRun& run,
                  const Model& part, const Model& environment, const std::string& file);

}  // namespace clearway::cli
