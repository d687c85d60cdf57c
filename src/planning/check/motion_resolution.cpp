#include "planning/check/motion_resolution.h"

#include <algorithm>

namespace clearway::planning {
namespace {

constexpr double kDefaultLeastInterval = 1e-5;  ///< of the part's diagonal

constexpr double kSpareShare = 0.1;    ///< of the spare at the ends, for planning
constexpr double kFinestShare = 1e-3;  ///< of the default least interval
constexpr double kAuditShare = 1.0 / 16;

constexpr double kUsualShare = 1e-2;
constexpr double kUsualLargestShare = 0.1;
constexpr double kUsualDiagonal = 1e-3;  ///< of the part's diagonal

double diagonalOf(const Box& box) {
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace

double defaultLeastInterval(const Scene& scene) {
    const double part = diagonalOf(scene.part.box());
    const double size = part > 0 ? part : diagonalOf(scene.environmentBox());
    return kDefaultLeastInterval * (size > 0 ? size : 1);
}

MotionOptions planningMotions(const Scene& scene, double spareAtEnds) {
    const double usual = defaultLeastInterval(scene);
    MotionOptions options;
    options.leastInterval = std::clamp(kSpareShare * spareAtEnds, kFinestShare * usual, usual);
    return options;
}

MotionOptions auditMotions(const Scene& scene, double spareAtEnds) {
    MotionOptions options;
    options.leastInterval = kAuditShare * *planningMotions(scene, spareAtEnds).leastInterval;
    return options;
}

ClearanceResolution usualResolution(const Scene& scene, double leastInterval) {
    return {kUsualShare, kUsualLargestShare, kUsualDiagonal * diagonalOf(scene.part.box()), leastInterval};
}

}  // namespace clearway::planning
