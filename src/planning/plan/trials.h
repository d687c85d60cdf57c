// Trials of planning in changed scenes, each until its first path.
#pragma once

#include <optional>
#include <vector>

#include "clearway/planning/explain.h"
#include "core/clock.h"
#include "planning/plan/plan_setup.h"

namespace clearway::planning {

/// A path that is valid in the scene of its trial.
struct TrialPath {
    std::vector<PartState> path;
    double clearance = 0;  ///< certified, above the margins of the trial's scene
};

class Trials {
  public:
    /// problem: with bounds of its own, so that they do not depend on the obstacles of a trial.
    Trials(const Problem& problem, const ExplainOptions& options);
    Trials(const Trials&) = delete;
    Trials& operator=(const Trials&) = delete;

    /// Plans until the first path, for a share of the whole time. Nothing when no path was found or the time is over.
    std::optional<TrialPath> run(const Scene& scene);

    /// The obstacles that stopped the last trial that found no path, most first.
    const std::vector<Blocker>& blockers() const { return blockers_; }

    bool isOver() const { return options_.isStopped(); }

    /// Lets trials go on until a share of the whole time has passed.
    void allow(double share) { share_ = share; }
    std::size_t count() const { return count_; }
    double secondsOfEach() const { return options_.seconds.value_or(0); }

  private:
    std::optional<TrialPath> foundBy(const PlanSetup& setup);

    Problem problem_;
    PlanOptions options_;
    double seconds_;
    double share_ = 1;
    Clock::time_point begin_;
    std::size_t count_ = 0;
    std::vector<Blocker> blockers_;
};

}  // namespace clearway::planning
