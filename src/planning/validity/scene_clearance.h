// How much room the part has at a pose: the one place where a scene's margins, solids and contact zones meet
// its distances.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/query.h"
#include "clearway/scene.h"
#include "planning/validity/thread_scratch.h"

namespace clearway::planning {

/// The obstacles with one pair of the flags isIgnoredAtStart and isIgnoredAtGoal. Those with neither count at
/// every pose and are no zone's.
constexpr std::size_t kMostZones = 3;

/// How much room a zone's obstacles leave at a pose, environment units.
struct ZoneRoom {
    /// Lower bound of distance - margin. At most 0 where a solid holds the other; kUnknownClearance when it
    /// was not asked.
    double clearance = 0;
    /// How far any vertex of the part may move and the obstacles stay ignored for sure; below 0 they count.
    double spare = -1;
    bool isIgnored() const { return spare >= 0; }
};

struct ZoneClearance : ZoneRoom {
    double upper = std::numeric_limits<double>::infinity();  ///< infinite beyond the cap, or not asked
    double mostSpare = -1;                                   ///< they stay ignored no further
};
constexpr double kUnknownClearance = -1e300;

/// Bounds of distance - margin at a pose, the least over the obstacles that count there, environment units.
struct PoseClearance {
    /// Above 0 exactly when all distances are larger than the margins and no solid holds the other: raised to
    /// the least positive double then, lowered to at most 0 otherwise. Infinite without obstacles.
    double lower = std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();  ///< infinite beyond the cap too
    SceneDistance nearest;      ///< the pair they are of; its ids are -1 beyond the cap
    std::uint64_t queries = 0;  ///< asked for it

    double lowerAlways = std::numeric_limits<double>::infinity();  ///< of the obstacles that always count
    double upperAlways = std::numeric_limits<double>::infinity();
    std::array<ZoneClearance, kMostZones> zones;             ///< the first zoneCount() of them
    bool isInStartContact = false, isInGoalContact = false;  ///< within the scene's contact zones

    bool isValid() const { return lower > 0; }
};

struct ClearanceOptions {
    /// No interest beyond: when the clearance is larger, lower >= cap but for the rounding of lower + margin.
    double cap = std::numeric_limits<double>::infinity();
    /// lower may be less than upper by a tenth of upper; else both are as tight as distances come.
    bool isRough = false;
    /// Solids that always count are not looked at: it is known that none holds the part, nor the part one.
    bool isOutside = false;
    /// Ignored obstacles are asked all the same where the part may move less than this and they count again.
    double leastSpare = 0;
};

/// Any number of threads may use one: each has its own scratch.
class SceneClearance {
  public:
    /// Throws std::invalid_argument when a margin is negative or not finite, an obstacle and the part cannot
    /// be queried together, a contact zone is none, or an obstacle's zone or what its solids need is missing.
    explicit SceneClearance(Scene scene);

    const Scene& scene() const { return scene_; }
    std::size_t zoneCount() const { return zones_.size(); }

    /// No clearance is told beyond this: what an environment's reach tells, else infinity.
    double mostClearance() const;

    /// Whether all distances that count are larger than the margins, and no solid holds the other. This and
    /// the others throw what queries throw.
    bool isFree(const Pose& X_environmentPart) const;

    PoseClearance at(const Pose& X_environmentPart, const ClearanceOptions& options = {}) const;

    /// The least of all obstacles, whatever the margins, solids and contact zones.
    SceneDistance distance(const Pose& X_environmentPart) const;

    /// So that the calling thread's next answer is the same to the last digit whatever it asked before.
    void forgetWarmStart() const;

    /// Why a pose is not valid, whatever the bounds, as words after "is", with meshes and triangles. Empty
    /// when it is.
    std::string whyInvalid(const Pose& X_environmentPart) const;

    /// Whether an obstacle built with a reach cannot tell anything about the pose.
    bool isOutOfReach(const Pose& X_environmentPart) const;

  private:
    struct Zone {
        bool atStart, atGoal;
    };
    struct Enclosure {
        const std::string* obstacleMesh;
        const std::string* partMesh;
        bool isPartInside;
    };

    void addZone(std::size_t obstacle);
    ThreadScratch& scratch() const { return threadScratch(owner_, scene_.obstacles.size()); }
    struct Spare {
        double least = -1, most = -1;
    };
    Spare spareOf(const std::optional<ContactZone>& contact, const Pose& X_environmentPart) const;
    /// Fills in how far each zone's obstacles stay ignored.
    void findSpares(const Pose& X_environmentPart, PoseClearance& answer) const;
    bool isIgnored(std::size_t obstacle, const PoseClearance& at) const;
    bool isFree(std::size_t obstacle, const Pose& X_environmentPart) const;
    /// "the part's mesh 'a' is inside the solid 'b'", or the other way round: of obstacles that count, where
    /// no surfaces touch. Else empty.
    std::string enclosure(const Pose& X_environmentPart) const;
    std::optional<Enclosure> enclosureBy(std::size_t obstacle, const Pose& X_environmentPart) const;
    void lookAtSolids(const Pose& X_environmentPart, bool isOutside, PoseClearance& answer) const;
    /// Of one obstacle, wherever it counts.
    struct Asked {
        double lower, upper;
        SceneDistance nearest;
        std::uint64_t queries = 0;
    };
    Asked ask(std::size_t obstacle, const Pose& X_environmentPart, const ClearanceOptions& options) const;
    void ask(std::size_t obstacle, const Pose& X_environmentPart, const DistanceOptions& options,
             Asked& answer) const;
    static bool isNearer(const Asked& found, const PoseClearance& sofar);
    void nameTriangle(SceneDistance& nearest) const;

    Scene scene_;
    std::vector<Zone> zones_;
    std::vector<int> zoneOf_;  ///< of each obstacle; -1: it always counts
    bool hasSolids_ = false;
    std::shared_ptr<const std::uint64_t>
        owner_;  ///< names this scene's scratch in each thread; tells when it is gone
};

}  // namespace clearway::planning
