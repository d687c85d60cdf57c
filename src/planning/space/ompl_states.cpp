#include "planning/space/ompl_states.h"

#include <fmt/format.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/config.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <typeinfo>

#include "clearway/errors.h"
#include "clearway/planning/se3_space.h"
#include "scene/interpolated_motion.h"

#if OMPL_VERSION_VALUE < 1005000
#error "clearway needs OMPL 1.5 or later"
#endif

namespace clearway::planning {

namespace {

template <class SpaceClass>
std::shared_ptr<SpaceClass> makeBounded(const Box& box, unsigned int dimension, double turnWeight) {
    auto space = std::make_shared<SpaceClass>();
    ob::RealVectorBounds bounds(dimension);
    for (unsigned int i = 0; i < dimension; ++i) {
        bounds.setLow(i, box.min()[i]);
        bounds.setHigh(i, box.max()[i]);
    }
    space->setBounds(bounds);
    space->setSubspaceWeight(1, turnWeight);
    return space;
}

std::mutex& sharedSpaces() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

const ob::StateSpace& spaceOf(const ob::SpaceInformationPtr& si) {
    if (si) return *si->getStateSpace();
    throw ArgumentError("the space information is null, expected that of the planner");
}

bool isOmplSe3(const ob::StateSpace& space) {
    return typeid(space) == typeid(ob::SE3StateSpace) || typeid(space) == typeid(Se3Space);
}

Space kindOf(const ob::StateSpace& space) {
    if (dynamic_cast<const ob::SE3StateSpace*>(&space)) return Space::kSe3;
    if (dynamic_cast<const ob::SE2StateSpace*>(&space)) return Space::kSe2;
    throw ArgumentError("state space '" + space.getName() +
                        "' is neither SE(3) nor SE(2), expected one of them");
}

ob::StateSpacePtr makeSpace(Space kind, const Box& bounds, double turnWeight) {
    if (kind == Space::kSe2) return makeBounded<ob::SE2StateSpace>(bounds, 2, turnWeight);
    return makeBounded<Se3Space>(bounds, 3, turnWeight);
}

const ob::RealVectorBounds& positionBounds(Space kind, const ob::StateSpace& space) {
    return kind == Space::kSe2 ? space.as<ob::SE2StateSpace>()->getBounds()
                               : space.as<ob::SE3StateSpace>()->getBounds();
}

WhyInvalid whyOutOfBounds(const ob::StateSpace& space, const ob::State* state) {
    WhyInvalid why;
    why.kind = WhyInvalid::Kind::kOutOfBounds;
    const bool isSpatial = dynamic_cast<const ob::SE3StateSpace*>(&space) != nullptr;
    if (!isSpatial && dynamic_cast<const ob::SE2StateSpace*>(&space) == nullptr) return why;
    const Space kind = isSpatial ? Space::kSe3 : Space::kSe2;
    const ob::RealVectorBounds& bounds = positionBounds(kind, space);
    const PartState at = fromOmpl(kind, state);
    for (unsigned i = 0; i < bounds.low.size(); ++i) {
        const double value = at.position[i];
        if (value >= bounds.low[i] && value <= bounds.high[i]) continue;
        why.coordinate = {"xyz"[i], value, bounds.low[i], bounds.high[i]};
        return why;
    }
    // OMPL's bounds refuse quaternions that are not of unit length, too.
    if (isSpatial && !canBeInterpolated(at)) {
        why.kind = WhyInvalid::Kind::kNoPose;
        why.reason = fmt::format("the state's quaternion has length {}, expected 1 to within 1e-9",
                                 at.rotation.norm());
    }
    return why;
}

ob::SpaceInformationPtr makeOnSharedSpace(const ob::StateSpacePtr& space) {
    const std::lock_guard<std::mutex> lock(sharedSpaces());
    return std::make_shared<ob::SpaceInformation>(space);
}

void setUpOnSharedSpace(ob::SpaceInformation& si) {
    const std::lock_guard<std::mutex> lock(sharedSpaces());
    si.setup();
}

ob::ScopedState<> toOmpl(const ob::StateSpacePtr& space, Space kind, const PartState& state) {
    ob::ScopedState<> result(space);
    const auto q = state.rotation.normalized();
    if (kind == Space::kSe2) {
        auto* se2 = result->as<ob::SE2StateSpace::StateType>();
        se2->setXY(state.position.x(), state.position.y());
        const double yaw = std::remainder(2 * std::atan2(q.z(), q.w()), 2 * M_PI);
        se2->setYaw(yaw < M_PI ? yaw : -M_PI);  // OMPL's angles end before pi
    } else {
        auto* se3 = result->as<ob::SE3StateSpace::StateType>();
        se3->setXYZ(state.position.x(), state.position.y(), state.position.z());
        se3->rotation().x = q.x();
        se3->rotation().y = q.y();
        se3->rotation().z = q.z();
        se3->rotation().w = q.w();
    }
    return result;
}

PartState fromOmpl(Space kind, const ob::State* state) {
    return kind == Space::kSe2 ? partStateOfSe2(state) : partStateOfSe3(state);
}

PartState partStateOfSe3(const ob::State* state) {
    const auto* se3 = state->as<ob::SE3StateSpace::StateType>();
    const auto& q = se3->rotation();
    return {{se3->getX(), se3->getY(), se3->getZ()}, {q.w, q.x, q.y, q.z}};
}

PartState partStateOfSe2(const ob::State* state) {
    const auto* se2 = state->as<ob::SE2StateSpace::StateType>();
    const double half = se2->getYaw() / 2;
    return {{se2->getX(), se2->getY(), 0}, {std::cos(half), 0, 0, std::sin(half)}};
}

Vector3 planarNumbersOf(const ob::State* state) {
    const auto* se2 = state->as<ob::SE2StateSpace::StateType>();
    return {se2->getX(), se2->getY(), se2->getYaw()};
}

void setLastValid(const ob::SpaceInformation& si, const ob::State* s1, const ob::State* s2, double time,
                  std::pair<ob::State*, double>& lastValid) {
    lastValid.second = time;
    if (lastValid.first == nullptr) return;
    const ScratchState scratch(si);
    si.copyState(scratch.get(), s1);
    if (time > 0) si.getStateSpace()->interpolate(s1, s2, time, scratch.get());
    si.copyState(lastValid.first, scratch.get());
}

}  // namespace clearway::planning
