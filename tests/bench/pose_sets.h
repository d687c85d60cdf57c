// Poses to measure queries at, in the order of a path: each is near the one before, as the steps of a planner
// or of a replayed path are. Deterministic for a seed, on a machine's libm.
#pragma once

#include <cstdint>
#include <vector>

#include "program/scenes/replay.h"

namespace clearway::testing {

/// A random walk beside the path: each step goes on along the path and changes the deviation by about 0.4 %
/// of the part's size (the diagonal of its box), half of it by turning. A step is possible only where the
/// distance is from * size to to
/// * size. So that clearances spread over that range as far as the scene allows, a clearance to aim at is
/// drawn anew every eight steps, evenly in its logarithm, and of four possible steps the one nearest to it is
/// taken. Where no step is possible the walk turns round. None collides. Throws std::runtime_error when the
/// walk is stuck.
std::vector<Pose> posesFree(const scenes::PoseTask& task, double from, double to, int count,
                            std::uint64_t seed);

/// How far consecutive poses are apart: the largest way a corner of the part's box moves, over the box's
/// diagonal; one value a step.
std::vector<double> stepsBetween(const std::vector<Pose>& poses, const Box& partBox);

/// 0 to count - 1 in a random order.
std::vector<std::size_t> shuffledOrder(std::size_t count, std::uint64_t seed);

}  // namespace clearway::testing
