// How closely motions and their clearances are looked at.
#pragma once

#include "clearway/planning/motion_validator.h"
#include "clearway/scene.h"
#include "scene/interpolated_motion.h"

namespace clearway::planning {

/// Options for planning between a start and a goal of which the tighter one has `clearanceAtEnds` clearance: a
/// least interval of a tenth of that clearance where this is less than the default, but no less than a
/// thousandth of the default. So paths that begin at a tight start can be planned and audited.
MotionOptions planningMotions(const Scene& scene, double clearanceAtEnds);

/// Options for auditing a path with such ends: a sixteenth of planningMotions' interval, so that motions that
/// passed in one order of samples pass in another order.
MotionOptions auditMotions(const Scene& scene, double clearanceAtEnds);

/// The resolution of the least clearances in reports: 1 % or, where that is more, 1e-3 of the part's
/// diagonal, but no worse than 10 % or leastInterval.
ClearanceResolution usualResolution(const Scene& scene, double leastInterval);

}  // namespace clearway::planning
