#include "planning/paths/shorten.h"

#include <ompl/geometric/PathSimplifier.h>

#include "planning/validity/ompl_version.h"

namespace clearway::planning {
namespace {

constexpr int kMostRounds = 200;
constexpr int kIdleRounds = 8;  ///< so many in a row without gain end it
constexpr double kGain = 1e-3;  ///< of the length; less is no gain
constexpr unsigned int kSteps =
    12;  ///< motions tried by each part of a round: small, so that a stop is heeded soon

}  // namespace

void shorten(ompl::geometric::PathGeometric& path, const std::function<bool()>& isSpent) {
    ompl::geometric::PathSimplifier simplifier(path.getSpaceInformation());
    int idle = 0;
    for (int round = 0; round < kMostRounds && idle < kIdleRounds && !isSpent(); ++round) {
        const double before = path.length();
        simplifier.reduceVertices(path, kSteps, kSteps);
        if (isSpent()) return;
        shortcutPath(simplifier, path, kSteps, kSteps);
        idle = path.length() < before * (1 - kGain) ? 0 : idle + 1;
    }
}

}  // namespace clearway::planning
