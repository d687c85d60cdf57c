// A path as a curve to go along evenly, with deviations from it.
#pragma once

#include <vector>

#include "clearway/problem.h"
#include "clearway/types.h"

namespace clearway::scenes {

/// Three translations in part sizes (diagonals of the part's box), then a rotation vector in radians.
using Deviation = Eigen::Matrix<double, 6, 1>;

/// Radians that move the ends of a part as far as one part size of translation.
constexpr double kTurnOfASize = 2;

class PathCurve {
  public:
    /// Throws std::invalid_argument when the path does not move.
    PathCurve(const std::vector<PartState>& path, const Box& partBox);

    double size() const { return size_; }

    /// share: 0 to 1 of the path's length, which counts turning by what it moves the part's ends. The
    /// deviation turns the part about the middle of its box.
    Pose at(double share, const Deviation& deviation) const;

  private:
    Vector3 placeOf(const PartState& state) const { return state.rotation * centre_ + state.position; }

    std::vector<PartState> path_;
    Vector3 centre_;
    double size_;
    std::vector<double> reached_{0};
};

}  // namespace clearway::scenes
