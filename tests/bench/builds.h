// Measures the build time and memory of clearway's trees, relative to FCL's RSS trees built in the same
// round.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/peer.h"

namespace clearway::testing {

struct BuildRow {
    std::string name;             ///< "clearway, 2 threads", or the name of a peer
    std::vector<double> seconds;  ///< one per round
    std::vector<double> ratios;   ///< to FCL RSS in that round; above 1: slower than FCL
    double bytesPerTriangle = 0;  ///< of all memory that both models keep; 0: unknown
};

struct BuildSchedule {
    int rounds = 5;
    double seconds = 60;  ///< a round starts only if it would end within this time, except the first round
};

/// A round builds both models of the task with FCL, and with the options on one thread and on two.
std::vector<BuildRow> measureBuilds(const BenchTask& task, BuildOptions options,
                                    const BuildSchedule& schedule);

/// One build of each peer, without ratios.
std::vector<BuildRow> buildsOf(const std::vector<Peer>& peers, const BenchTask& task);

}  // namespace clearway::testing
