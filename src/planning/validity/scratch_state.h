// A state of OMPL's that is freed when it goes out of scope.
#pragma once

#include <ompl/base/SpaceInformation.h>

namespace clearway::planning {

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

}  // namespace clearway::planning
