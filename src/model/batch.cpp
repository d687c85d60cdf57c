// Answers lists of poses block by block, each block on one thread.
#include "clearway/batch.h"

#include <algorithm>

#include "clearway/model.h"
#include "core/parallel.h"
#include "model/query_range.h"

namespace clearway {
namespace {

/// Checks all poses before any thread starts, so that the error is about the first bad pose of the list.
void requirePoses(const Model& part, const Model& environment, const std::vector<Pose>& poses) {
    for (const Pose& X_environmentPart : poses) {
        requirePose(X_environmentPart);
        requireWithinRange(part, environment, X_environmentPart);
    }
}

/// Calls answer(i, workspace) for every i below count. The blocks run in parallel; each starts without a warm
/// start.
template <class Answer>
void forEachInBlocks(std::size_t count, const Answer& answer) {
    forEachRun(count, kBatchBlock, [&](std::size_t first, std::size_t last) {
        Workspace workspace;
        for (std::size_t i = first; i < last; ++i) answer(i, workspace);
    });
}

}  // namespace

std::vector<DistanceResult> distanceBatch(const Model& part, const Model& environment,
                                          const std::vector<Pose>& X_environmentPart,
                                          const DistanceOptions& options) {
    requirePoses(part, environment, X_environmentPart);
    std::vector<DistanceResult> results(X_environmentPart.size());
    forEachInBlocks(results.size(), [&](std::size_t i, Workspace& workspace) {
        results[i] = distance(part, environment, X_environmentPart[i], options, workspace);
    });
    return results;
}

std::vector<std::uint8_t> isWithinBatch(const Model& part, const Model& environment,
                                        const std::vector<Pose>& X_environmentPart, double d) {
    requirePoses(part, environment, X_environmentPart);
    std::vector<std::uint8_t> results(X_environmentPart.size());
    forEachInBlocks(results.size(), [&](std::size_t i, Workspace& workspace) {
        results[i] = isWithin(part, environment, X_environmentPart[i], d, workspace) ? 1 : 0;
    });
    return results;
}

}  // namespace clearway
