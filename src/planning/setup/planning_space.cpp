#include "planning/setup/planning_space.h"

#include <ompl/base/samplers/BridgeTestValidStateSampler.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/MaximizeClearanceValidStateSampler.h>
#include <ompl/base/samplers/ObstacleBasedValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "clearway/planning/valid_state_samplers.h"
#include "core/text.h"
#include "planning/validity/part_state.h"

namespace clearway::planning {

namespace ob = ompl::base;

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

template <class Sampler>
ob::ValidStateSamplerPtr allocate(const ob::SpaceInformation* si) {
    return std::make_shared<Sampler>(si);
}

struct NamedSampler {
    const char* name;
    ob::ValidStateSamplerPtr (*allocate)(const ob::SpaceInformation*);
};

constexpr NamedSampler kSamplers[] = {
    {"uniform", allocate<ob::UniformValidStateSampler>},
    {"gaussian", allocate<ob::GaussianValidStateSampler>},
    {"obstacle_based", allocate<ob::ObstacleBasedValidStateSampler>},
    {"max_clearance", allocate<ob::MaximizeClearanceValidStateSampler>},
    {"bridge_test", allocate<ob::BridgeTestValidStateSampler>},
    {"contact_normal", allocate<ContactNormalSampler>},
    {"narrow_gap", allocate<NarrowGapSampler>},
};

}  // namespace

ob::StateSpacePtr makeSpace(Space kind, const Box& bounds, double turnWeight) {
    if (kind == Space::kSe2) return makeBounded<ob::SE2StateSpace>(bounds, 2, turnWeight);
    return makeBounded<ob::SE3StateSpace>(bounds, 3, turnWeight);
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

void setSampler(ob::SpaceInformation& si, const std::string& name,
                const std::function<void(ob::ValidStateSampler&)>& adjust) {
    if (name.empty()) return;
    for (const NamedSampler& row : kSamplers) {
        if (name == row.name) {
            return si.setValidStateSamplerAllocator(
                [adjust, allocate = row.allocate](const ob::SpaceInformation* space) {
                    const ob::ValidStateSamplerPtr sampler = allocate(space);
                    adjust(*sampler);
                    return sampler;
                });
        }
    }
    throw std::invalid_argument("unknown sampler '" + name + "', expected one of " +
                                joined(namesOf(kSamplers)));
}

}  // namespace clearway::planning
