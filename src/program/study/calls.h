// The calls of a planner: the states and motions it asks about, in its order.
#pragma once

#include <cstdint>
#include <vector>

namespace clearway::study {

enum class CallKind {
    kState,          ///< ValidityChecker::isValid
    kClearance,      ///< ValidityChecker::isValid that also returns the clearance
    kMotion,         ///< MotionValidator::checkMotion
    kForwardMotion,  ///< MotionValidator::checkMotion that also returns the last valid state
    kMotionCost,     ///< a clearance objective's motionCost
};

/// States as the reals of OMPL's space, which hold all of them.
struct Call {
    CallKind kind = CallKind::kState;
    std::vector<double> from;
    std::vector<double> to;  ///< empty for one state
};

/// Consecutive calls.
using CallBlock = std::vector<Call>;

/// Blocks drawn evenly from all calls of a run, in the run's order. Within a block, a replay begins each query
/// but the first as warm as the planner did.
struct CallSampling {
    std::size_t blocks = 32;
    std::size_t callsPerBlock = 32;
    std::uint64_t seed = 1;
};

}  // namespace clearway::study
