#include "clearway/planning/shared_scene.h"

#include <string>
#include <utility>

#include "clearway/errors.h"

namespace clearway::planning {
namespace {

template <class Callback>
Callback requireGiven(Callback callback, const char* name) {
    if (callback) return callback;
    throw ArgumentError(std::string(name) + " is empty, expected a function");
}

}  // namespace

SharedScene::SharedScene(Scene scene)
    : clearance_(std::make_shared<const SceneClearance>(std::move(scene))) {}

SharedScene::SharedScene(std::shared_ptr<const SceneClearance> clearance) : clearance_(std::move(clearance)) {
    if (!clearance_) throw ArgumentError("the scene clearance is null, expected that of a scene");
}

SharedScene::SharedScene(const SharedScene& scene, StateToPose stateToPose,
                         std::optional<DisplacementBound> bound, std::optional<StateMotion> motion)
    : clearance_(scene.clearance_), stateToPose_(requireGiven(std::move(stateToPose), "stateToPose")) {
    if (bound) bound_ = requireGiven(std::move(*bound), "the displacement bound");
    if (motion) motion_ = requireGiven(std::move(*motion), "the state motion");
}

}  // namespace clearway::planning
