// Poses to measure queries at, in the order of a path: each is near the one before, as the steps of a planner
// or of a replayed path are. Deterministic for a seed, on a machine's libm.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/model.h"
#include "clearway/problem.h"

namespace clearway::testing {

/// What poses are made for. `size` below is the diagonal of the part's box.
struct PoseTask {
    Model part;
    Model environment;
    std::vector<PartState> path;  ///< collides nowhere; at least two different states
};

/// The path, walked through once in even steps, plus a smooth deviation: for each of the three translations
/// and the three rotations (about the centre of the part's box) a sum of four sines that go to and fro up to
/// six times along the path. Its amplitude is found by bisection so that the share of colliding poses is
/// `share` within 0.02; when one deviation cannot, another is drawn. `turns` = false leaves the rotations
/// out, so that parallel faces stay parallel. Throws std::runtime_error when 50 deviations fail.
std::vector<Pose> posesColliding(const PoseTask& task, double share, int count, std::uint64_t seed,
                                 bool turns = true);

/// A random walk beside the path: each step goes on along the path and changes the deviation by about 0.4 %
/// of the part's size, half of it by turning. A step is possible only where the distance is from * size to to
/// * size. So that clearances spread over that range as far as the scene allows, a clearance to aim at is
/// drawn anew every eight steps, evenly in its logarithm, and of four possible steps the one nearest to it is
/// taken. Where no step is possible the walk turns round. None collides. Throws std::runtime_error when the
/// walk is stuck.
std::vector<Pose> posesFree(const PoseTask& task, double from, double to, int count, std::uint64_t seed);

/// How far consecutive poses are apart: the largest way a corner of the part's box moves, over the box's
/// diagonal; one value a step.
std::vector<double> stepsBetween(const std::vector<Pose>& poses, const Box& partBox);

/// 0 to count - 1 in a random order.
std::vector<std::size_t> shuffledOrder(std::size_t count, std::uint64_t seed);

}  // namespace clearway::testing
