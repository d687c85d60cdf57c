// Checks a path from a file against the problem that it claims to solve.
#pragma once

#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// The answer of checkPath. Lengths in environment units.
struct PathCheck {
    PathAudit audit;  ///< of the path in the problem's space and scene
    /// Upper bound of any point's displacement between the path's first state and the problem's start.
    double offStart = 0;
    /// Upper bound of any point's displacement between the path's last state and the problem's goal. For a goal
    /// outside it is OutsideGoal::distanceGoal of the last state.
    double offGoal = 0;
    double tolerance = 0;  ///< offsets up to this are rounding in the file: a share of the part's diagonal

    /// Whether the path begins at the problem's start.
    bool beginsAtStart() const { return offStart <= tolerance; }

    /// Whether the path ends at the problem's goal.
    bool endsAtGoal() const { return offGoal <= tolerance; }
};

/// Audits the path in the problem's space, within the problem's bounds and with the scene's margins. Throws
/// ArgumentError when the path has no state, a coordinate is more than 1e12 times the scene's
/// largest, the bounds leave out the problem's start or goal, or the environment was built with too small a
/// range (see planningRange).
PathCheck checkPath(const Problem& problem, const Scene& scene, const std::vector<PartState>& path,
                    const AuditOptions& options = {/*profile*/ true});

}  // namespace clearway::planning

#pragma GCC visibility pop
