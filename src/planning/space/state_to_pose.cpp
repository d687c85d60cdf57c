#include "clearway/planning/state_to_pose.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/WrapperStateSpace.h>

#include <cmath>
#include <limits>

#include "clearway/errors.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

Pose poseOrNone(const PartState& state) {
    const double norm = state.rotation.norm();
    if (std::isnormal(norm) && state.position.allFinite()) return poseOf(state);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {Matrix3::Constant(kNone), Vector3::Constant(kNone)};
}

}  // namespace

StateToPose stateToPose(const ob::StateSpace& space) {
    if (dynamic_cast<const ob::SE3StateSpace*>(&space)) {
        return [](const ob::State* state) { return poseOrNone(partStateOfSe3(state)); };
    }
    if (dynamic_cast<const ob::SE2StateSpace*>(&space)) {
        return [](const ob::State* state) { return poseOrNone(partStateOfSe2(state)); };
    }
    if (const auto* wrapper = dynamic_cast<const ob::WrapperStateSpace*>(&space)) {
        return [inner = stateToPose(*wrapper->getSpace())](const ob::State* state) {
            return inner(state->as<ob::WrapperStateSpace::StateType>()->getState());
        };
    }
    throw ArgumentError("state space '" + space.getName() +
                        "' is neither SE(3) nor SE(2), expected a callback from its states to poses");
}

}  // namespace clearway::planning
