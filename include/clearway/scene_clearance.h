// Clearances of the part at poses and along motions: the one place where a scene's margins, solids and contact zones
// meet its distances.
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
#include "clearway/sweep.h"

#pragma GCC visibility push(default)

namespace clearway {

namespace planning {
class Motion;
}
class ContactZones;
struct PartState;

/// A motion of the part, such as that between two states of a planner.
struct PartMotion {
    /// The poses are those that the planner interpolates, but for rounding: 2^-47 of the lengths involved.
    MotionPieces pieces;
    /// No point of the part moves further than length |b - a| between the times a and b. Not finite when the states make
    /// no motion.
    double length = 0;
    /// Upper bound, but for rounding, of any point's displacement between the end of the motion and the second state.
    /// Environment units. 0: the motion ends exactly at the second state.
    double endJump = std::numeric_limits<double>::infinity();
};

/// Bounds of one length, in environment units.
struct Bounds {
    double lower = std::numeric_limits<double>::infinity();  ///< the length is at least this
    double upper = std::numeric_limits<double>::infinity();  ///< the length is at most this
};

/// The most zones that a scene can have. A zone is the set of obstacles that share one pair of the flags
/// isIgnoredAtStart and isIgnoredAtGoal. Obstacles with neither flag count at every pose and belong to no
/// zone.
constexpr std::size_t kMostZones = 3;

/// The clearance to the obstacles of one zone at a pose.
struct ZoneClearance {
    /// Distance - margin, environment units; none if these obstacles were not queried. The lower bound is at most 0
    /// where a solid holds the other body.
    std::optional<Bounds> clearance;
    /// How far any vertex of the part may move while the obstacles stay ignored. Below 0 they count.
    Bounds slack{-1, -1};
    /// Whether the obstacles of the zone are ignored at the pose.
    bool isIgnored() const { return slack.lower >= 0; }
};

/// Clearances at a pose: distance - margin, the least over some obstacles, in environment units. An upper bound is
/// infinite where the clearance is beyond the requested cap.
struct Clearances {
    /// Lower bound over the obstacles that count at the pose; infinite without any.
    double lower = std::numeric_limits<double>::infinity();
    /// Upper bound over the obstacles that count at the pose; infinite without any.
    double upper = std::numeric_limits<double>::infinity();
    Bounds always;                                ///< over the obstacles that count at every pose
    std::array<ZoneClearance, kMostZones> zones;  ///< of the others; only the first zoneCount() are used
};

/// The answer of SceneClearance::at about a pose.
struct PoseClearance : Clearances {
    SceneDistance nearest;          ///< the pair that lower and upper belong to; no witness beyond the cap
    std::uint64_t queries = 0;      ///< that the answer took
    bool isInStartContact = false;  ///< the pose is within Scene::startContact
    bool isInGoalContact = false;   ///< the pose is within Scene::goalContact

    /// Whether the pose is free. lower is above 0 exactly when, for all obstacles that count at the pose, the
    /// distance is larger than the margin and no solid holds the other body: lower is at least the least positive
    /// double then, and at most 0 otherwise.
    bool isValid() const { return lower > 0; }
};

/// Why a pose or a motion is not valid. All that clearway says about it is made from this value.
struct WhyInvalid {
    /// The rule that is broken; nameOf() names it.
    enum class Kind {
        kValid,        ///< nothing
        kOutOfBounds,  ///< outside of the state space's bounds
        kCollides,     ///< the part and an obstacle share a point
        kTooDeep,   ///< one touches the other, shrunk one, or is inside: it may reach deeper than the overlap
        kInSolid,   ///< the part is inside a solid obstacle, or such an obstacle inside the part
        kTooClose,  ///< the part and an obstacle are no farther apart than the margin
        kNoPose,    ///< a state has no pose: an entry is not finite, or its matrix is no rotation
        kOutOfRange,  ///< the environment was built with a range that does not hold the pose
        kUnusable,    ///< not to be judged for another reason, such as a callback that threw
        kUndecided    ///< a motion could not be certified near a margin, and no invalid pose of it is known
    };

    /// A coordinate that is out of its bounds; environment units.
    struct Coordinate {
        char name;     ///< 'x', 'y' or 'z'
        double value;  ///< where the part is
        double least;  ///< bound
        double most;   ///< bound
    };

