// The shortest twist that satisfies linear inequalities.
#pragma once

#include <optional>
#include <vector>

#include "planning/improve/part_moves.h"

namespace clearway::planning {

/// row . twist >= least.
struct TwistBound {
    Twist row;
    double least;
};

/// Returns the twist of least norm that keeps all bounds; none when no twist does. Solved as a problem of non-negative least squares
/// (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23), exactly but for rounding.
std::optional<Twist> leastTwist(const std::vector<TwistBound>& bounds);

}  // namespace clearway::planning
