// The sweep on trees: pairs of volumes over intervals of time.
#pragma once

#include <functional>

#include "clearway/sweep.h"
#include "query/queries.h"

namespace clearway {

/// The question to a sweep.
enum class SweepGoal {
    kCertify,        ///< whether all times are certified; ends at the first contact
    kForward,        ///< how far the motion is certified from its start
    kLeastDistance,  ///< how near the part comes
};

/// A distance less the margin that a pair has at a time.
struct PairAtTime {
    double clearance = std::numeric_limits<double>::infinity();
    double time = 0;
    TrianglesAt triangles;
};

/// Lengths in environment units.
struct SweepRequest {
    SweepGoal goal = SweepGoal::kCertify;
    double margin = 0;
    double poseError = 0;
    double leastInterval = 0;
    double from = 0, until = 1;
    bool isContactAtEnd = false;  ///< the pose at `until` is known to be in contact
    double contactTime = 0;       ///< kForward
    double cap = 0;               ///< kLeastDistance: larger distances less the margin do not matter
    PairAtTime known{};           ///< kLeastDistance: a pair with less than the cap
    ClearanceResolution resolution{};
    const std::function<bool()>* isStopped = nullptr;
    std::size_t mostEntries = 0;

    /// Allowance below the cap, environment units. A motion whose least clearance equals the cap could be certified
    /// to the cap only in least intervals, so once a pair comes this near to the cap, cap - nearCap() is certified
    /// instead.
    double nearCap() const { return resolution.of(cap) / 16; }
};

struct SweepAnswer {
    bool isContact = false;
    bool isUndecided = false;  ///< somewhere, before what is certified going forward ends
    bool isStopped = false;
    double certifiedUntil = 0;  ///< kForward
    double contactTime = 0;     ///< if isContact
    bool isPair = false;        ///< the contact is that of a pair, not a forbidden pose or one known before
    TrianglesAt contact;
    double lower = 0;      ///< kLeastDistance: of the distance less the margin
    PairAtTime nearest{};  ///< kLeastDistance: the closest pair found below the cap
};

/// Most entries on a sweep's stack; with more the sweep ends as undecided. A depth-first sweep of a tree of usual
/// depth keeps about a thousand.
constexpr std::size_t kMostSweepEntries = 1 << 16;

SweepAnswer sweepTrees(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion,
                       const SweepRequest& request, Workspace::State& state);

}  // namespace clearway
