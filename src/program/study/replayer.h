// Asks again what planners asked, of a scene of other trees, through the same checker, validator and
// objective.
#pragma once

#include <memory>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/study/calls.h"

namespace clearway::study {

/// What a call answered. kUndecided: a motion in which no invalid pose was found, but not all are certified.
enum class CallAnswer : char { kNo = 'n', kYes = 'y', kUndecided = 'u' };

struct ReplayedCalls {
    std::vector<std::vector<CallAnswer>> answers;  ///< of each block's calls
    std::vector<planning::QueryTally> tallies;     ///< of each block
};

/// X_environmentPart at the states of calls, in their order. Throws std::invalid_argument when a state has
/// not as many reals as the problem's space.
std::vector<Pose> posesOf(const Problem& problem, const std::vector<CallBlock>& blocks);

class Replayer {
  public:
    /// Motions' costs are those of the objective max_min_clearance. Throws as plan() does.
    Replayer(const Problem& problem, const Scene& scene);
    ~Replayer();
    Replayer(Replayer&&) noexcept;

    /// Throws std::invalid_argument when a state has not as many reals as the problem's space.
    ReplayedCalls replay(const std::vector<CallBlock>& blocks);

    /// The same without a look at the work. returns the processor's seconds of each block.
    std::vector<double> time(const std::vector<CallBlock>& blocks);

  private:
    struct Tools;
    std::unique_ptr<Tools> tools_;
};

}  // namespace clearway::study
