// What a planner calls: states and motions it asks about, in the order in which it does, and the work of
// their queries.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/query.h"

namespace clearway::planning {

enum class CallKind {
    kState,          ///< ValidityChecker::isValid
    kClearance,      ///< the same with the clearance
    kMotion,         ///< MotionValidator::checkMotion
    kForwardMotion,  ///< the same with the last valid state
    kMotionCost,     ///< a clearance objective's motionCost
};

/// States as the reals of OMPL's space, which hold all of them.
struct Call {
    CallKind kind = CallKind::kState;
    std::vector<double> from;
    std::vector<double> to;  ///< empty for one state
};

/// Calls that followed one another.
using CallBlock = std::vector<Call>;

/// Blocks drawn evenly from all that a run calls, in its order: so that a replay begins each query of a block
/// as warm as the planner did, but for the first.
struct CallSampling {
    std::size_t blocks = 32;
    std::size_t callsPerBlock = 32;
    std::uint64_t seed = 1;
};

/// Of the queries of a run.
struct QueryTally {
    std::uint64_t distances = 0;
    std::uint64_t withins = 0;  ///< whether in contact, or within a margin
    double seconds = 0;
    QueryCounters work;
};

}  // namespace clearway::planning
