#include "model/within_reach.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/number.h"

namespace clearway {
namespace {

[[noreturn]] void refuse(const std::string& what, double value, const std::string& expected) {
    throw std::invalid_argument(what + " is " + shortNumber(value) + ", expected " + expected +
                                ": the environment was built without what is out of that reach");
}

}  // namespace

void requireWithinReach(const Model& part, const Model& environment, const Pose& X_environmentPart) {
    if (part.reach()) {
        throw std::invalid_argument(
            "the part was built with a reach and lacks triangles, expected one built without");
    }
    if (!environment.reach()) return;
    const Reach& reach = *environment.reach();
    if (part.radiusAboutOrigin() > reach.partRadius) {
        refuse("the part's radius about its origin", part.radiusAboutOrigin(),
               "at most " + shortNumber(reach.partRadius));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double low = reach.positions.min()[axis], high = reach.positions.max()[axis];
        const double position = X_environmentPart.translation[axis];
        if (position >= low && position <= high) continue;
        refuse(std::string("the pose's translation along ") + "xyz"[axis], position,
               shortNumber(low) + " to " + shortNumber(high));
    }
}

void requireWithinCap(const Model& environment, double d) {
    if (!environment.reach() || d <= environment.reach()->cap) return;
    refuse("d", d, "at most " + shortNumber(environment.reach()->cap));
}

double cappedByReach(const Model& environment, double cap) {
    return environment.reach() ? std::min(cap, environment.reach()->cap) : cap;
}

}  // namespace clearway
