// How closely motions are looked at, so that what begins at a tight start can be planned and audited.
#pragma once

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// For planning between states that have so much to spare (the lesser clearance of the two): a least interval
/// of a tenth of it where that is less than the default, but no less than a thousandth of the default.
MotionOptions planningMotions(const Scene& scene, double spareAtEnds);

/// For auditing a path with such ends: a sixteenth of that, so that what passed in one order of looking
/// passes in another.
MotionOptions auditMotions(const Scene& scene, double spareAtEnds);

}  // namespace clearway::planning
