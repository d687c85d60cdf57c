// Poses for benchmarks of queries, in the order of a path that solves a scene: close together like the steps
// of a planner, a given share of them in collision.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/types.h"

namespace clearway::scenes {

/// Three translations in part sizes (diagonals of the part's box), then a rotation vector in radians.
using Deviation = Eigen::Matrix<double, 6, 1>;

/// A rotation by this angle (radians) moves the ends of a part about as far as a translation by one part
/// size.
constexpr double kTurnOfASize = 2;

class PathCurve {
  public:
    /// Throws std::invalid_argument when the path does not move.
    PathCurve(const std::vector<PartState>& path, const Box& partBox);

    double size() const { return size_; }

    /// The pose at a share (0 to 1) of the path's length, in which turning counts by how far it moves the
    /// part's ends. The deviation turns the part about the middle of its box.
    Pose at(double share, const Deviation& deviation) const;

  private:
    Vector3 placeOf(const PartState& state) const { return state.rotation * centre_ + state.position; }

    std::vector<PartState> path_;
    Vector3 centre_;
    double size_;
    std::vector<double> reached_{0};
};

/// The models and the path that poses are made for. Below, `size` is the diagonal of the part's box.
struct PoseTask {
    Model part;
    Model environment;
    std::vector<PartState> path;  ///< collides nowhere; at least two different states
};

/// How the poses of a scene's replay are made.
struct Replay {
    double collidingShare = 0.1;
    double pathEnd = 1;  ///< the poses follow this first share of the path's states
    bool turns = true;   ///< the deviation also turns the part
};

/// Walks along the path once in even steps and adds a smooth deviation: each of the three translations and
/// three rotations (about the centre of the part's box) is a sum of four sines with up to six periods along
/// the path. A bisection finds the amplitude at which the share of colliding poses is `share` within 0.02. If
/// one deviation has no such amplitude, another is drawn. `turns` = false leaves the rotations out, so that
/// parallel faces stay parallel. Throws std::runtime_error when 50 deviations fail. The seed and the
/// machine's libm determine the poses.
std::vector<Pose> posesColliding(const PoseTask& task, double share, int count, std::uint64_t seed,
                                 bool turns = true);

/// The first share of a path's states; their number is rounded up.
std::vector<PartState> beginningOf(const std::vector<PartState>& path, double share);

}  // namespace clearway::scenes
