// A shared scene in one space, with counts of the answers: what a checker, a motion validator and an objective have in common.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <array>
#include <atomic>
#include <cstdint>

#include "clearway/planning/shared_scene.h"

namespace clearway::planning {

/// Answers that are counted. Each class counts only what its own counters report.
enum class Count { kAsked, kValid, kInvalid, kUndecided, kInvalidStarts, kOutOfBounds, kUnusable, kQueries };
constexpr std::size_t kCounts = 8;

/// Holds the space information by reference only, because the space information owns its checker and
/// validator. Any number of threads may use one object.
class PosedScene {
  public:
    enum class For { kStates, kMotions };

    /// Without callbacks, poses and motions are those of OMPL's SE(3) and SE(2). Throws ArgumentError when si is null,
    /// motions are asked for and have no bound, and as stateToPose and displacementBound do.
    PosedScene(const ompl::base::SpaceInformationPtr& si, SharedScene shared, For what);

    const ompl::base::SpaceInformation& si() const { return *si_; }
    const ompl::base::StateSpace& space() const { return *si_->getStateSpace(); }
    const SharedScene& shared() const { return shared_; }
    const SceneClearance& clearance() const { return *shared_.clearance(); }
    const Scene& scene() const { return shared_.scene(); }

    Pose pose(const ompl::base::State* state) const { return stateToPose_(state); }
    /// Why a state is not valid. The bounds are looked at first.
    WhyInvalid whyInvalid(const ompl::base::State* state) const;

    double bound(const ompl::base::State* from, const ompl::base::State* to) const {
        return bound_(from, to);
    }

    /// Empty when only a bound is known.
    const StateMotion& motion() const { return motion_; }

    /// True when all states between two states within the space's bounds are within the bounds.
    bool areBoundsConvex() const { return areBoundsConvex_; }

    void count(Count what, std::uint64_t more = 1) const {
        if (more > 0) counters_[static_cast<std::size_t>(what)].fetch_add(more, std::memory_order_relaxed);
    }
    std::uint64_t counted(Count what) const {
        return counters_[static_cast<std::size_t>(what)].load(std::memory_order_relaxed);
    }

    /// Logs the first problem through OMPL's console: "a state was answered invalid", and why.
    void warnOnce(const char* what, const char* why) const;

  private:
    const ompl::base::SpaceInformation* si_;
    SharedScene shared_;
    bool areBoundsConvex_;
    StateToPose stateToPose_;
    DisplacementBound bound_;
    StateMotion motion_;
    mutable std::array<std::atomic<std::uint64_t>, kCounts> counters_{};
    mutable std::atomic<bool> hasWarned_{false};
};

}  // namespace clearway::planning
