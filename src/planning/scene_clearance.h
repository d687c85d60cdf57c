// How much room the part has at a pose: the one place where a scene's margin meets its distances.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "clearway/query.h"
#include "clearway/scene.h"

namespace clearway::planning {

/// Bounds of distance - margin at a pose, environment units.
struct PoseClearance {
    /// Above 0 exactly when the distance is larger than the margin: raised to the least positive double then,
    /// lowered to at most 0 otherwise.
    double lower = 0;
    double upper = 0;           ///< infinite beyond the cap
    DistanceResult nearest;     ///< the pair they are of; its ids are -1 beyond the cap
    std::uint64_t queries = 0;  ///< asked for it
    bool isValid() const { return lower > 0; }
};

struct ClearanceOptions {
    /// No interest beyond: when the clearance is larger, lower >= cap but for the rounding of lower + margin.
    double cap = std::numeric_limits<double>::infinity();
    /// lower may be less than upper by a tenth of upper; else both are as tight as distances come.
    bool isRough = false;
};

/// Any number of threads may use one: each has its own scratch.
class SceneClearance {
  public:
    /// Throws std::invalid_argument when the margin is negative or not finite, or the two models cannot be
    /// queried together.
    explicit SceneClearance(Scene scene);

    const Scene& scene() const { return scene_; }

    /// No clearance is told beyond this: what an environment's reach tells, else infinity.
    double mostClearance() const;

    /// Whether the distance is larger than the margin. This and the others throw what queries throw.
    bool isFree(const Pose& X_environmentPart) const;

    PoseClearance at(const Pose& X_environmentPart, const ClearanceOptions& options = {}) const;

    /// Whatever the margin.
    DistanceResult distance(const Pose& X_environmentPart) const;

    /// Whether an environment built with a reach cannot tell anything about the pose.
    bool isOutOfReach(const Pose& X_environmentPart) const;

  private:
    void ask(const Pose& X_environmentPart, const DistanceOptions& options, PoseClearance& answer) const;

    Scene scene_;
    std::shared_ptr<const std::uint64_t>
        owner_;  ///< names this scene's scratch in each thread; tells when it is gone
};

}  // namespace clearway::planning
