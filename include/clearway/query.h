// The three queries about a part at a pose: its distance from the environment, whether the two touch, and
// whether the distance is at most d.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

class Model;
struct WorkspaceAccess;

/// Exact counts of the work of one query.
struct QueryCounters {
    std::uint64_t nodeVisits = 0;         ///< nodes whose children were tested against a volume
    std::uint64_t volumeTests = 0;        ///< pairs of volumes in these tests (used lanes)
    std::uint64_t triangleTests = 0;      ///< pairs of triangles given to the leaf kernels
    std::uint64_t refinedPairs = 0;       ///< pairs of triangles resolved in double
    std::uint64_t doubleDoublePairs = 0;  ///< refined pairs that double left open or too wide
    std::uint64_t exactPairs = 0;         ///< refined pairs that double-double, too, left open or too wide
    /// Places for pairs in the blocks of 16 that hold the triangleTests; the ratio of the two says how full
    /// the leaves make the blocks.
    std::uint64_t triangleLanes = 0;
    std::uint64_t kernelPairs = 0;  ///< triangleTests that cheap bounds left to the full kernel
    std::uint64_t kernelLanes = 0;  ///< lanes of these pairs' registers; depends on the instruction set

    /// Adds the counts of other queries.
    QueryCounters& operator+=(const QueryCounters& other) {
        nodeVisits += other.nodeVisits;
        volumeTests += other.volumeTests;
        triangleTests += other.triangleTests;
        refinedPairs += other.refinedPairs;
        doubleDoublePairs += other.doubleDoublePairs;
        exactPairs += other.exactPairs;
        triangleLanes += other.triangleLanes;
        kernelPairs += other.kernelPairs;
        kernelLanes += other.kernelLanes;
        return *this;
    }
};

/// The scratch memory of one thread, and its warm start for the same two models: a distance begins with the nearest of the
/// closest pairs of up to 64 earlier distances, other queries with the last pair that answered. The contents of a workspace never change verdicts, and intervals
/// only in last digits; they may change which of several equally close pairs is named. Threads must not share a
/// workspace. A build with assertions aborts when two threads use one at once; other builds do not check. A
/// moved-from workspace may only be assigned to or destroyed.
class Workspace {
  public:
    /// A workspace without a warm start. Queries allocate the memory that they need, and keep it.
    Workspace();
    ~Workspace();
    /// Takes over the other workspace's memory and warm start.
    Workspace(Workspace&&) noexcept;
    /// Takes over the other workspace's memory and warm start, and drops its own.
    Workspace& operator=(Workspace&&) noexcept;

    /// Drops the warm start: the next query starts cold.
    void forgetWarmStart();

    /// The counters of the last query.
    const QueryCounters& counters() const;

    struct State;  ///< the memory

  private:
    friend struct WorkspaceAccess;
    std::unique_ptr<State> state_;
};

/// A Workspace bound to the thread that creates it, for bindings to languages whose threads share objects.
class OwnedWorkspace {
  public:
    Workspace& mine();  ///< throws ArgumentError in every other thread

  private:
    const std::thread::id owner_ = std::this_thread::get_id();
    Workspace workspace_;
};

/// How accurate a distance must be, and from where on it does not matter.
struct DistanceOptions {
    /// The interval [lower, upper] may be as wide as the largest of absoluteError, relativeError * lower and
    /// the default width. The default width is 1e-12 of the scene size (the sum of the diagonals of both
    /// meshes' boxes) plus 32 * 2^-53 of the largest coordinate among both meshes, the moved part and the
    /// pose's translation. Both options must be >= 0.
    double relativeError = 0;
    double absoluteError = 0;  ///< environment units; see relativeError
    /// Distances above the cap do not matter; without a cap all do. If the distance is proved larger, then lower >= cap, upper and
    /// distance are infinite, and there is no witness. An interval that contains the cap is
    /// answered as if there were no cap; isWithin(cap) decides such a case. Must be >= 0. An environment with
    /// a range lowers the cap to its own.
    std::optional<double> cap;
};

/// Two triangles that are a distance apart, and a point on each. Points are in the environment's frame.
struct Witness {
    Vector3 pointOnPart = Vector3::Zero();         ///< on the part's triangle
    Vector3 pointOnEnvironment = Vector3::Zero();  ///< on the environment's triangle
    std::int64_t partTriangle = 0;                 ///< position in the mesh as loaded, before cleaning
    std::int64_t environmentTriangle = 0;          ///< position in the mesh as loaded, before cleaning
    std::int64_t partComponent = 0;                ///< index into the part's Model::components()
    std::int64_t environmentComponent = 0;         ///< index into the environment's Model::components()
};