    Kind kind = Kind::kValid;  ///< what is wrong
    /// Index into Scene::obstacles; none unless an obstacle is the reason.
    std::optional<std::size_t> obstacle;
    /// The closest pair of triangles, of kCollides, kTooDeep and kTooClose; none if one is wholly inside the other, shrunk one.
    SceneDistance nearest;
    /// The part's mesh of that pair, or the one in or around the solid: see distinctMeshNames.
    std::string partMesh;
    std::string environmentMesh;  ///< the obstacle's mesh of that pair, or the solid
    /// kInSolid and kTooDeep: the part is in the obstacle; otherwise the obstacle is in the part.
    bool isPartInside = false;
    /// The margin that the distance must exceed; for kTooDeep the allowed depth. Environment units.
    double limit = 0;
    std::optional<Coordinate> coordinate;  ///< of kOutOfBounds in SE(3) and SE(2)
    std::string reason;                    ///< isUnusable(): what was thrown
    std::string unit;                      ///< Scene::unit

    bool isValid() const { return kind == Kind::kValid; }  ///< whether nothing is wrong
    /// Whether the part and an obstacle share a point that they may not share.
    bool isCollision() const {
        return kind == Kind::kCollides || kind == Kind::kTooDeep || kind == Kind::kInSolid;
    }
    /// Whether a pose or a motion could not be judged.
    bool isUnusable() const {
        return kind == Kind::kNoPose || kind == Kind::kOutOfRange || kind == Kind::kUnusable;
    }
    /// The whole reason as words after "is": "in collision: ...". Empty when nothing is wrong.
    std::string words() const;
};

/// Names a kind in one to three words: "valid", "collides", "too close", ...
std::string nameOf(WhyInvalid::Kind kind);

/// How accurately SceneClearance::at must know a clearance. Lengths in environment units.
struct ClearanceOptions {
    /// A clearance above the cap need not be known closer: lower is then at least the cap, but for the
    /// rounding of lower + margin. Without a cap all clearances matter.
    std::optional<double> cap;
    /// Lets lower be less than upper by a tenth of upper. Otherwise both are as tight as distances come.
    bool isRough = false;
    /// Skips the solids that always count: the caller knows that none of them holds the part, nor the part
    /// one of them.
    bool isOutside = false;
    /// Ignored obstacles are queried all the same where the part may move less than this before they count.
    double leastSlack = 0;
};

/// The answer of SceneClearance::stayOutsideSolids. Times are those of the motion, from 0 to 1.
struct SolidsAlong {
    SweepVerdict verdict = SweepVerdict::kCertified;  ///< kCertified: outside all along
    double until = 1;                                 ///< the part is outside up to this time
    std::optional<double> contactTime;  ///< of a pose inside a solid that counts; none if none is known
};

/// Which contact zones hold a pose.
struct ContactsAt {
    bool isInStart = false;  ///< Scene::startContact
    bool isInGoal = false;   ///< Scene::goalContact
};

/// How SceneClearance::sweep looks at a motion; see SweepOptions. Lengths in environment units.
struct SceneSweepOptions {
    double floor = 0;                 ///< clearance required on top of the margins
    double poseError = 0;             ///< how far the poses in question may be off the motion
    double leastInterval = 0;         ///< see SweepOptions
    bool isForward = false;           ///< whether to find how far the motion is certified from its start
    double contactInterval = 0;       ///< SweepOptions::contactTime as a length
    double from = 0;                  ///< earlier times do not matter; >= 0
    double until = 1;                 ///< later times do not matter; at most 1
    bool isContactAtEnd = false;      ///< the pose at `until` is known to be in contact with something
    std::function<bool()> isStopped;  ///< true ends the sweep as undecided; empty: never stopped
};

/// The worst of all obstacles' sweeps.
struct SceneSweep {
    SweepVerdict verdict = SweepVerdict::kCertified;  ///< kCertified: all clearances stay above the floor
    double certifiedUntil = 1;                        ///< when going forward
    std::optional<double> contactTime;                ///< of a pose in contact; none without contact
    std::uint64_t queries = 0;                        ///< sweeps of one obstacle each
};

/// The answer about a rigid motion.
struct MotionAnswer {
    /// kCertified: free all along. kUndecided: somewhere too close to a margin (see check()) or to a contact zone's
    /// boundary, and no pose that is not free is known.
    SweepVerdict verdict = SweepVerdict::kUndecided;
    double certifiedUntil = 0;          ///< free from time 0 to this one, unless the start is not free
    std::optional<double> contactTime;  ///< of a pose that is not free; none if none is known
};

/// How far a part must be moved along a line until it is free, and stays free however far it is moved on. Environment units.
struct EscapeDistance {
    double lower =
        0;  ///< moved by no more than this it is not free, or not all the way on; 0: nothing in the way is known
    double upper = 0;  ///< moved by this or more it is free
};

/// How accurately SceneClearance::leastClearance must know a clearance. Lengths in environment units.
struct LeastClearanceOptions {
    double poseError = 0;              ///< how far the poses in question may be off the motion
    std::optional<double> cap;         ///< larger clearances do not matter, e.g. than those found already
    ClearanceResolution resolution{};  ///< how close the bounds must be; `least` must be set above 0
    std::function<bool()> isStopped;   ///< true ends the search; empty: never stopped
};

/// Bounds of the least clearance along a motion, over the obstacles that count at each pose.
struct LeastClearance {
    /// No pose of the motion has less, provided that upper is above 0 (otherwise the search ends before all obstacles
    /// are searched); environment units.
    double lower = 0;
    double upper = 0;  ///< some pose has no more; the cap when no pose has less
    std::optional<double>
        time;                ///< of a pose with no more than `upper`; none when no pose has less than the cap
    bool isStopped = false;  ///< the search ended early, so lower may be far below upper
    std::uint64_t queries = 0;  ///< searches of one obstacle each
};

/// Answers about poses and motions of a scene's part. Any number of threads may use one object: each has its
/// own scratch and takes no lock.
class SceneClearance {
  public:
    /// Throws ArgumentError when a margin is negative or not finite, an obstacle and the part cannot
    /// be queried together, a contact zone's pose or distance is unusable, or an obstacle needs a contact
    /// zone or solids of the part that the scene lacks.
    explicit SceneClearance(Scene scene);
    ~SceneClearance();
    SceneClearance(const SceneClearance&) = delete;
    SceneClearance& operator=(const SceneClearance&) = delete;

