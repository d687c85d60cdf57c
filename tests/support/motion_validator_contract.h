// What OMPL asks of every motion validator, as checks that any one can be put through.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <string>

namespace clearway::testing {

/// The validator's si must have a validity checker. start to near is valid, start to far is not, though start
/// and far are, and blocked is an invalid state.
struct ContractMotions {
    ompl::base::ScopedState<> start, near, far, blocked;
};

/// Checks with Boost.Test: verdicts of both forms; lastValid untouched on true; on false a time in [0, 1)
/// with the state there, which is valid, as are those before it; null and aliases; an invalid start; states
/// that are not finite; OMPL's counters, from several threads too. None of the given states changes.
void checkMotionValidatorContract(const ompl::base::SpaceInformation& si,
                                  ompl::base::MotionValidator& validator, const ContractMotions& motions);

}  // namespace clearway::testing
