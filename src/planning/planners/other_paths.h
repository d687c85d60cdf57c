// Where to look for other ways than a known path takes: beside the motions of it that leave too little clearance.
#pragma once

#include <ompl/base/StateSampler.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include <functional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/improve/part_moves.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

/// The numbers of the states at which motions of the path end that do not keep the floor.
std::vector<unsigned int> narrowsOf(const og::PathGeometric& path, const MotionValidator& validator,
                                    double floor, const std::function<bool()>& isSpent);

/// Draws states beside the narrow places of a path, turned at will: the centre of the part's box is within half its diagonal,
/// along each axis, of where it is on a motion of the path that does not keep a floor. One state of four is drawn anywhere.
class BesideNarrows : public ob::StateSampler {
  public:
    /// narrows: as narrowsOf returns them; at least one. The space must outlive this object.
    BesideNarrows(const ob::SpaceInformation& si, const og::PathGeometric& path,
                  std::vector<unsigned int> narrows, const Model& part);

    void sampleUniform(ob::State* state) override;
    void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
        anywhere_->sampleUniformNear(state, near, distance);
    }
    void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
        anywhere_->sampleGaussian(state, mean, deviation);
    }

  private:
    Vector3 centre(const ob::State* state) const { return moves_.centre(moves_.pose(state)); }

    ob::StateSamplerPtr anywhere_;
    PartMoves moves_;
    og::PathGeometric path_;
    std::vector<unsigned int> narrows_;
    ScratchState narrow_;
    int drawn_ = 0;
    ompl::RNG random_;
};

/// A goal that draws states of another goal, by turns with the states of a path from the first one given to its end.
class EndOfPath : public ob::GoalSampleableRegion {
  public:
    /// goal: a GoalSampleableRegion that the end of the path satisfies.
    EndOfPath(const ob::SpaceInformationPtr& si, ob::GoalPtr goal, const og::PathGeometric& path,
              unsigned int first);

    double distanceGoal(const ob::State* state) const override { return region().distanceGoal(state); }
    bool isSatisfied(const ob::State* state) const override { return goal_->isSatisfied(state); }
    bool isSatisfied(const ob::State* state, double* distance) const override {
        return goal_->isSatisfied(state, distance);
    }
    unsigned int maxSampleCount() const override {
        return region().maxSampleCount() + static_cast<unsigned int>(path_.getStateCount()) - first_;
    }
    void sampleGoal(ob::State* state) const override;

  private:
    const ob::GoalSampleableRegion& region() const { return *goal_->as<ob::GoalSampleableRegion>(); }

    ob::GoalPtr goal_;
    og::PathGeometric path_;
    unsigned int first_;
    mutable unsigned int drawn_ = 0;
};

}  // namespace clearway::planning
