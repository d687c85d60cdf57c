// Replays recorded calls in a scene with other trees, through a checker and a validator of the planner's kinds.
#pragma once

#include <memory>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "clearway/scene_clearance.h"
#include "demos/study/calls.h"

namespace clearway::study {

struct ReplayedCalls {
    Answers answers;
    std::vector<QueryTally> tallies;  ///< of each block
};

/// X_environmentPart at the states of the calls, in order. Throws std::invalid_argument when a state has not
/// as many reals as the problem's space.
std::vector<Pose> posesOf(const Problem& problem, const std::vector<CallBlock>& blocks);

class Replayer {
  public:
    /// Makes a checker and a motion validator. Throws as plan() does.
    Replayer(const Problem& problem, const Scene& scene);
    ~Replayer();
    Replayer(Replayer&&) noexcept;

    /// Throws std::invalid_argument when a state has not as many reals as the problem's space.
    ReplayedCalls replay(const std::vector<CallBlock>& blocks);

    /// Asks the calls without counting their work. Returns each block's processor seconds.
    std::vector<double> time(const std::vector<CallBlock>& blocks);

  private:
    struct Tools;
    std::unique_ptr<Tools> tools_;
};

}  // namespace clearway::study
