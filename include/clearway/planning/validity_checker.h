// OMPL's StateValidityChecker: whether the part is free at a state, and its clearance there.
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include <cstdint>
#include <memory>

#include "clearway/planning/shared_scene.h"
#include "clearway/query.h"
#include "clearway/scene.h"
#include "clearway/scene_clearance.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

class PosedScene;

/// Counts since the checker was made.
struct CheckCounters {
    std::uint64_t checks = 0;       ///< states checked
    std::uint64_t invalid = 0;      ///< answered invalid, for whatever reason
    std::uint64_t outOfBounds = 0;  ///< of these, outside the space's bounds
    /// Invalid states without a pose or outside an environment's range, or whose callback threw.
    std::uint64_t unusable = 0;
};

/// Judges states. A state is valid when it is within the space's bounds, the distance between the part and each
/// obstacle that counts there (see ContactZone) is larger than the obstacle's margin, and no solid holds the other
/// body (see Obstacle::solids). With margin 0 the two must share no point.
///
/// Any number of threads may use one checker: each has its own scratch and takes no lock. The checker throws
/// nothing out of OMPL's callbacks: it answers a state without a pose as invalid, counts it, and logs the
/// first one through OMPL's console.
class ValidityChecker : public ompl::base::StateValidityChecker {
  public:
    /// A Scene, or a SharedScene that others share. Throws ArgumentError when si is null or has another space than
    /// OMPL's SE(3) and SE(2) and the scene no callback for it (see stateToPose), a margin is negative or not finite, or the
    /// part and an obstacle cannot be queried together. An environment built with a range (Model::range) must hold all
    /// positions within the bounds: a state within the bounds and out of the range is answered invalid, as one without a
    /// pose.
    ValidityChecker(const ompl::base::SpaceInformationPtr& si, SharedScene scene);

    /// Whether the state is valid. Counted.
    bool isValid(const ompl::base::State* state) const override;

    /// Gives both answers by one query. clearance: as clearance() returns it.
    bool isValid(const ompl::base::State* state, double& clearance) const override;

    /// Gives both answers; the checker never offers a state in a valid direction.
    bool isValid(const ompl::base::State* state, double& clearance, ompl::base::State* validState,
                 bool& validStateAvailable) const override;

    /// A lower bound of distance - margin, the least over the obstacles, in environment units. It is above 0
    /// exactly when the state is valid: it is raised to the least positive double for a valid state and
    /// lowered to at most 0 for another one. It is no penetration depth. An environment's range limits it to
    /// the range's cap - margin.
    double clearance(const ompl::base::State* state) const override;
    using ompl::base::StateValidityChecker::clearance;

    /// Least distance, witness points and triangles at a state, whatever the bounds and the margins say.
    /// Throws ArgumentError when the state has no pose or is out of the environment's range.
    SceneDistance distance(const ompl::base::State* state) const;

    /// Why a state is not valid: out of the bounds or, within them, what SceneClearance::whyInvalid says. Not counted.
    WhyInvalid whyInvalid(const ompl::base::State* state) const;

    /// X_environmentPart at a state, by the checker's own callback.
    Pose pose(const ompl::base::State* state) const;

    /// The scene that states are judged in.
    const Scene& scene() const;

    /// The scene, to be shared with a validator or an objective.
    const SharedScene& shared() const;

    /// Counts of all threads' questions to this checker.
    CheckCounters counters() const;

  private:
    enum class Usable { kYes, kOutOfBounds, kNoPose };
    Usable findPose(const ompl::base::State* state, Pose& X_environmentPart) const;
    bool count(bool valid, Usable usable) const;
    void warn(const char* reason) const;
    bool unusable(const char* reason) const;

    std::shared_ptr<const PosedScene> posed_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
