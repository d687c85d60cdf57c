// The questions to clearway and to its peers, and the pairs of series to compare.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/series.h"
#include "clearway/model.h"

namespace clearway::testing {

/// The two trees of one build.
struct TreePair {
    Model part;
    Model environment;
};

TreePair buildTrees(const BenchTask& task, const BuildOptions& options);

struct SeriesOptions {
    std::vector<std::string> targets;  ///< further instruction sets to time, besides the best one
    std::uint64_t seed = 1;            ///< seed of the shuffled order
};

/// Distances in path order (warm, cold, per instruction set), shuffled and in batches;
/// collisions; isWithin at 0.1 % and 1 % of the part's size. Each question also goes to the peers that have
/// such a query.
std::vector<Series> allSeries(const BenchTask& task, const TreePair& trees, const std::vector<Peer>& peers,
                              const SeriesOptions& options);

/// Distance, collides and isWithin at 1 % of the part's size, warm and in path order, as `engine`.
std::vector<Series> seriesOfTrees(const BenchTask& task, const TreePair& trees, const std::string& engine);

/// Distances, warm and in path order, of clearway and of each peer.
std::vector<Series> distanceSeries(const BenchTask& task, const TreePair& trees,
                                   const std::vector<Peer>& peers);

/// A row of the figures: how many times faster `ours` is.
struct Comparison {
    const Series* ours;
    const Series* theirs;
};

/// Pairs each series of clearway with each peer's series for the same question. Also pairs isWithin with
/// FCL's distance, and within clearway batches with plain queries.
std::vector<Comparison> comparisons(const std::vector<Series>& all);

}  // namespace clearway::testing
