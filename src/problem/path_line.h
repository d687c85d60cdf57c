// A path as a line to go along at an even pace, the states between those of its file included.
#pragma once

#include <vector>

#include "clearway/problem.h"

namespace clearway {

/// Between two states the part moves as OMPL moves it: straight, turning evenly the shorter way.
class PathLine {
  public:
    /// turnRadius: what turning by a radian counts as, in environment units; the part's radius for an even
    /// pace of what is seen. Throws std::invalid_argument when there is no state.
    PathLine(std::vector<PartState> states, double turnRadius);

    /// share: of the way from the first state (0) to the last (1); clamped to these.
    PartState at(double share) const;

    const std::vector<PartState>& states() const { return states_; }
    const std::vector<double>& shares() const {
        return shares_;
    }  ///< where the states are, rising from 0 to 1

  private:
    std::vector<PartState> states_;
    std::vector<double> shares_;
};

/// count shares from 0 to 1, evenly spaced; 0 alone for a count of 1.
std::vector<double> evenShares(std::size_t count);

}  // namespace clearway
