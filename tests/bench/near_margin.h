// Poses whose distance is slightly more or less than a margin, where verdicts are most likely to be wrong.
#pragma once

#include <algorithm>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/clearway_series.h"
#include "support/oracle.h"

namespace clearway::testing {

/// The oracle's distance and the oracle's possible error, which is 0 for contact.
struct Truth {
    double distance;
    double error;
};

Truth askOracle(const MeshOracle& oracle, const BenchTask& task, const Pose& pose);

struct PosesNearMargin {
    double margin = 0;  ///< a length
    std::vector<Pose> poses;
    std::vector<bool> isValid;  ///< by the oracle: whether the true distance is larger than the margin
    int undecided = 0;  ///< poses left out, because they are nearer to the margin than the oracle's error

    int validPoses() const { return static_cast<int>(std::count(isValid.begin(), isValid.end(), true)); }
};

/// Moves `bases` free poses, spread over the task's poses, along the difference of their closest points until
/// the distance is margin (1 +- e), with e from 1e-3 to 1e-12, or the margin itself. For margin 0 (resting
/// contact) the distance is +- e of the scene's size, with e from 1e-4 to 1e-15. Adds the task's poses, whose
/// true distances are `truths`. The oracle decides every pose.
PosesNearMargin posesNearMargin(const BenchTask& task, const TreePair& trees, const MeshOracle& oracle,
                                const std::vector<Truth>& truths, double margin, int bases);

}  // namespace clearway::testing
