// Build time and memory of clearway's trees, over FCL's RSS trees built in the same round.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/peer.h"

namespace clearway::testing {

struct BuildRow {
    std::string name;             ///< "clearway best, 2 threads", or a peer's
    std::vector<double> seconds;  ///< one a round
    std::vector<double> ratios;   ///< over FCL RSS of that round: more than 1 is slower than FCL
    double bytesPerTriangle = 0;  ///< all that is kept, of both models; 0 when unknown
};

struct BuildSchedule {
    int rounds = 5;
    double seconds = 60;  ///< no round begins that would end later, but one is always run
};

/// Named options to build with.
struct BuildChoice {
    std::string name;
    BuildOptions options;
};

/// Every preset, and "chosen" when the options are none of them; thread counts apart.
std::vector<BuildChoice> buildChoices(const BuildOptions& chosen);

/// A round builds both models of the task with FCL and with each choice on one thread and on two.
std::vector<BuildRow> measureBuilds(const BenchTask& task, const std::vector<BuildChoice>& choices,
                                    const BuildSchedule& schedule);

/// The peers' one build, without ratios.
std::vector<BuildRow> buildsOf(const std::vector<Peer>& peers, const BenchTask& task);

}  // namespace clearway::testing
