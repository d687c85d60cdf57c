#include "program/study/replayed_blocks.h"

#include <algorithm>

#include "program/study/paired_ratio.h"
#include "program/study/study_rows.h"

namespace clearway::study {
namespace {

constexpr double kMostSeconds = 0.1;
constexpr std::size_t kLeastBlocks = 4;

}  // namespace

double querySecondsPerCall(const std::vector<TableRow>& runs, const std::string& scene,
                           const std::string& planner, int seed) {
    std::vector<double> all;
    for (const TableRow& run : runs) {
        if (run.at("scene") != scene || run.at("planner") != planner ||
            run.at("seed") != std::to_string(seed))
            continue;
        const double calls = callsOf(run);
        if (calls > 0) all.push_back(sumIn(run, {"query_seconds"}) / calls);
    }
    return all.empty() ? 0 : median(std::move(all));
}

std::vector<std::size_t> replayedBlocks(std::size_t blocks, std::size_t callsPerBlock,
                                        double secondsPerCall) {
    const double each = secondsPerCall * static_cast<double>(callsPerBlock);
    std::size_t count = blocks;
    if (each * static_cast<double>(blocks) > kMostSeconds)
        count = std::min(blocks, std::max(kLeastBlocks, static_cast<std::size_t>(kMostSeconds / each)));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(i * blocks / count);
    return places;
}

}  // namespace clearway::study
