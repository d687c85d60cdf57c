#include "planning/paths/room_both_ways.h"

#include <algorithm>
#include <utility>

#include "clearway/planning/simplify.h"
#include "planning/paths/unwind.h"

namespace clearway::planning {
namespace {

namespace og = ompl::geometric;

/// Kept where the path is shortened, as a share of the part's diagonal: a band that begins in contact begins slowly.
constexpr double kShortenedFloor = 1e-3;
constexpr double kAsMuch = 0.97;  ///< of the clearance of another way is about as much

struct Way {
    og::PathGeometric path;
    double clearance = 0;
};

Way wayShortened(const og::PathGeometric& path, const MotionValidator& validator, RoomOptions options) {
    Way way{path, 0};
    const double floor = kShortenedFloor * validator.scene().part.box().diagonal().norm();
    simplify(way.path, validator, {std::max(floor, options.clearance), options.isSpent});
    // The shortened path keeps as much only to the audit's accuracy.
    options.clearance = 0;
    way.clearance = makeRoom(way.path, validator, options);
    return way;
}

bool isBetter(const Way& way, const Way& other, double radius) {
    if (way.clearance < kAsMuch * other.clearance) return false;
    if (other.clearance < kAsMuch * way.clearance) return true;
    return windingLength(way.path, radius) < windingLength(other.path, radius);
}

}  // namespace

double makeRoomBothWays(og::PathGeometric& path, const MotionValidator& validator,
                        const RoomOptions& options) {
    Way shortened = wayShortened(path, validator, options);
    Way asItIs{path, 0};
    asItIs.clearance = makeRoom(asItIs.path, validator, options);
    const double radius = 0.5 * validator.scene().part.box().diagonal().norm();
    const bool isShortenedBetter =
        shortened.clearance >= options.clearance && isBetter(shortened, asItIs, radius);
    Way& best = isShortenedBetter ? shortened : asItIs;
    path = best.path;
    return best.clearance;
}

}  // namespace clearway::planning
