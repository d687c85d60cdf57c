// Poses whose distance is a hair more or a hair less than a margin: where a verdict goes wrong, if it does.
#pragma once

#include <vector>

#include "bench/bench_scenes.h"
#include "bench/clearway_series.h"
#include "support/oracle.h"

namespace clearway::testing {

/// The oracle's word and how far it may be off: nothing for contact.
struct Truth {
    double distance;
    double error;
};

Truth askOracle(const MeshOracle& oracle, const BenchTask& task, const Pose& pose);

struct PosesNearMargin {
    double margin = 0;  ///< a length
    std::vector<Pose> poses;
    std::vector<bool> isValid;  ///< whether the true distance is larger than the margin, by the oracle
    int undecided = 0;          ///< poses left out: nearer to the margin than the oracle's own error

    int validPoses() const;
};

/// From `bases` free poses spread over the task's, each moved along its closest points' difference until the
/// distance is margin (1 +- e), e from 1e-3 to 1e-12, and the margin itself; for margin 0 (resting contact)
/// +- e of the scene's size, e from 1e-4 to 1e-15. And the task's poses with their true distances. Truth is
/// the oracle's at every pose. truths: of the task's poses.
PosesNearMargin posesNearMargin(const BenchTask& task, const TreePair& trees, const MeshOracle& oracle,
                                const std::vector<Truth>& truths, double margin, int bases);

}  // namespace clearway::testing