    /// The scene as given.
    const Scene& scene() const { return scene_; }

    /// How many of Clearances::zones are used; 0 to kMostZones.
    std::size_t zoneCount() const { return zoneCount_; }

    /// The largest clearance that queries can find: the least of the environment models' range caps less their
    /// margins, else infinity.
    double mostClearance() const;

    /// True when all distances that count are larger than the margins, and no solid holds the other body.
    /// This function and the next ones throw what queries throw.
    bool isFree(const Pose& X_environmentPart) const;

    /// isFree() of the surfaces alone: ignores solids.
    bool isClearOfSurfaces(const Pose& X_environmentPart) const;

    /// The clearance at a pose, and the pair of triangles that it belongs to. Throws what queries throw.
    PoseClearance at(const Pose& X_environmentPart, const ClearanceOptions& options = {}) const;

    /// Answers isFree() for every pose, in the given order; 1 for true. Blocks of kBatchBlock poses run on as many threads
    /// as oneTBB gives the caller, each without a warm start. Throws what the first pose that is refused makes isFree()
    /// throw.
    std::vector<std::uint8_t> isFreeBatch(const std::vector<Pose>& X_environmentPart) const;

    /// Answers at().lower for every pose, in the given order, as isFreeBatch() does.
    std::vector<double> clearanceBatch(const std::vector<Pose>& X_environmentPart) const;

    /// Which of the scene's contact zones hold a pose.
    ContactsAt contactsAt(const Pose& X_environmentPart) const;

    /// Checks that the part is free all along a rigid motion, however thin an obstacle is. Undecided where it comes within
    /// 1e-5 of the part's diagonal of a margin. poseError: bound of the poses' deviation from the motion, on top of
    /// rounding; environment units, >= 0. Throws ArgumentError when poseError is negative or NaN, and what queries
    /// throw.
    MotionAnswer check(const RigidMotion& motion, double poseError = 0) const;

