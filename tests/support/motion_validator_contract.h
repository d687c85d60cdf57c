// Checks of OMPL's contract for motion validators, for any validator.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <string>

namespace clearway::testing {

/// The validator's si must have a validity checker. The motion from start to near is valid. The motion from
/// start to far is not, although both states are. blocked is an invalid state.
struct ContractMotions {
    ompl::base::ScopedState<> start, near, far, blocked;
};

/// Checks with Boost.Test: the verdicts of both forms; that lastValid is untouched on true; on false a time
/// in [0, 1) with its state, which is valid, as are the states before it; null and aliased arguments; an
/// invalid start; states that are not finite; and OMPL's counters, from several threads too. None of the
/// given states may change.
void checkMotionValidatorContract(const ompl::base::SpaceInformation& si,
                                  ompl::base::MotionValidator& validator, const ContractMotions& motions);

}  // namespace clearway::testing
