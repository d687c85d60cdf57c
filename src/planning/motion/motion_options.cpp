#include "planning/motion/motion_options.h"

#include <algorithm>

#include "planning/motion/motion_search.h"

namespace clearway::planning {
namespace {

constexpr double kSpareShare = 0.1;
constexpr double kFinestShare = 1e-3;  ///< of the default
constexpr double kAuditShare = 1.0 / 16;

MotionOptions withLeastInterval(double length) {
    MotionOptions options;
    options.leastInterval = length;
    return options;
}

}  // namespace

MotionOptions planningMotions(const Scene& scene, double spareAtEnds) {
    const double usual = defaultLeastInterval(scene);
    return withLeastInterval(std::clamp(kSpareShare * spareAtEnds, kFinestShare * usual, usual));
}

MotionOptions auditMotions(const Scene& scene, double spareAtEnds) {
    return withLeastInterval(kAuditShare * *planningMotions(scene, spareAtEnds).leastInterval);
}

}  // namespace clearway::planning
