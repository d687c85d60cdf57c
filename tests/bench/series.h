// A series is one question to one engine at every pose of a set, timed pass after pass.
//
// All series of a scene run in one process and take turns: each repetition is one pass of every series. A
// pass begins with an untimed lead-in, which brings the engine's trees back into the caches after the other
// engines' passes. Every query is timed by itself; its time includes two readings of the clock.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/peer.h"

namespace clearway::testing {

enum class Question { kDistance, kCollides, kIsWithin };

struct Series {
    // The question.
    Question question = Question::kDistance;
    double within = 0;   ///< the d of kIsWithin
    std::string asked;   ///< series with equal texts are compared: "distance", "distance, shuffled", ...
    std::string engine;  ///< "clearway", "PQP, cold", ...
    bool isClearway = false;
    std::vector<std::size_t> order;  ///< order of the poses

    // The engine. Either ask or askAll is set. askAll gets the poses several times over, because batches are
    // long; its time is divided evenly among the poses.
    std::function<Answer(const Pose&)> ask;
    std::function<std::vector<Answer>(const std::vector<Pose>&)> askAll;
    std::function<void()> beforePass;   ///< not timed; may be empty
    std::function<void()> beforeQuery;  ///< not timed; may be empty

    // The results, by pose, whatever the order.
    std::vector<Answer> answers;
    std::vector<std::vector<double>> nanoseconds;  ///< [repetition][pose]

    double total(std::size_t repetition) const;  ///< nanoseconds of a pass
    std::vector<double> medians() const;         ///< median of each pose over the repetitions
};

struct Schedule {
    int repetitions = 5;
    /// Seconds for each series of a peer. The peer runs only as many repetitions as fit in, judged by its
    /// first pass, but at least one.
    double peerBudget = 60;
    double leadIn = 0.02;  ///< at most so many seconds and at most one pass
    int cpu = -1;          ///< passes of one thread keep to this CPU; -1: any
};

/// The numbers 0 to count - 1: poses in path order.
std::vector<std::size_t> inOrder(std::size_t count);

/// Runs every series once without counting it, then the repetitions.
void runAll(std::vector<Series>& all, const std::vector<Pose>& poses, const Schedule& schedule);

/// Time of `theirs` divided by time of `ours`, one value per repetition that both have run.
std::vector<double> ratios(const Series& ours, const Series& theirs);

/// The nanoseconds that reading the clock adds to every query's time.
double clockNanoseconds();

double median(std::vector<double> values);
double least(const std::vector<double>& values);
double largest(const std::vector<double>& values);
double mean(const std::vector<double>& values);

}  // namespace clearway::testing
