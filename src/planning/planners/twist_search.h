// A planner for parts in tight fits, such as screws in their threads: it follows the screw motions that the contacts leave open.
#pragma once

#include <ompl/base/Planner.h>

#include <memory>
#include <vector>

#include "planning/planners/twist_tree.h"

namespace clearway::planning {

/// Grows one TwistTree from the starts and, unless the goal is OutsideGoal, one from the goals. RRTConnect joins the states where the
/// part has come free with each other or with the goal. The planner ends, without a path, when no direction is left that leads
/// anywhere.
///
/// The scene is that of the space information's validity checker, which must be one of clearway's; the space is OMPL's SE(3) or
/// SE(2). All motions of a path were checked by the space information's motion validator, in the direction in which the path takes them.
class TwistSearch : public ompl::base::Planner {
  public:
    /// Makes a planner without trees. si: its scene and space are looked at by setup().
    explicit TwistSearch(const ompl::base::SpaceInformationPtr& si);
    ~TwistSearch() override;

    /// Throws ArgumentError when the space or the validity checker is not as above.
    void setup() override;
    /// Plans until there is an exact solution, isSpent is true, or nothing is left to try. Goes on from the trees of a former call.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& isSpent) override;
    void clear() override;
    /// Forgets the trees of another problem.
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr& definition) override;
    void getPlannerData(ompl::base::PlannerData& data) const override;

    /// Sets the longest edge of RRTConnect's trees, in OMPL's distance; 0: OMPL's default.
    void setRange(double range) { range_ = range; }
    double getRange() const { return range_; }

    /// The tracks from the starts that came to an end.
    const std::vector<TwistTree::TrackEnd>& ends() const;
    /// Whether nothing is left to try.
    bool isExhausted() const { return isExhausted_; }

    /// Whether a state is one that this planner is for. Takes one query.
    static bool isTight(const ompl::base::SpaceInformationPtr& si, const ompl::base::State* state);

  private:
    struct Parts;
    class Joint;

    bool addRoots(const ompl::base::PlannerTerminationCondition& isSpent);
    void addSolution(const std::vector<const ompl::base::State*>& states);
    bool join(const ompl::base::PlannerTerminationCondition& isSpent);

    double range_ = 0;
    std::unique_ptr<Parts> parts_;
    bool isExhausted_ = false;
};

}  // namespace clearway::planning
