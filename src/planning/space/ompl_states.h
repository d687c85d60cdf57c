// OMPL's state spaces for a part, and its states to and from those of path files.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include <utility>

#include "clearway/problem.h"
#include "clearway/scene_clearance.h"

namespace ompl::geometric {}

namespace clearway {
namespace ob = ompl::base;  // the short names that OMPL's own demos use
namespace og = ompl::geometric;
}  // namespace clearway

namespace clearway::planning {

/// The space that a constructor's other arguments are made from. Throws ArgumentError when si is
/// null.
const ob::StateSpace& spaceOf(const ob::SpaceInformationPtr& si);

/// Whether a space is OMPL's SE(3), and not one derived from it that may interpolate in its own way.
bool isOmplSe3(const ob::StateSpace& space);

/// Throws ArgumentError when a space is neither SE(3) nor SE(2).
Space kindOf(const ob::StateSpace& space);

/// SE(3) or SE(2) with the position within the bounds. turnWeight: the length, in environment units, that one
/// unit of OMPL's rotation distance counts as (half the angle in SE(3), the angle in SE(2), in radians).
ob::StateSpacePtr makeSpace(Space kind, const Box& bounds, double turnWeight);

/// Returns the bounds of positions in a space of the kinds that makeSpace makes.
const ob::RealVectorBounds& positionBounds(Space kind, const ob::StateSpace& space);

/// Why a state is outside of its space's bounds. Its position is looked at in SE(3) and SE(2).
WhyInvalid whyOutOfBounds(const ob::StateSpace& space, const ob::State* state);

/// Create and set up a SpaceInformation on a shared space, under a global lock: OMPL reads the space's parameters
/// when it creates one, and writes them when it sets one up, without a lock of its own.
ob::SpaceInformationPtr makeOnSharedSpace(const ob::StateSpacePtr& space);
void setUpOnSharedSpace(ob::SpaceInformation& si);

ob::ScopedState<> toOmpl(const ob::StateSpacePtr& space, Space kind, const PartState& state);
PartState fromOmpl(Space kind, const ob::State* state);
PartState partStateOfSe3(const ob::State* state);
PartState partStateOfSe2(const ob::State* state);

/// (x, y, yaw) of a state of SE(2).
Vector3 planarNumbersOf(const ob::State* state);

/// A state that is freed when it goes out of scope. si must outlive it.
class ScratchState {
  public:
    explicit ScratchState(const ob::SpaceInformation& si) : si_(si), state_(si.allocState()) {}
    ~ScratchState() { si_.freeState(state_); }
    ScratchState(const ScratchState&) = delete;
    ScratchState& operator=(const ScratchState&) = delete;
    ob::State* get() const { return state_; }

  private:
    const ob::SpaceInformation& si_;
    ob::State* state_;
};

/// Fills in checkMotion's lastValid, through a scratch state because lastValid.first may be s1 or s2. It may
/// also be null.
void setLastValid(const ob::SpaceInformation& si, const ob::State* s1, const ob::State* s2, double time,
                  std::pair<ob::State*, double>& lastValid);

/// Adds 1 to a counter of ob::MotionValidator. These are plain integers behind getters that cannot be
/// overridden, and several threads count at once.
inline void countAtomically(unsigned int& counter) {
    __atomic_fetch_add(&counter, 1u, __ATOMIC_RELAXED);
}

}  // namespace clearway::planning
