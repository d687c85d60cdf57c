// Answers lists of poses block by block, each block on one thread.
#include <algorithm>

#include "clearway/batch.h"
#include "clearway/scene_clearance.h"
#include "core/parallel.h"

namespace clearway {
namespace {

/// Calls answer(i) for every i below count, in parallel blocks. Each block starts without a warm start.
template <class Answer>
void forEachPoseInBlocks(const SceneClearance& scene, std::size_t count, const Answer& answer) {
    forEachRun(count, kBatchBlock, [&](std::size_t first, std::size_t last) {
        const SceneClearance::ColdStart cold(scene);
        for (std::size_t i = first; i < last; ++i) answer(i);
    });
}

/// Lets the first pose that is refused throw before any thread starts.
void requirePosesFor(const SceneClearance& scene, const std::vector<Pose>& poses) {
    for (const Pose& X_environmentPart : poses) {
        requirePose(X_environmentPart);
        if (scene.isOutOfRange(X_environmentPart)) scene.isFree(X_environmentPart);
    }
}

}  // namespace

std::vector<std::uint8_t> SceneClearance::isFreeBatch(const std::vector<Pose>& X_environmentPart) const {
    requirePosesFor(*this, X_environmentPart);
    std::vector<std::uint8_t> results(X_environmentPart.size());
    forEachPoseInBlocks(*this, results.size(),
                        [&](std::size_t i) { results[i] = isFree(X_environmentPart[i]) ? 1 : 0; });
    return results;
}

std::vector<double> SceneClearance::clearanceBatch(const std::vector<Pose>& X_environmentPart) const {
    requirePosesFor(*this, X_environmentPart);
    std::vector<double> results(X_environmentPart.size());
    forEachPoseInBlocks(*this, results.size(),
                        [&](std::size_t i) { results[i] = at(X_environmentPart[i]).lower; });
    return results;
}

}  // namespace clearway
