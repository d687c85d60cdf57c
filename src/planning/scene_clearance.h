// How much room the part has at a pose: the one place where a scene's margins meet its distances.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "clearway/query.h"
#include "clearway/scene.h"
#include "planning/thread_scratch.h"

namespace clearway::planning {

/// Bounds of distance - margin at a pose, the least over the obstacles, environment units.
struct PoseClearance {
    /// Above 0 exactly when all distances are larger than the margins: raised to the least positive double
    /// then, lowered to at most 0 otherwise. Infinite without obstacles.
    double lower = std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();  ///< infinite beyond the cap too
    SceneDistance nearest;      ///< the pair they are of; its ids are -1 beyond the cap
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
    /// Throws std::invalid_argument when a margin is negative or not finite, or an obstacle and the part
    /// cannot be queried together.
    explicit SceneClearance(Scene scene);

    const Scene& scene() const { return scene_; }

    /// No clearance is told beyond this: what an environment's reach tells, else infinity.
    double mostClearance() const;

    /// Whether all distances are larger than the margins. This and the others throw what queries throw.
    bool isFree(const Pose& X_environmentPart) const;

    PoseClearance at(const Pose& X_environmentPart, const ClearanceOptions& options = {}) const;

    /// The least, whatever the margins.
    SceneDistance distance(const Pose& X_environmentPart) const;

    /// So that the calling thread's next answer is the same to the last digit whatever it asked before.
    void forgetWarmStart() const;

    /// Whether an obstacle built with a reach cannot tell anything about the pose.
    bool isOutOfReach(const Pose& X_environmentPart) const;

  private:
    ThreadScratch& scratch() const { return threadScratch(owner_, scene_.obstacles.size()); }
    bool isFree(std::size_t obstacle, const Pose& X_environmentPart) const;
    PoseClearance ask(std::size_t obstacle, const Pose& X_environmentPart,
                      const ClearanceOptions& options) const;
    PoseClearance ask(std::size_t obstacle, const Pose& X_environmentPart,
                      const DistanceOptions& options) const;
    void nameTriangle(SceneDistance& nearest) const;

    Scene scene_;
    std::shared_ptr<const std::uint64_t>
        owner_;  ///< names this scene's scratch in each thread; tells when it is gone
};

}  // namespace clearway::planning
