// Checks a path from a file against the problem that it is to solve.
#pragma once

#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

struct PathCheck {
    PathAudit audit;
    /// At the path's ends no point of the part is farther than this from its place at the problem's start and
    /// goal. For a goal outside, offGoal is OutsideGoal::distanceGoal at the path's end. Environment units.
    double offStart = 0, offGoal = 0;
    double tolerance = 0;  ///< offsets up to this are rounding in the file: a share of the part's diagonal

    bool beginsAtStart() const { return offStart <= tolerance; }
    bool endsAtGoal() const { return offGoal <= tolerance; }
};

/// Audits the path in the problem's space, within the problem's bounds and with the scene's margins. Throws
/// std::invalid_argument when the path has no state, a coordinate is more than 1e12 times the scene's
/// largest, the bounds leave out the problem's start or goal, or the environment was built with too small a
/// reach (see planningReach).
PathCheck checkPath(const Problem& problem, const Scene& scene, const std::vector<PartState>& path,
                    const AuditOptions& options = {/*profile*/ true});

}  // namespace clearway::planning

#pragma GCC visibility pop
