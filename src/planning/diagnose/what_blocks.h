// Finds by trial what stops the part: motions from states that planners reached are followed until they are blocked.
#pragma once

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/why_no_path.h"
#include "planning/diagnose/failed_trees.h"

namespace clearway::planning {

/// Fills in motionsTried, blockers, and motionsStopped of both ends, as whyNoPath describes. The motions begin at the
/// two trees by turns.
void findBlockers(const FailedTrees& trees, const MotionValidator& validator, Space space,
                  const WhyNoPathOptions& options, WhyNoPath& why);

}  // namespace clearway::planning
