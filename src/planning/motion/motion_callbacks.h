// What every motion validator owes OMPL beside its verdict.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <utility>

#include "planning/validity/scratch_state.h"

namespace clearway::planning {

/// Adds to one of ompl::base::MotionValidator's counters, which are plain integers behind getters that cannot
/// be overridden. Called from several threads at once.
inline void countAtomically(unsigned int& counter) {
    __atomic_fetch_add(&counter, 1u, __ATOMIC_RELAXED);
}

/// Answers checkMotion's lastValid, by way of a scratch state: lastValid.first may be s1 or s2, or null.
inline void setLastValid(const ompl::base::SpaceInformation& si, const ompl::base::State* s1,
                         const ompl::base::State* s2, double time,
                         std::pair<ompl::base::State*, double>& lastValid) {
    lastValid.second = time;
    if (lastValid.first == nullptr) return;
    const ScratchState scratch(si);
    si.copyState(scratch.get(), s1);
    if (time > 0) si.getStateSpace()->interpolate(s1, s2, time, scratch.get());
    si.copyState(lastValid.first, scratch.get());
}

}  // namespace clearway::planning
