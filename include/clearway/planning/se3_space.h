// OMPL's SE(3) with states that lie together in memory.
#pragma once

#include <ompl/base/spaces/SE3StateSpace.h>

#pragma GCC visibility push(default)

namespace clearway::planning {

/// OMPL's SE(3) in all it does, to the last digit, and faster where planners spend most of their time outside of queries:
/// in distances to nearest neighbours. OMPL allocates a state in five pieces, whose places in memory a distance looks up one
/// after the other. Here a state is one piece. All of clearway takes this space for OMPL's SE(3).
class Se3Space final : public ompl::base::SE3StateSpace {
  public:
    ompl::base::State* allocState() const override;
    void freeState(ompl::base::State* state) const override;
    double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
