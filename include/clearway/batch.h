// Many poses at once, on all cores.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/query.h"

namespace clearway {

/// Poses answered one after the other by one thread. Each block begins without a warm start, so that an
/// answer does not depend on the number of threads, only on the poses before it in its block: keep poses in
/// the order of a path.
constexpr std::size_t kBatchBlock = 64;

/// distance() for every pose, in the order given, by as many threads as oneTBB gives the caller
/// (tbb::task_arena and tbb::global_control narrow it). Throws what distance() throws for the first pose in
/// the list that it refuses.
std::vector<DistanceResult> distanceBatch(const Model& part, const Model& environment,
                                          const std::vector<Pose>& X_environmentPart,
                                          const DistanceOptions& options = {});

/// isWithin() likewise: 1 for true. d = 0 asks for contact.
std::vector<std::uint8_t> isWithinBatch(const Model& part, const Model& environment,
                                        const std::vector<Pose>& X_environmentPart, double d);

}  // namespace clearway