/// A distance as an interval: lower <= true distance <= upper. The true distance is the exact distance
/// between the stored doubles of the environment and those of the part as moved by the pose, which is taken
/// as an affine map. On contact lower and upper are 0, otherwise upper is above 0. Lengths are in environment
/// units.
struct DistanceResult {
    double lower = 0;                ///< never above the true distance; 0 on contact
    double upper = 0;                ///< never below the true distance; 0 exactly on contact
    double distance = 0;             ///< between the witness points; 0 on contact, infinite without a witness
    std::optional<Witness> witness;  ///< a closest pair; none beyond the cap
    QueryCounters counters;          ///< the work that the answer took

    /// Whether part and environment share a point.
    bool collides() const { return upper == 0; }
};

/// The distance between the part's triangles, moved by X_environmentPart, and the environment's triangles; 0
/// if they share a point. Throws ArgumentError if
///  - the pose is not a rotation and a translation (see requirePose),
///  - an option is negative or NaN,
///  - the two models have different node widths,
///  - the models' sizes, or the distance between the models and a size, differ by a factor of more than 2^60,
///  - the largest coordinate of both models and the pose is 1e298 or more, or above 0 and below 1e-298,
///  - the part has a range, or the environment has a range that does not contain the pose's translation or
///    the part's radius (see Model::range).
DistanceResult distance(const Model& part, const Model& environment, const Pose& X_environmentPart,
                        const DistanceOptions& options, Workspace& workspace);

/// Whether the part and the environment share a point, exactly: decided in double, where double leaves it
/// open in double-double, and where that leaves it open in integers of any size. Agrees with distance() and
/// isWithin(0). Throws ArgumentError under the same conditions as distance().
bool collides(const Model& part, const Model& environment, const Pose& X_environmentPart,
              Workspace& workspace);

/// Whether the distance is <= d, exactly, decided in the same steps as collides(). d: environment units, >=
/// 0. Throws ArgumentError under the same conditions as distance(), and if d is larger than the cap
/// of the environment's range.
bool isWithin(const Model& part, const Model& environment, const Pose& X_environmentPart, double d,
              Workspace& workspace);

/// Which of the pairs nearby nearPairs() returns.
enum class NearPairs {
    kAll,         ///< all, thinned only where they are very many
    kLocalMinima  ///< those of them from which no step into a neighbouring triangle leads to a nearer pair
};

/// The pairs of triangles whose distance is at most the band, or exceeds it by less than the default width of an interval; the nearest
/// first. Of more than kAllNearPairs pairs only the nearest of each pair of leaves is kept, of more than kLeafNearPairs the nearest of
/// each leaf of the part, as bounds in float tell: the nearest pair of all is always among those kept. band: environment
/// units, >= 0. counters is that of the whole query in the first result, and 0 in the others. Throws ArgumentError under the same
/// conditions as isWithin(band).
std::vector<DistanceResult> nearPairs(const Model& part, const Model& environment,
                                      const Pose& X_environmentPart, double band, Workspace& workspace,
                                      NearPairs kept = NearPairs::kAll);

constexpr std::size_t kAllNearPairs = 3000;    ///< see nearPairs
constexpr std::size_t kLeafNearPairs = 30000;  ///< see nearPairs

/// How a distance changes as the part moves: by translation . v + rotation . w for small displacements, first the
/// translation v of the whole part, and the rotation vector w about a centre. Environment's frame.
struct DistanceGradient {
    Vector3 translation;  ///< unit; per environment unit
    Vector3 rotation;     ///< environment units per radian
};

/// The gradient of the distance of one pair of nearPairs(), or of a distance, by its two points. Where several pairs are
/// equally near, the distance changes as that of the pair that comes closest does: the derivative is one-sided, and each of
/// the pairs has its own gradient. centre: of rotations; environment's frame. None on contact and without a witness.
std::optional<DistanceGradient> distanceGradient(const DistanceResult& pair, const Vector3& centre);

/// distance() with a workspace of the calling thread, which lives as long as the thread.
DistanceResult distance(const Model& part, const Model& environment, const Pose& X_environmentPart,
                        const DistanceOptions& options = {});

/// collides() with the workspace of the calling thread.
bool collides(const Model& part, const Model& environment, const Pose& X_environmentPart);

/// isWithin() with the workspace of the calling thread.
bool isWithin(const Model& part, const Model& environment, const Pose& X_environmentPart, double d);

}  // namespace clearway

#pragma GCC visibility pop
