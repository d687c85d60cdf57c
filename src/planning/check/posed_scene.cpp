#include "planning/check/posed_scene.h"

#include <ompl/util/Console.h>

#include <utility>

#include "clearway/errors.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

PosedScene::PosedScene(const ob::SpaceInformationPtr& si, SharedScene shared, For what)
    : si_(si.get()),
      shared_(std::move(shared)),
      areBoundsConvex_(!shared_.stateToPose()),
      stateToPose_(areBoundsConvex_ ? planning::stateToPose(spaceOf(si)) : shared_.stateToPose()),
      bound_(shared_.bound()),
      motion_(shared_.motion()) {
    spaceOf(si);
    if (what == For::kStates) return;
    if (areBoundsConvex_) {
        bound_ = displacementBound(*si->getStateSpace(), scene().part);
        motion_ = stateMotion(si->getStateSpace(), scene().part);
    } else if (!bound_) {
        throw ArgumentError("the displacement bound is empty, expected a function");
    }
}

WhyInvalid PosedScene::whyInvalid(const ob::State* state) const {
    try {
        if (!si_->satisfiesBounds(state)) return whyOutOfBounds(space(), state);
        const Pose X_environmentPart = pose(state);
        WhyInvalid why = clearance().whyInvalid(X_environmentPart);
        if (!why.isValid() || rotationDefect(X_environmentPart) <= kPoseDefect) return why;
        why.kind =
            WhyInvalid::Kind::kNoPose;  // a scene without obstacles asks no query, which would refuse it
        why.reason = "the state has no pose";
        return why;
    } catch (const std::exception& error) {
        WhyInvalid why;
        why.kind = WhyInvalid::Kind::kUnusable;
        why.reason = error.what();
        return why;
    }
}

void PosedScene::warnOnce(const char* what, const char* why) const {
    if (hasWarned_.exchange(true, std::memory_order_relaxed)) return;
    OMPL_WARN("clearway: %s: %s. Further ones are only counted.", what, why);
}

}  // namespace clearway::planning
