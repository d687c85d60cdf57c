// OMPL's goal for a part that has to leave its surroundings, wherever it ends.
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/util/RandomNumbers.h>

#include <mutex>

#include "clearway/planning/state_to_pose.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// A state satisfies the goal when the part's box and the environment's are apart there (see Outside). The part's box is its
/// box in its own coordinates, moved to the state's pose, and the box along the environment's axes around that. The
/// goal does not check validity, because planners test only valid states.
///
/// Any number of threads may use one goal.
class OutsideGoal : public ompl::base::GoalSampleableRegion {
  public:
    /// Takes the boxes of the scene, ignored obstacles included (Scene::environmentBox). Throws ArgumentError when si
    /// is null or its space is neither SE(3) nor SE(2).
    /// start: where draws begin, see sampleGoal.
    OutsideGoal(const ompl::base::SpaceInformationPtr& si, const Scene& scene, const Outside& outside,
                const PartState& start);

    /// The same goal for another space information, whose checker then judges the states that are drawn.
    OutsideGoal(const ompl::base::SpaceInformationPtr& si, const OutsideGoal& goal);

    /// How far the boxes overlap: how far the part's box must move straight along an axis, in environment units; 0 outside.
    /// It is no bound of the path's length to the goal: a rotation may shorten it.
    double distanceGoal(const ompl::base::State* state) const override;

    /// Whether the boxes are apart at the state.
    bool isSatisfied(const ompl::base::State* state) const override;

    /// Whether the boxes are apart at the state. distance: becomes distanceGoal(state), unless null.
    bool isSatisfied(const ompl::base::State* state, double* distance) const override;

    /// Draws a state that satisfies the goal, is within the space's bounds, and is valid for si's checker. Half of the states
    /// are reached from the start straight along an axis, a quarter have the start's rotation and any position, and a quarter
    /// any rotation. Where a rotation does not fit, one is drawn that takes the least space. After 100 draws without
    /// a valid state, sets a position outside the bounds, which planners refuse.
    void sampleGoal(ompl::base::State* state) const override;

    /// Moves a state that satisfies the goal straight along an axis, where no obstacle blocks it, until the gap
    /// between the boxes of part and environment is as wide as given, or as wide as the bounds allow. Other states
    /// stay.
    void moveOut(ompl::base::State* state, double gap) const;

    unsigned int maxSampleCount() const override;  ///< 100: how many different states planners should draw

  private:
    double overlap(const ompl::base::State* state) const;
    PartState draw(ompl::base::State* scratch) const;
    bool placeOutside(PartState& state, bool isStraight) const;
    void turnFlat(PartState& state) const;

    Outside outside_;
    PartState start_;
    Box part_, surroundings_, bounds_;
    Space kind_;
    StateToPose stateToPose_;
    mutable std::mutex mutex_;  ///< guards the two random sources
    mutable ompl::base::StateSamplerPtr sampler_;
    mutable ompl::RNG random_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
