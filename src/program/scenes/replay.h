// Poses to ask queries at, in the order of a path that solves a scene: near each other as the steps of a
// planner are, and so many of them in collision.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/model.h"
#include "clearway/problem.h"

namespace clearway::scenes {

/// What poses are made for. `size` below is the diagonal of the part's box.
struct PoseTask {
    Model part;
    Model environment;
    std::vector<PartState> path;  ///< collides nowhere; at least two different states
};

/// What a scene's replay is like.
struct Replay {
    double collidingShare = 0.1;
    double pathEnd = 1;  ///< the poses keep to this first share of the path's states
    bool turns = true;   ///< they deviate from the path by turning too
};

/// The path, walked through once in even steps, plus a smooth deviation: for each of the three translations
/// and the three rotations (about the centre of the part's box) a sum of four sines that go to and fro up to
/// six times along the path. Its amplitude is found by bisection so that the share of colliding poses is
/// `share` within 0.02; when one deviation cannot, another is drawn. `turns` = false leaves the rotations
/// out, so that parallel faces stay parallel. Throws std::runtime_error when 50 deviations fail.
/// Deterministic for a seed, on a machine's libm.
std::vector<Pose> posesColliding(const PoseTask& task, double share, int count, std::uint64_t seed,
                                 bool turns = true);

/// The first share of a path's states, rounded up.
std::vector<PartState> beginningOf(const std::vector<PartState>& path, double share);

}  // namespace clearway::scenes
