#include <ompl/base/spaces/SE2StateSpace.h>

#include <cmath>
#include <memory>
#include <typeinfo>
#include <utility>

#include "clearway/errors.h"
#include "clearway/planning/shared_scene.h"
#include "planning/space/ompl_states.h"
#include "scene/interpolated_motion.h"

namespace clearway::planning {
namespace {

/// The poses between two states, as OMPL interpolates them.
class PosesBetween {
  public:
    PosesBetween(ob::StateSpacePtr space, StateToPose pose, const ob::State* from, const ob::State* to)
        : space_(std::move(space)),
          pose_(std::move(pose)),
          from_(from),
          to_(to),
          scratch_(space_->allocState()) {}
    ~PosesBetween() { space_->freeState(scratch_); }
    PosesBetween(const PosesBetween&) = delete;
    PosesBetween& operator=(const PosesBetween&) = delete;

    Pose at(double time) const {
        space_->interpolate(from_, to_, time, scratch_);
        return pose_(scratch_);
    }

  private:
    const ob::StateSpacePtr space_;
    const StateToPose pose_;
    const ob::State *from_, *to_;
    ob::State* scratch_;
};

/// Whether OMPL interpolates to the negative of the second quaternion. Between orientations half a turn apart only OMPL's own
/// rounding tells.
bool turnsTheOtherWay(const PartState& from, const PartState& to, const PosesBetween& poses) {
    constexpr double kSure = 1e-9;
    if (!canBeInterpolated(from) || !canBeInterpolated(to)) return false;
    const Eigen::Vector4d a = from.rotation.coeffs().normalized(), b = to.rotation.coeffs().normalized();
    const double product = a.dot(b);
    if (std::abs(product) > kSure) return product < 0;
    const Eigen::Quaterniond middle(poses.at(0.5).rotation);
    return std::abs(middle.coeffs().dot(a + b)) < std::abs(middle.coeffs().dot(a - b));
}

/// motionOf(from, to, poses): the velocities.
template <class MotionOf>
StateMotion steadyMotion(const ob::StateSpacePtr& space, const MotionOf& motionOf) {
    return [space, pose = stateToPose(*space), motionOf](const ob::State* from, const ob::State* to) {
        const auto poses = std::make_shared<const PosesBetween>(space, pose, from, to);
        const SteadyMotion motion = motionOf(from, to, *poses);
        const auto piece = [poses, motion](double begin, double end) {
            const double half = 0.5 * (end - begin);
            return motion.around(poses->at(begin + half), half);
        };
        return PartMotion{piece, motion.length, motion.endJump};
    };
}

}  // namespace

StateMotion stateMotion(const ob::StateSpacePtr& space, const Model& part) {
    const PartExtent reach(part);
    const ob::StateSpace& omplSpace = *space;
    if (isOmplSe3(omplSpace)) {
        return steadyMotion(space,
                            [reach](const ob::State* from, const ob::State* to, const PosesBetween& poses) {
                                const PartState a = partStateOfSe3(from), b = partStateOfSe3(to);
                                return se3Motion(reach, a, b, turnsTheOtherWay(a, b, poses));
                            });
    }
    if (typeid(omplSpace) == typeid(ob::SE2StateSpace)) {
        return steadyMotion(space, [reach, radius = part.radiusAboutAxis(Vector3::UnitZ())](
                                       const ob::State* from, const ob::State* to, const PosesBetween&) {
            return se2Motion(reach, radius, planarNumbersOf(from), planarNumbersOf(to));
        });
    }
    throw ArgumentError("state space '" + space->getName() +
                        "' is neither OMPL's SE(3) nor its SE(2), expected a motion of its own");
}

}  // namespace clearway::planning
