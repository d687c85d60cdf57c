// A path as a line that is followed at an even pace, with interpolation between its states.
#pragma once

#include <vector>

#include "clearway/problem.h"

namespace clearway {

/// Between two states the part moves as in OMPL: along a straight line, turning evenly the shorter way.
class PathLine {
  public:
    /// turnRadius: the length that a turn by one radian counts as, in environment units; the part's radius
    /// gives a visually even pace. Throws ArgumentError when there is no state.
    PathLine(std::vector<PartState> states, double turnRadius);

    /// The state at a share of the way from the first state (0) to the last (1); the share is clamped.
    PartState at(double share) const;

    const std::vector<PartState>& states() const { return states_; }
    /// The share of the way at each state, rising from 0 to 1.
    const std::vector<double>& shares() const { return shares_; }

  private:
    std::vector<PartState> states_;
    std::vector<double> shares_;
};

/// `count` evenly spaced shares from 0 to 1; for a count of 1 only 0.
std::vector<double> evenShares(std::size_t count);

}  // namespace clearway
