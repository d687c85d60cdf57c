// Poses to measure queries at, in the order of a path: each is near the previous one, as in the steps of a
// planner or of a replayed path. A seed and the machine's libm determine them.
#pragma once

#include <cstdint>
#include <vector>

#include "demos/scenes/replay.h"

namespace clearway::testing {

/// A random walk beside the path, without collisions. Each step goes on along the path and changes the
/// deviation by about 0.4 % of the part's size (the diagonal of its box), half of it by turning. A step is
/// possible only where the distance is between from * size and to * size. The walk spreads the clearances
/// over that range as far as the scene allows: every eight steps it draws a wanted clearance, evenly in its
/// logarithm, and takes the one of four possible steps that comes nearest to it. Where no step is possible
/// the walk turns round. Throws std::runtime_error when the walk is stuck.
std::vector<Pose> posesFree(const scenes::PoseTask& task, double from, double to, int count,
                            std::uint64_t seed);

/// The size of each step: the largest way that a corner of the part's box moves, divided by the box's
/// diagonal.
std::vector<double> stepsBetween(const std::vector<Pose>& poses, const Box& partBox);

/// The numbers 0 to count - 1 in a random order.
std::vector<std::size_t> shuffledOrder(std::size_t count, std::uint64_t seed);

}  // namespace clearway::testing
