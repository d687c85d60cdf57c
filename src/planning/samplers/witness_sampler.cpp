#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <stdexcept>
#include <typeinfo>

#include "clearway/planning/valid_state_samplers.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

std::shared_ptr<const ValidityChecker> checkerOf(const ob::SpaceInformation& si, const char* sampler) {
    auto checker = std::dynamic_pointer_cast<const ValidityChecker>(si.getStateValidityChecker());
    if (checker) return checker;
    throw std::invalid_argument(std::string("the sampler ") + sampler +
                                " was given a space information whose validity checker is none of "
                                "clearway's, expected clearway::planning::ValidityChecker");
}

bool isPlanar(const ob::StateSpace& space, const char* sampler) {
    if (dynamic_cast<const ob::SE2StateSpace*>(&space)) return true;
    if (dynamic_cast<const ob::SE3StateSpace*>(&space)) return false;
    throw std::invalid_argument(std::string("the sampler ") + sampler + " was given the state space '" +
                                space.getName() + "', expected SE(3) or SE(2)");
}

}  // namespace

WitnessSampler::WitnessSampler(const ob::SpaceInformation* si, const char* name)
    : ob::ValidStateSampler(si),
      checker_(checkerOf(*si, name)),
      sampler_(si->allocStateSampler()),
      isPlanar_(isPlanar(*si->getStateSpace(), name)) {
    name_ = name;
    other_ = si->allocState();
}

WitnessSampler::~WitnessSampler() {
    si_->freeState(other_);
}

WitnessSampler::Room WitnessSampler::roomAt(const ob::State* state) const {
    Room room;
    room.isValid = checker_->isValid(state, room.clearance);
    if (!room.isValid) return room;
    const SceneDistance nearest = checker_->distance(state);
    Vector3 away = nearest.pointOnPart - nearest.pointOnEnvironment;
    if (isPlanar_) away.z() = 0;
    const double length = away.norm();
    if (length > 0 && nearest.partTriangle >= 0) room.away = away / length;
    return room;
}

void WitnessSampler::translate(ob::State* state, const Vector3& by) const {
    if (isPlanar_) {
        auto* se2 = state->as<ob::SE2StateSpace::StateType>();
        se2->setXY(se2->getX() + by.x(), se2->getY() + by.y());
    } else {
        auto* se3 = state->as<ob::SE3StateSpace::StateType>();
        se3->setXYZ(se3->getX() + by.x(), se3->getY() + by.y(), se3->getZ() + by.z());
    }
}

double WitnessSampler::partDiagonal() const {
    return checker_->scene().part.box().diagonal().norm();
}

}  // namespace clearway::planning