    /// The escape distance in a direction, of any length above 0, in the environment's frame: the part is moved inwards from outside the
    /// obstacles' boxes, and certified on its way as by check(), so that the bounds are about 1e-5 of the part's diagonal apart, more where
    /// check() is undecided. Works for poses that are free, in collision or inside solids. Throws ArgumentError when the direction is
    /// 0 or not finite, and what queries throw; an obstacle with a range must hold all poses of the motion.
    EscapeDistance escapeDistance(const Pose& X_environmentPart, const Vector3& direction) const;

    /// The pairs of triangles whose distance less the margin is at most the band, or exceeds it by rounding, of all obstacles, whether
    /// or not contact zones ignore them; the least distance less the margin first. Each obstacle's are thinned as nearPairs() says. band:
    /// environment units, >= 0. Throws what queries throw.
    std::vector<SceneDistance> nearPairs(const Pose& X_environmentPart, double band,
                                         NearPairs kept = NearPairs::kAll) const;

    /// Sweeps the part along a motion past all obstacles; ignores solids. Throws what queries and the motion's
    /// callbacks throw.
    SceneSweep sweep(const PartMotion& motion, const SceneSweepOptions& options) const;

    /// Finds the least clearance along a motion, whatever the solids.
    LeastClearance leastClearance(const PartMotion& motion, const LeastClearanceOptions& options) const;

    /// Checks that the part stays outside the solids from time 0 to `until`, when no surfaces touch while their obstacle
    /// counts. The part may be inside a solid all the same: it may have got in while a contact zone ignored the solid.
    /// kUndecided: the motion comes within rounding of a zone's boundary, and no pose inside a solid is known.
    SolidsAlong stayOutsideSolids(const PartMotion& motion, double until, double poseError,
                                  double leastInterval) const;

    /// Whether any obstacle has solids.
    bool hasSolids() const { return hasSolids_; }

    /// Whether poses are inside the same solids if one is reached from the other without crossing a surface that counts. False without
    /// solids.
    bool areSidesKept() const { return areSidesKept_; }

    /// The least distance to any obstacle; ignores margins, solids and contact zones. Throws what queries throw.
    SceneDistance distance(const Pose& X_environmentPart) const;

    /// While it lives, the calling thread's answers begin without a warm start: they are independent, to the last digit, of
    /// what was asked before, and later answers are independent of them.
    class ColdStart {
      public:
        /// Begins for the calling thread.
        explicit ColdStart(const SceneClearance& clearance);
        ~ColdStart();
        ColdStart(const ColdStart&) = delete;
        ColdStart& operator=(const ColdStart&) = delete;

      private:
        bool& isCold_;
        const bool wasCold_;
    };

    /// Why a pose is not valid; ignores the state space's bounds. A pose that queries refuse is kNoPose, kOutOfRange
    /// or, for any other reason, kUnusable.
    WhyInvalid whyInvalid(const Pose& X_environmentPart) const;

    /// Why a pose is not valid, by the answer `found` of at() there. Throws what queries throw.
    WhyInvalid whyInvalid(const Pose& X_environmentPart, const PoseClearance& found) const;

    /// True when an obstacle was built with a range that does not hold the pose, so that queries would throw.
    bool isOutOfRange(const Pose& X_environmentPart) const;

  private:
    friend class planning::Motion;
    class FreePoses;
    struct Scratch;
    struct ThreadScratch;
    struct Asked;
    struct Enclosure;

