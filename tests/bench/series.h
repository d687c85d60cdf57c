// One thing that is timed: a question put to one engine at every pose of a set, pass after pass.
//
// All series of a scene run in one process and take turns: each repetition is one pass of every series. A
// pass begins with an untimed lead-in, in which the engine finds its trees in the caches again after the
// others have been through them. Every query is timed by itself, two readings of the clock included.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/peer.h"

namespace clearway::testing {

enum class Question { kDistance, kCollides, kIsWithin };

struct Series {
    // What is asked.
    Question question = Question::kDistance;
    double within = 0;   ///< d of kIsWithin
    std::string asked;   ///< rows are compared that have the same: "distance", "distance, shuffled", ...
    std::string engine;  ///< "clearway", "PQP, cold", ...
    bool isClearway = false;
    std::vector<std::size_t> order;  ///< of the poses

    // How. One of ask and askAll is there. askAll is given the poses several times over, as long batches are;
    // its time is spread evenly.
    std::function<Answer(const Pose&)> ask;
    std::function<std::vector<Answer>(const std::vector<Pose>&)> askAll;
    std::function<void()> beforePass;   ///< not timed; may be empty
    std::function<void()> beforeQuery;  ///< not timed; may be empty

    // What came of it, by pose whatever the order.
    std::vector<Answer> answers;
    std::vector<std::vector<double>> nanoseconds;  ///< [repetition][pose]

    double total(std::size_t repetition) const;  ///< nanoseconds of a pass
    std::vector<double> medians() const;         ///< of each pose over the repetitions
};

struct Schedule {
    int repetitions = 5;
    /// An engine other than clearway runs only as many of the repetitions as end within so many seconds, by
    /// the time of its first pass; but at least one.
    double peerBudget = 60;
    double leadIn = 0.02;  ///< seconds at most, and one pass at most
    int cpu = -1;          ///< the thread is kept on this CPU during passes of one thread; -1: on any
};

/// Every series once without counting, then the repetitions.
void runAll(std::vector<Series>& all, const std::vector<Pose>& poses, const Schedule& schedule);

/// Time of `theirs` over time of `ours`, one value a repetition that both have run.
std::vector<double> ratios(const Series& ours, const Series& theirs);

/// What the clock adds to every query's time, in nanoseconds.
double clockNanoseconds();

double median(std::vector<double> values);
double mean(const std::vector<double>& values);

}  // namespace clearway::testing
