// A scene in OMPL's SE(3), with clearway's checker and certified validator.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <memory>

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing {

struct PartInSpace {
    explicit PartInSpace(const Scene& scene, double halfSide = 1000, Space kind = Space::kSe3)
        : spaceKind(kind),
          space(planning::makeSpace(
              kind, Box(Vector3::Constant(-halfSide).eval(), Vector3::Constant(halfSide).eval()), 1)),
          si(std::make_shared<ob::SpaceInformation>(space)),
          checker(std::make_shared<planning::ValidityChecker>(si, scene)),
          validator(std::make_shared<planning::MotionValidator>(si, scene)) {
        si->setStateValidityChecker(checker);
        si->setMotionValidator(validator);
        si->setup();
    }

    ob::ScopedState<> at(const PartState& state) const { return planning::toOmpl(space, spaceKind, state); }
    ob::ScopedState<> at(const Vector3& position, double angle = 0,
                         const Vector3& axis = Vector3::UnitZ()) const {
        PartState state;
        state.position = position;
        state.rotation = Eigen::AngleAxisd(angle, axis);
        return at(state);
    }
    PartState stateOf(const ob::State* state) const { return planning::fromOmpl(spaceKind, state); }
    bool isValid(const Vector3& position) const { return checker->isValid(at(position).get()); }
    bool check(const Vector3& from, const Vector3& to) const {
        return validator->checkMotion(at(from).get(), at(to).get());
    }

    Space spaceKind;
    ob::StateSpacePtr space;
    ob::SpaceInformationPtr si;
    std::shared_ptr<planning::ValidityChecker> checker;
    std::shared_ptr<planning::MotionValidator> validator;
};

}  // namespace clearway::testing
