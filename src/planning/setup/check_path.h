// A path from a file, held against the problem it is to solve.
#pragma once

#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::planning {

struct PathCheck {
    PathAudit audit;
    /// No point of the part is farther than this from where the problem has it.
    double offStart = 0, offGoal = 0;
    double tolerance = 0;  ///< what of that is taken for rounding in the file: a share of the part's diagonal

    bool beginsAtStart() const { return offStart <= tolerance; }
    bool endsAtGoal() const { return offGoal <= tolerance; }
};

/// Audits the path in the problem's space, by its bounds and the scene's margin. Throws std::invalid_argument
/// when the path has no state, the bounds leave out the problem's start or goal, or the environment was built
/// with too small a reach (see planningReach).
PathCheck checkPath(const Problem& problem, const Scene& scene, const std::vector<PartState>& path,
                    const AuditOptions& options = {/*profile*/ true});

}  // namespace clearway::planning
