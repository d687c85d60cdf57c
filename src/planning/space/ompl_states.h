// OMPL's state spaces for a part, and its states to and from those of path files.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include <utility>

#include "clearway/problem.h"
#include "clearway/scene_clearance.h"

namespace clearway::planning {

/// The space that a constructor's other arguments are made from. Throws ArgumentError when si is
/// null.
const ompl::base::StateSpace& spaceOf(const ompl::base::SpaceInformationPtr& si);

/// Whether a space is OMPL's SE(3), and not one derived from it that may interpolate in its own way.
bool isOmplSe3(const ompl::base::StateSpace& space);

/// Throws ArgumentError when a space is neither SE(3) nor SE(2).
Space kindOf(const ompl::base::StateSpace& space);

/// SE(3) or SE(2) with the position within the bounds. turnWeight: the length, in environment units, that one
/// unit of OMPL's rotation distance counts as (half the angle in SE(3), the angle in SE(2), in radians).
ompl::base::StateSpacePtr makeSpace(Space kind, const Box& bounds, double turnWeight);

/// Returns the bounds of positions in a space of the kinds that makeSpace makes.
const ompl::base::RealVectorBounds& positionBounds(Space kind, const ompl::base::StateSpace& space);

/// Why a state is outside of its space's bounds. Its position is looked at in SE(3) and SE(2).
WhyInvalid whyOutOfBounds(const ompl::base::StateSpace& space, const ompl::base::State* state);

/// Create and set up a SpaceInformation on a shared space, under a global lock: OMPL reads the space's parameters
/// when it creates one, and writes them when it sets one up, without a lock of its own.
ompl::base::SpaceInformationPtr makeOnSharedSpace(const ompl::base::StateSpacePtr& space);
void setUpOnSharedSpace(ompl::base::SpaceInformation& si);

ompl::base::ScopedState<> toOmpl(const ompl::base::StateSpacePtr& space, Space kind, const PartState& state);
PartState fromOmpl(Space kind, const ompl::base::State* state);
PartState partStateOfSe3(const ompl::base::State* state);
PartState partStateOfSe2(const ompl::base::State* state);

/// (x, y, yaw) of a state of SE(2).
Vector3 planarNumbersOf(const ompl::base::State* state);

/// A state that is freed when it goes out of scope. si must outlive it.
class ScratchState {
  public:
    explicit ScratchState(const ompl::base::SpaceInformation& si) : si_(si), state_(si.allocState()) {}
    ~ScratchState() { si_.freeState(state_); }
    ScratchState(const ScratchState&) = delete;
    ScratchState& operator=(const ScratchState&) = delete;
    ompl::base::State* get() const { return state_; }

  private:
    const ompl::base::SpaceInformation& si_;
    ompl::base::State* state_;
};

/// Fills in checkMotion's lastValid, through a scratch state because lastValid.first may be s1 or s2. It may
/// also be null.
void setLastValid(const ompl::base::SpaceInformation& si, const ompl::base::State* s1,
                  const ompl::base::State* s2, double time, std::pair<ompl::base::State*, double>& lastValid);

/// Adds 1 to a counter of ompl::base::MotionValidator. These are plain integers behind getters that cannot be
/// overridden, and several threads count at once.
inline void countAtomically(unsigned int& counter) {
    __atomic_fetch_add(&counter, 1u, __ATOMIC_RELAXED);
}

}  // namespace clearway::planning
