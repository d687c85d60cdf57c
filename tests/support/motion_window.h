// The plate of the window scene in front of its wall, with a certified motion validator.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "planning/space/ompl_states.h"
#include "support/window_scene.h"

namespace clearway::testing {

/// The plate of the window scene, 60 x 40 x 10, in front of the wall whose near face is at x = -2.
struct MotionWindow {
    explicit MotionWindow(double margin = 0, const planning::MotionOptions& options = {},
                          Space kind = Space::kSe3)
        : space(planning::makeSpace(kind, Box(Vector3(-100, -60, -60), Vector3(100, 60, 60)), 1)),
          si(std::make_shared<ob::SpaceInformation>(space)),
          spaceKind(kind) {
        window.scene.obstacles[0].margin = margin;
        si->setStateValidityChecker(std::make_shared<planning::ValidityChecker>(si, window.scene));
        validator = std::make_shared<planning::MotionValidator>(si, window.scene, options);
        si->setMotionValidator(validator);
        si->setup();
    }

    ob::ScopedState<> at(const Vector3& position, double angle = 0,
                         const Vector3& axis = Vector3::UnitZ()) const {
        PartState state;
        state.position = position;
        state.rotation = Eigen::AngleAxisd(angle, axis);
        return planning::toOmpl(space, spaceKind, state);
    }

    bool check(const ob::ScopedState<>& s1, const ob::ScopedState<>& s2) const {
        return validator->checkMotion(s1.get(), s2.get());
    }
    planning::MotionReport report(const ob::ScopedState<>& s1, const ob::ScopedState<>& s2) const {
        return validator->report(s1.get(), s2.get());
    }

    WindowScene window = windowScene();
    ob::StateSpacePtr space;
    ob::SpaceInformationPtr si;
    Space spaceKind;
    std::shared_ptr<planning::MotionValidator> validator;
};

inline og::PathGeometric pathOf(const MotionWindow& f, const std::vector<ob::ScopedState<>>& states) {
    og::PathGeometric path(f.si);
    for (const ob::ScopedState<>& state : states) path.append(state.get());
    return path;
}

inline planning::MotionOptions withLeastInterval(double length) {
    planning::MotionOptions options;
    options.leastInterval = length;
    return options;
}

}  // namespace clearway::testing
