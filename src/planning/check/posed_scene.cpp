#include "planning/check/posed_scene.h"

#include <ompl/util/Console.h>

#include <stdexcept>
#include <utility>

#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

template <class Callback>
Callback requireCallback(Callback callback, const char* name) {
    if (callback) return callback;
    throw std::invalid_argument(std::string(name) + " is empty, expected a function");
}

StateToPose require(StateToPose callback) {
    return requireCallback(std::move(callback), "stateToPose");
}
DisplacementBound require(DisplacementBound callback) {
    return requireCallback(std::move(callback), "the displacement bound");
}

}  // namespace

PosedScene::PosedScene(const ompl::base::SpaceInformationPtr& si, Scene scene)
    : PosedScene(si, scene, planning::stateToPose(spaceOf(si)), displacementBound(spaceOf(si), scene.part)) {
    areBoundsConvex_ = true;
    motion_ = stateMotion(si->getStateSpace(), clearance_->scene().part);
}

PosedScene::PosedScene(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                       DisplacementBound bound, StateMotion motion)
    : PosedScene(si, std::move(scene), std::move(stateToPose)) {
    bound_ = require(std::move(bound));
    motion_ = std::move(motion);
}

PosedScene::PosedScene(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose)
    : si_(si.get()), stateToPose_(require(std::move(stateToPose))) {
    spaceOf(si);
    clearance_.emplace(std::move(scene));
}

WhyInvalid PosedScene::whyInvalid(const ompl::base::State* state) const {
    try {
        if (!si_->satisfiesBounds(state)) return whyOutOfBounds(space(), state);
        return clearance_->whyInvalid(pose(state));
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
