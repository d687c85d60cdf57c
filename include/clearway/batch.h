// Queries for many poses at once, on all cores.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/query.h"

#pragma GCC visibility push(default)

namespace clearway {

/// Number of poses that one thread answers one after the other. Each block begins without a warm start, so
/// that an answer depends only on the poses before it in its block, not on the number of threads. Order poses
/// as along a path.
constexpr std::size_t kBatchBlock = 64;

/// distance() for every pose, in the given order. Uses as many threads as oneTBB gives the caller (limited by
/// tbb::task_arena and tbb::global_control). In a process forked after clearway used oneTBB it runs on the calling
/// thread, because oneTBB's locks do not survive a fork. Throws what distance() throws for the first pose of the
/// list that it refuses.
std::vector<DistanceResult> distanceBatch(const Model& part, const Model& environment,
                                          const std::vector<Pose>& X_environmentPart,
                                          const DistanceOptions& options = {});

/// isWithin() for every pose, 1 for true, with threads and errors as in distanceBatch. d = 0 asks for
/// contact.
std::vector<std::uint8_t> isWithinBatch(const Model& part, const Model& environment,
                                        const std::vector<Pose>& X_environmentPart, double d);

}  // namespace clearway

#pragma GCC visibility pop
