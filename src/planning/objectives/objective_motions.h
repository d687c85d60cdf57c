// What the clearance objectives look at: a scene, and motions of the part in it, each in one direction.
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Console.h>

#include <atomic>
#include <exception>
#include <memory>
#include <optional>

#include "clearway/planning/clearance_objectives.h"
#include "planning/motion/motion.h"
#include "planning/validity/scene_clearance.h"

namespace clearway::planning {

class ObjectiveMotions {
  public:
    /// Both throw as ClearanceObjective does.
    ObjectiveMotions(const ompl::base::SpaceInformationPtr& si, Scene scene);
    ObjectiveMotions(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                     DisplacementBound bound);

    const Scene& scene() const { return clearance_.scene(); }
    double mostClearance() const { return clearance_.mostClearance(); }
    double leastInterval() const { return leastInterval_; }

    /// Up to the cap; nothing when the state is invalid. Throws what queries and callbacks throw.
    std::optional<double> clearanceAt(const ompl::base::State* state, double cap) const;

    /// cost(motion), the motion being in the one direction in which it is looked at, whichever the first
    /// state is, and without a warm start; `otherwise` when that is nothing or throws.
    template <class CostOfMotion>
    double costOfMotion(const ompl::base::State* s1, const ompl::base::State* s2, double otherwise,
                        const CostOfMotion& cost) const {
        motions_.fetch_add(1, std::memory_order_relaxed);
        try {
            Motion motion = motionBetween(s1, s2);
            const std::optional<double> found = cost(motion);
            queries_.fetch_add(motion.queries(), std::memory_order_relaxed);
            if (!found) invalid_.fetch_add(1, std::memory_order_relaxed);
            return found.value_or(otherwise);
        } catch (const std::exception& error) {
            return unusable(error.what(), otherwise);
        }
    }

    /// cost(clearance) at a state up to the cap; `otherwise` when the state is invalid or has no pose.
    template <class CostOfClearance>
    double costOfState(const ompl::base::State* state, double cap, double otherwise,
                       const CostOfClearance& cost) const {
        try {
            const std::optional<double> clearance = clearanceAt(state, cap);
            return clearance ? cost(*clearance) : otherwise;
        } catch (const std::exception& error) {
            return unusable(error.what(), otherwise);
        }
    }

    ObjectiveCounters counters() const;

  private:
    Motion motionBetween(const ompl::base::State* s1, const ompl::base::State* s2) const;
    double unusable(const char* reason, double cost) const;

    ompl::base::SpaceInformationPtr si_;
    SceneClearance clearance_;
    StateToPose stateToPose_;
    DisplacementBound bound_;
    double leastInterval_;
    bool areBoundsConvex_ = false;
    mutable std::atomic<std::uint64_t> motions_{0}, invalid_{0}, unusable_{0}, queries_{0};
    mutable std::atomic<bool> isLogged_{false};
};

}  // namespace clearway::planning
