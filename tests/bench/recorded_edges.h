// Records the motions that RRTConnect checks while it plans a problem.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <vector>

#include "clearway/planning/validity_checker.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing {

struct Edge {
    ob::ScopedState<> from, to;
};

/// Records edges. The caller sets OMPL's seed.
class EdgeRecorder {
  public:
    /// range: the longest edge of the planner's trees. Environment units.
    EdgeRecorder(const Problem& problem, const Scene& scene, double range);

    const ob::StateSpacePtr& space() const { return space_; }

    /// A space information of the problem's space with a checker for the scene. The caller sets it up.
    ob::SpaceInformationPtr makeSpaceInformation(const Scene& scene) const;

    /// Plans the problem with certified motions, repeatedly, until there are `count` edges.
    std::vector<Edge> record(std::size_t count) const;

  private:
    Problem problem_;
    Scene scene_;
    double range_;
    ob::StateSpacePtr space_;
};

}  // namespace clearway::testing
