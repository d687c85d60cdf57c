// The three questions about a part at a pose: how far, touching, within d.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "clearway/types.h"

namespace clearway {

class Model;

/// Exact counts of the work one query did.
struct QueryCounters {
    std::uint64_t nodeVisits = 0;         ///< wide nodes whose children were tested against a volume
    std::uint64_t volumeTests = 0;        ///< pairs of volumes among those (used lanes)
    std::uint64_t triangleTests = 0;      ///< pairs of triangles given to a kernel
    std::uint64_t refinedPairs = 0;       ///< pairs of triangles resolved in double
    std::uint64_t doubleDoublePairs = 0;  ///< of these, pairs that double left open or too wide
    std::uint64_t exactPairs = 0;         ///< of these, pairs that double-double left open or too wide
    /// Places for pairs in the blocks of 16 that triangleTests were laid out in: how full leaves make them.
    std::uint64_t triangleLanes = 0;
    std::uint64_t kernelPairs = 0;  ///< of triangleTests, pairs that cheap bounds left to the full kernel
    std::uint64_t kernelLanes = 0;  ///< of the registers these were in; depends on the instruction set

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

/// The scratch of one thread and its warm start: the closest pair of the last query, with which the next
/// query of the same two models begins. Verdicts do not depend on what it holds, nor do intervals, but for
/// last digits; which of several equally close pairs is named may. Not to be shared by threads. One that was
/// moved from may only be assigned to or destroyed.
class Workspace {
  public:
    Workspace();
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;

    /// Makes the next query a cold one.
    void forgetWarmStart();

    /// Of the last query.
    const QueryCounters& counters() const;

    struct State;
    State& state() { return *state_; }  ///< for the query layer only

  private:
    std::unique_ptr<State> state_;
};

struct DistanceOptions {
    /// The answer may be as wide as the larger of absoluteError and relativeError * lower; 0 and 0 ask for
    /// the default width: 1e-12 of the scene size (the diagonals of both meshes' boxes) and 32 * 2^-53 of the
    /// largest coordinate among both meshes, the moved part and the pose's translation. Both >= 0.
    double relativeError = 0;
    double absoluteError = 0;
    /// No interest beyond: when the distance is proved larger, lower >= cap, upper and distance are infinite,
    /// ids are -1 and the witness points NaN; an interval that holds the cap is answered as without one, and
    /// isWithin(cap) decides. >= 0. An environment with a reach lowers it to its own cap.
    double cap = std::numeric_limits<double>::infinity();
};

/// lower <= true distance <= upper, where the truth is that of the stored doubles of both meshes and the
/// pose, an affine map. Both are 0 on contact; else upper is above 0. Lengths in environment units, points in
/// the environment's frame.
struct DistanceResult {
    double lower = 0;
    double upper = 0;
    double distance = 0;  ///< between the two witness points, 0 on contact
    Vector3 pointOnPart = Vector3::Zero();
    Vector3 pointOnEnvironment = Vector3::Zero();
    std::int64_t partTriangle = -1;  ///< position as loaded, before cleaning
    std::int64_t environmentTriangle = -1;
    std::int64_t partComponent = -1;  ///< index into Model::components()
    std::int64_t environmentComponent = -1;
    QueryCounters counters;

    bool collides() const { return upper == 0; }
};

/// Distance between the part's triangles, moved by X_environmentPart, and the environment's. 0 when they
/// share a point. Throws std::invalid_argument when the pose is no rotation (see requirePose), an option is
/// negative or NaN, the two models have different node widths, or their sizes, or the way between them and a
/// size, differ by more than 2^60, or the largest coordinate among theirs and the pose's is 1e298 or more, or
/// above 0 and below 1e-298; also when the part has a reach, or the environment has one that does not hold
/// the pose's translation or the part's radius (see Model::reach).
DistanceResult distance(const Model& part, const Model& environment, const Pose& X_environmentPart,
                        const DistanceOptions& options, Workspace& workspace);

/// True exactly when the two share a point: decided in double, in double-double where that leaves it open,
/// and in whole numbers of any size where that does. Agrees with distance() and isWithin(0). Throws likewise.
bool collides(const Model& part, const Model& environment, const Pose& X_environmentPart,
              Workspace& workspace);

/// True exactly when the distance is <= d, in environment units, decided likewise. d >= 0. Throws likewise,
/// and when d is larger than the cap of the environment's reach.
bool isWithin(const Model& part, const Model& environment, const Pose& X_environmentPart, double d,
              Workspace& workspace);

}  // namespace clearway
