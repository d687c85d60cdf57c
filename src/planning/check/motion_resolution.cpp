#include "planning/check/motion_resolution.h"

#include <algorithm>

namespace clearway::planning {
namespace {

constexpr double kClearanceShare = 0.1;  ///< of the clearance at the ends, for planning
constexpr double kFinestShare = 1e-3;    ///< of the default least interval
constexpr double kAuditShare = 1.0 / 16;

constexpr double kUsualShare = 1e-2;
constexpr double kUsualLargestShare = 0.1;
constexpr double kUsualDiagonal = 1e-3;  ///< of the part's diagonal

}  // namespace

MotionOptions planningMotions(const Scene& scene, double clearanceAtEnds) {
    const double usual = defaultLeastInterval(scene);
    MotionOptions options;
    options.leastInterval = std::clamp(kClearanceShare * clearanceAtEnds, kFinestShare * usual, usual);
    return options;
}

MotionOptions auditMotions(const Scene& scene, double clearanceAtEnds) {
    MotionOptions options;
    options.leastInterval = kAuditShare * *planningMotions(scene, clearanceAtEnds).leastInterval;
    return options;
}

ClearanceResolution usualResolution(const Scene& scene, double leastInterval) {
    return {kUsualShare, kUsualLargestShare, kUsualDiagonal * diagonalOf(scene.part.box()), leastInterval};
}

}  // namespace clearway::planning
