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
    /// Allocates a state as one piece of memory; freeState frees it.
    ompl::base::State* allocState() const override;

    /// Frees a state that allocState allocated.
    void freeState(ompl::base::State* state) const override;

    /// OMPL's distance: the straight way times its weight plus the angle times its weight. The states may be
    /// those of another SE(3).
    double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
