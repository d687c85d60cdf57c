#include "bench/clearway_series.h"

#include <memory>
#include <utility>

#include "clearway/batch.h"
#include "clearway/query.h"
#include "clearway/targets.h"
#include "core/number.h"

namespace clearway::testing {
namespace {

constexpr double kWithin[] = {1e-3, 1e-2};  // shares of the part's size
constexpr const char* kDistance = "distance";
constexpr const char* kShuffled = "distance, shuffled";
constexpr const char* kCollides = "collides";

std::string withinName(double share) {
    return "within " + shortNumber(100 * share) + " %";
}

Answer answerOf(const DistanceResult& result) {
    return {result.distance, result.lower, result.upper, result.counters};
}

/// Makes a series of clearway; `ask` gets the workspace, which belongs to the series.
template <typename Ask>
Series ours(const std::string& asked, const std::string& engine, const std::string& target, Ask ask) {
    const auto workspace = std::make_shared<Workspace>();
    Series series;
    series.asked = asked;
    series.engine = engine;
    series.isClearway = true;
    series.ask = [workspace, ask](const Pose& pose) { return ask(pose, *workspace); };
    series.beforePass = [workspace, target] {
        useTarget(target);
        workspace->forgetWarmStart();
    };
    if (engine == "clearway, cold") series.beforeQuery = [workspace] { workspace->forgetWarmStart(); };
    return series;
}

Series distanceSeries(const std::string& asked, const std::string& engine, const TreePair& trees,
                      const std::string& target = "best") {
    return ours(asked, engine, target, [trees](const Pose& pose, Workspace& workspace) {
        return answerOf(distance(trees.part, trees.environment, pose, {}, workspace));
    });
}

Series collidesSeries(const TreePair& trees) {
    Series series = ours(kCollides, "clearway", "best", [trees](const Pose& pose, Workspace& workspace) {
        const bool touching = collides(trees.part, trees.environment, pose, workspace);
        return Answer{touching ? 1.0 : 0.0, 0, 0, workspace.counters()};
    });
    series.question = Question::kCollides;
    return series;
}

Series withinSeries(const TreePair& trees, const std::string& asked, double d) {
    Series series = ours(asked, "clearway", "best", [trees, d](const Pose& pose, Workspace& workspace) {
        const bool near = isWithin(trees.part, trees.environment, pose, d, workspace);
        return Answer{near ? 1.0 : 0.0, 0, 0, workspace.counters()};
    });
    series.question = Question::kIsWithin;
    series.within = d;
    return series;
}

Series batchOf(Series series) {
    series.engine = "clearway, all cores";
    series.ask = nullptr;
    series.beforePass = [] { useTarget("best"); };
    return series;
}

Series distanceBatchSeries(const TreePair& trees) {
    Series series = batchOf(distanceSeries(kDistance, "", trees));
    series.askAll = [trees](const std::vector<Pose>& poses) {
        std::vector<Answer> answers;
        for (const DistanceResult& result : distanceBatch(trees.part, trees.environment, poses)) {
            answers.push_back(answerOf(result));
        }
        return answers;
    };
    return series;
}

Series withinBatchSeries(const TreePair& trees, const std::string& asked, double d) {
    Series series = batchOf(withinSeries(trees, asked, d));
    series.askAll = [trees, d](const std::vector<Pose>& poses) {
        std::vector<Answer> answers;
        for (const std::uint8_t near : isWithinBatch(trees.part, trees.environment, poses, d)) {
            answers.push_back({near != 0 ? 1.0 : 0.0, 0, 0, {}});
        }
        return answers;
    };
    return series;
}

/// Makes a peer's series for the question. `ask` is empty if the peer has no such query.
Series theirs(const Peer& peer, const std::string& asked, std::function<Answer(const Pose&)> ask) {
    Series series;
    series.asked = asked;
    series.engine = peer.name;
    series.ask = std::move(ask);
    series.beforePass = peer.forgetWarmStart;
    return series;
}

void addOfPeer(std::vector<Series>& all, const Peer& peer, double partSize) {
    if (peer.distance) {
        all.push_back(theirs(peer, kDistance, peer.distance));
        if (peer.forgetWarmStart) {
            Series cold = all.back();
            cold.engine += ", cold";
            cold.beforeQuery = peer.forgetWarmStart;
            all.push_back(cold);
        }
        all.push_back(theirs(peer, kShuffled, peer.distance));
    }
    if (peer.collides) {
        all.push_back(theirs(peer, kCollides, peer.collides));
        all.back().question = Question::kCollides;
    }
    for (const double share : kWithin) {
        if (!peer.isWithin) continue;
        const double d = share * partSize;
        all.push_back(theirs(peer, withinName(share),
                             [ask = peer.isWithin, d](const Pose& pose) { return ask(pose, d); }));
        all.back().question = Question::kIsWithin;
        all.back().within = d;
    }
}

void addOurs(std::vector<Series>& all, const TreePair& trees, double partSize, const SeriesOptions& options) {
    all.push_back(distanceSeries(kDistance, "clearway", trees));
    all.push_back(distanceSeries(kDistance, "clearway, cold", trees));
    for (const std::string& target : options.targets) {
        all.push_back(distanceSeries(kDistance, "clearway, " + target, trees, target));
    }
    all.push_back(distanceSeries(kShuffled, "clearway", trees));
    all.push_back(collidesSeries(trees));
    for (const double share : kWithin) {
        all.push_back(withinSeries(trees, withinName(share), share * partSize));
        all.push_back(withinBatchSeries(trees, withinName(share), share * partSize));
    }
    all.push_back(distanceBatchSeries(trees));
}

bool areCompared(const Series& a, const Series& b) {
    if (!a.isClearway) return false;
    if (b.isClearway)
        return a.askAll && a.asked == b.asked && b.engine == "clearway";  // a batch beside one thread
    if (a.question == Question::kIsWithin && b.asked == kDistance) return b.engine == "FCL RSS" && !a.askAll;
    return a.asked == b.asked && !a.askAll;
}

}  // namespace

TreePair buildTrees(const BenchTask& task, const BuildOptions& options) {
    return {Model::build(task.part, options), Model::build(task.environment, options)};
}

std::vector<Series> allSeries(const BenchTask& task, const TreePair& trees, const std::vector<Peer>& peers,
                              const SeriesOptions& options) {
    std::vector<Series> all;
    addOurs(all, trees, task.partSize(), options);
    for (const Peer& peer : peers) addOfPeer(all, peer, task.partSize());
    const std::size_t count = task.poses.size();
    for (Series& series : all) {
        series.order = series.asked == kShuffled ? shuffledOrder(count, options.seed) : inOrder(count);
    }
    return all;
}

std::vector<Series> seriesOfTrees(const BenchTask& task, const TreePair& trees, const std::string& engine) {
    const double share = kWithin[1];
    std::vector<Series> all = {distanceSeries(kDistance, engine, trees), collidesSeries(trees),
                               withinSeries(trees, withinName(share), share * task.partSize())};
    for (Series& series : all) {
        series.engine = engine;
        series.order = inOrder(task.poses.size());
    }
    return all;
}

std::vector<Series> distanceSeries(const BenchTask& task, const TreePair& trees,
                                   const std::vector<Peer>& peers) {
    std::vector<Series> all = {distanceSeries(kDistance, "clearway", trees)};
    for (const Peer& peer : peers) all.push_back(theirs(peer, kDistance, peer.distance));
    for (Series& series : all) series.order = inOrder(task.poses.size());
    return all;
}

std::vector<Comparison> comparisons(const std::vector<Series>& all) {
    std::vector<Comparison> found;
    for (const Series& a : all) {
        for (const Series& b : all) {
            if (areCompared(a, b)) found.push_back({&a, &b});
        }
    }
    return found;
}

}  // namespace clearway::testing
