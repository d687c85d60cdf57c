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
std::vector<unsigned int> narrowsOf(const ompl::geometric::PathGeometric& path,
                                    const MotionValidator& validator, double floor,
                                    const std::function<bool()>& isSpent);

/// Draws states beside the narrow places of a path, turned at will: the centre of the part's box is within half its diagonal,
/// along each axis, of where it is on a motion of the path that does not keep a floor. One state of four is drawn anywhere.
class BesideNarrows : public ompl::base::StateSampler {
  public:
    /// narrows: as narrowsOf returns them; at least one. The space must outlive this object.
    BesideNarrows(const ompl::base::SpaceInformation& si, const ompl::geometric::PathGeometric& path,
                  std::vector<unsigned int> narrows, const Model& part);

    void sampleUniform(ompl::base::State* state) override;
    void sampleUniformNear(ompl::base::State* state, const ompl::base::State* near, double distance) override;
    void sampleGaussian(ompl::base::State* state, const ompl::base::State* mean, double deviation) override;

  private:
    Vector3 centre(const ompl::base::State* state) const { return moves_.centre(moves_.pose(state)); }

    ompl::base::StateSamplerPtr anywhere_;
    PartMoves moves_;
    ompl::geometric::PathGeometric path_;
    std::vector<unsigned int> narrows_;
    ScratchState narrow_;
    int drawn_ = 0;
    ompl::RNG random_;
};

/// A goal that draws states of another goal, by turns with the states of a path from the first one given to its end.
class EndOfPath : public ompl::base::GoalSampleableRegion {
  public:
    /// goal: a GoalSampleableRegion that the end of the path satisfies.
    EndOfPath(const ompl::base::SpaceInformationPtr& si, ompl::base::GoalPtr goal,
              const ompl::geometric::PathGeometric& path, unsigned int first);

    double distanceGoal(const ompl::base::State* state) const override;
    bool isSatisfied(const ompl::base::State* state) const override;
    bool isSatisfied(const ompl::base::State* state, double* distance) const override;
    unsigned int maxSampleCount() const override;
    void sampleGoal(ompl::base::State* state) const override;

  private:
    const ompl::base::GoalSampleableRegion& region() const;

    ompl::base::GoalPtr goal_;
    ompl::geometric::PathGeometric path_;
    unsigned int first_;
    mutable unsigned int drawn_ = 0;
};

}  // namespace clearway::planning
