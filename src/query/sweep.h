// The sweep on trees: pairs of volumes over intervals of time.
#pragma once

#include <functional>

#include "clearway/sweep.h"
#include "query/queries.h"

namespace clearway {

/// The question to a sweep.
enum class SweepGoal {
    kCertify,        ///< whether all times are certified; ends at the first contact
    kForward,        ///< how far they are from the start on
    kLeastDistance,  ///< how near the part comes
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
    double leastUpper = 0;  ///< kLeastDistance: distance less the margin known to be reached, or the cap
    ClearanceResolution resolution{};
    const std::function<bool()>* isStopped = nullptr;
    std::size_t mostEntries = 0;
};

struct SweepAnswer {
    bool isContact = false;
    bool isUndecided = false;  ///< somewhere, before what is certified going forward ends
    bool isStopped = false;
    double certifiedUntil = 0;  ///< kForward
    double contactTime = 0;     ///< if isContact
    bool isPair = false;        ///< the contact is that of a pair, not a forbidden pose or one known before
    TrianglesAt contact{0, 0, kNoFeature};
    double lower = 0, upper = 0;  ///< kLeastDistance: of the distance less the margin; upper <= leastUpper
    double time = 0;              ///< of upper, if it is below leastUpper
    TrianglesAt nearest{0, 0, kNoFeature};  ///< have the distance `upper` plus the margin at that time
};

/// More pairs in wait end a sweep as undecided. Depth first, a sweep of a tree of usual depth keeps about a thousand.
constexpr std::size_t kMostSweepEntries = 1 << 16;

SweepAnswer sweepTrees(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion,
                       const SweepRequest& request, Workspace::State& state);

}  // namespace clearway
