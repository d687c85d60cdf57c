// A scene as the states of a planner's space see it, for the checker, the validator and the objectives to share.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>
#include <memory>
#include <optional>

#include "clearway/model.h"
#include "clearway/planning/displacement_bound.h"
#include "clearway/planning/state_to_pose.h"
#include "clearway/scene_clearance.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Returns the motion between two states, which outlive it; one thread uses the motion. It is called from several threads at
/// once.
using StateMotion = std::function<PartMotion(const ompl::base::State* from, const ompl::base::State* to)>;

/// The motions of OMPL's SE(3) and SE(2): straight, with a turn at a constant rate about an axis fixed in the part. Turns
/// that OMPL may leave out, below 2e-4 rad, are not trusted: they may happen or not. Throws ArgumentError that names
/// the space when it is another one, even one derived from these.
StateMotion stateMotion(const ompl::base::StateSpacePtr& space, const Model& part);

/// A scene, with the callbacks that turn a space's states into poses and motions of its part. Copies share one
/// SceneClearance, so a thread's query has the warm start of its previous query, whichever copy made it. A Scene
/// converts to a SharedScene of its own.
///
/// ```
/// const SharedScene shared(scene);
/// si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, shared));
/// si->setMotionValidator(std::make_shared<MotionValidator>(si, shared));
/// ```
class SharedScene {
  public:
    /// For OMPL's SE(3) and SE(2): poses and motions are those of the space. Throws as SceneClearance does.
    SharedScene(Scene scene);

    /// Shares a SceneClearance with its other users. Throws ArgumentError when it is null.
    SharedScene(std::shared_ptr<const SceneClearance> clearance);

    /// For any space. Motions need a bound, in environment units. Without a StateMotion, pairs of volumes are
    /// certified by the bound alone. The poses of interpolated states may differ only by rounding from those that the
    /// bound is made for: by at most 2^-47 of the lengths involved. Throws ArgumentError when a callback that is
    /// given is empty.
    SharedScene(const SharedScene& scene, StateToPose stateToPose,
                std::optional<DisplacementBound> bound = {}, std::optional<StateMotion> motion = {});

    /// The scene as given.
    const Scene& scene() const { return clearance_->scene(); }

    /// The object that answers the queries of all copies; never null.
    const std::shared_ptr<const SceneClearance>& clearance() const { return clearance_; }

    /// The callbacks; empty where none was given.
    const StateToPose& stateToPose() const { return stateToPose_; }
    const DisplacementBound& bound() const { return bound_; }  ///< see stateToPose()
    const StateMotion& motion() const { return motion_; }      ///< see stateToPose()

  private:
    std::shared_ptr<const SceneClearance> clearance_;
    StateToPose stateToPose_;
    DisplacementBound bound_;
    StateMotion motion_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