    bool isClearOfSurfaces(const Pose& X_environmentPart, const PoseClearance& slacks,
                           Scratch& scratch) const;
    bool isOutsideSolids(const Pose& X_environmentPart, const PoseClearance& slacks) const;
    bool isFreeBehind(const Pose& from, const Pose& to) const;
    bool isFree(std::size_t obstacle, const Pose& X_environmentPart, Scratch& scratch) const;
    Asked ask(std::size_t obstacle, const Pose& X_environmentPart, const ClearanceOptions& options,
              Scratch& scratch) const;
    void ask(std::size_t obstacle, const Pose& X_environmentPart, const DistanceOptions& options,
             Scratch& scratch, Asked& answer) const;
    std::optional<Enclosure> enclosureBy(std::size_t obstacle, const Pose& X_environmentPart) const;
    void findEnclosure(const Pose& X_environmentPart, const PoseClearance& at, WhyInvalid& why) const;
    void lookAtSolids(const Pose& X_environmentPart, bool isOutside, PoseClearance& answer) const;
    void nameTriangle(SceneDistance& nearest) const;
    struct TimeRange {
        double from, to;
    };
    void lookBehind(const PartMotion& motion, SceneSweepOptions options, MotionAnswer& answer) const;
    SolidsAlong stayOutsideSolid(std::size_t obstacle, const PartMotion& motion, const SolidsAlong& others,
                                 double poseError, double leastInterval) const;
    SweepVerdict sideAlong(std::size_t obstacle, const PartMotion& motion, const TimeRange& range,
                           double poseError, double leastInterval) const;
    double movedInHalf(const MotionPiece& piece, double halfTime) const;
    MotionPieces piecesFor(std::size_t obstacle, const PartMotion& motion, double poseError) const;

    Scene scene_;
    std::unique_ptr<ContactZones> zones_;
    std::size_t zoneCount_ = 0;
    bool hasSolids_ = false;
    bool areSidesKept_ = false;
    std::unique_ptr<ThreadScratch> scratch_;
};

/// Certifies two states of OMPL's SE(3) and all poses between them, as OMPL interpolates them: straight, with the turn of its slerp,
/// unless that is so little that OMPL leaves it out. Undecided within 1e-5 of the part's diagonal of a margin. Throws
/// ArgumentError unless the quaternions have unit length to within 1e-9, and what queries throw.
SweepVerdict certifySe3Motion(const SceneClearance& clearance, const PartState& from, const PartState& to);

/// Certifies two states of OMPL's SE(2) in the same way. A state is (x, y, yaw): environment units, and radians about z. The part
/// turns the shorter way.
SweepVerdict certifySe2Motion(const SceneClearance& clearance, const Vector3& from, const Vector3& to);

/// Certifies as certifySe3Motion does. Where the motion is not free as a whole, it finds how far it is: up to 1e-3 of the part's
/// diagonal before a contact; certifiedUntil is 0 where `from` is not free.
MotionAnswer followSe3Motion(const SceneClearance& clearance, const PartState& from, const PartState& to);

/// Certifies and finds in the same way, in OMPL's SE(2).
MotionAnswer followSe2Motion(const SceneClearance& clearance, const Vector3& from, const Vector3& to);

/// A proof that no path joins two poses: one lies inside a closed surface, and the other does not.
struct ShutIn {
    std::string obstacle;  ///< the name of the surface's component, else of its file
    bool isStart = false;  ///< the start is inside; otherwise the goal
};

/// Proves that there is no path between two valid poses, or from a pose to the outside of all obstacles where no goal
/// is given. Along a path no point of the part crosses a surface, so that each closed surface has the same winding
/// number about it at both ends; windings are exact. Obstacles that are ignored in a contact zone, or may overlap the
/// part, prove nothing. Returns nothing where nothing is proved.
std::optional<ShutIn> provedShutIn(const Scene& scene, const Pose& start, const std::optional<Pose>& goal);

/// Queries of scenes, and their work.
struct QueryTally {
    std::uint64_t distances = 0;  ///< distances to one obstacle each
    std::uint64_t withins = 0;    ///< whether the part is in contact, or within a margin
    std::uint64_t sweeps = 0;     ///< sweeps past one obstacle each
    QueryCounters work;           ///< the work of all these queries
};

/// Returns the tally of the calling thread's queries, of all scenes, and starts a new one at 0.
QueryTally takeQueryTally();

/// Names of the two meshes of a pair: a component's name, else its file's. Both are empty when `nearest` has
/// no witness.
struct MeshNames {
    std::string part;         ///< the mesh of the part
    std::string environment;  ///< the mesh of the obstacle
};

/// The names of the two meshes that `nearest` is about.
MeshNames meshNames(const Scene& scene, const SceneDistance& nearest);

/// The names of the two meshes for people. Equal ones begin with their files' names, "plug.stl/Body" and "socket.stl/Body", or with the
/// files' paths when their names are equal, too; meshes without a file keep equal names.
MeshNames distinctMeshNames(const Scene& scene, const SceneDistance& nearest);

}  // namespace clearway

#pragma GCC visibility pop
