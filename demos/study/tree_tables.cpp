#include "demos/study/tree_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "demos/study/statistics.h"
#include "program/bench/planner_run.h"

namespace clearway::study {
namespace {

constexpr std::size_t kBlocks = 20;

std::vector<BuildOptions> measuredTrees() {
    std::vector<BuildOptions> all;
    const auto add = [&](int width, const char* fit, const char* general, const char* leaf) {
        BuildOptions build;
        build.nodeWidth = width;
        build.fit = fit;
        build.generalSplit = general;
        build.leafSplit = leaf;
        build.threads = 1;
        all.push_back(build);
    };
    for (const bool isOurs : {false, true}) {
        const int width = isOurs ? 8 : 2;
        const char* fit = isOurs ? "frames" : "covariance";
        add(width, fit, "mean", "chain");
        for (const char* leaf : kThesisLeafSplits) add(width, fit, "axis", leaf);
        if (!isOurs) continue;
        for (const char* leaf : kThesisLeafSplits) add(width, fit, "sah", leaf);
    }
    return all;
}

std::string nameOf(const BuildOptions& build) {
    return build.generalSplit + "/" + build.leafSplit + " width " + std::to_string(build.nodeWidth);
}

/// A part and an environment of several models, queried as one environment.
struct Asked {
    BuildOptions build;
    Model part;
    std::vector<Model> environment;
    std::vector<Workspace> workspaces;

    Asked(const StudyProblem& problem, const BuildOptions& options)
        : build(options), part(Model::build(problem.part, options)) {
        for (const ObstacleGroup& group : problem.obstacles.groups) {
            environment.push_back(Model::build(group.mesh, options));
        }
        workspaces.resize(environment.size());
    }

    bool touches(const Pose& pose) {
        for (std::size_t i = 0; i < environment.size(); ++i) {
            if (collides(part, environment[i], pose, workspaces[i])) return true;
        }
        return false;
    }

    struct Interval {
        double lower = std::numeric_limits<double>::infinity(),
               upper = std::numeric_limits<double>::infinity();
    };
    Interval distanceAt(const Pose& pose) {
        Interval least;
        for (std::size_t i = 0; i < environment.size(); ++i) {
            DistanceOptions options;
            options.cap = least.upper;
            const DistanceResult found = distance(part, environment[i], pose, options, workspaces[i]);
            least.lower = std::min(least.lower, found.lower);
            least.upper = std::min(least.upper, found.upper);
        }
        return least;
    }
};

/// The seconds of each block of poses.
struct BlockTimes {
    std::vector<double> distances, collisions;
};

class Measuring {
  public:
    Measuring(const StudyProblem& problem, const std::vector<Pose>& poses, const StudyOptions& options)
        : problem_(problem), poses_(poses), options_(options) {}

    /// Returns false when the study was stopped.
    bool run(std::vector<TreeRow>& rows) {
        for (const BuildOptions& build : measuredTrees()) {
            if (options_.mustStop()) return false;
            asked_.push_back(std::make_unique<Asked>(problem_, build));
            compareWithFirst(*asked_.back());
        }
        if (!timeAll()) return false;
        for (std::size_t i = 0; i < asked_.size(); ++i) rows.push_back(rowOf(*asked_[i], times_[i]));
        return true;
    }

  private:
    void compareWithFirst(Asked& asked) {
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            const bool touches = asked.touches(poses_[i]);
            const Asked::Interval found = asked.distanceAt(poses_[i]);
            if (asked_.size() == 1) {
                touching_.push_back(touches);
                intervals_.push_back(found);
                continue;
            }
            const Asked::Interval& first = intervals_[i];
            if (touches == touching_[i] && found.lower <= first.upper && first.lower <= found.upper) continue;
            throw std::logic_error(fmt::format("at pose {} {} and {} contradict each other", i + 1,
                                               nameOf(asked_[0]->build), nameOf(asked.build)));
        }
    }

    bool timeAll() {
        const std::size_t engines = asked_.size();
        using Repeated = std::vector<std::vector<double>>;  // [block][repetition]
        std::vector<Repeated> distances(engines, Repeated(kBlocks)), collisions = distances;
        for (int repetition = 0; repetition < options_.repetitions; ++repetition) {
            for (std::size_t turn = 0; turn < engines; ++turn) {
                if (options_.mustStop()) return false;
                const std::size_t i = (turn + static_cast<std::size_t>(repetition)) % engines;
                timeBlocks([&](const Pose& pose) { asked_[i]->distanceAt(pose); }, distances[i]);
                timeBlocks([&](const Pose& pose) { asked_[i]->touches(pose); }, collisions[i]);
            }
        }
        for (std::size_t i = 0; i < engines; ++i) {
            times_.emplace_back();
            for (std::size_t block = 0; block < kBlocks; ++block) {
                times_[i].distances.push_back(median(distances[i][block]));
                times_[i].collisions.push_back(median(collisions[i][block]));
            }
        }
        return true;
    }

    template <class Ask>
    void timeBlocks(const Ask& ask, std::vector<std::vector<double>>& times) const {
        for (std::size_t block = 0; block < kBlocks; ++block) {
            const double begin = threadSeconds();
            for (std::size_t i = poses_.size() * block / kBlocks; i < poses_.size() * (block + 1) / kBlocks;
                 ++i) {
                ask(poses_[i]);
            }
            times[block].push_back(threadSeconds() - begin);
        }
    }

    TreeRow rowOf(const Asked& asked, const BlockTimes& times) const {
        TreeRow row;
        row.scene = problem_.name;
        row.nodeWidth = asked.build.nodeWidth;
        row.fit = asked.build.fit;
        row.generalSplit = asked.build.generalSplit;
        row.leafSplit = asked.build.leafSplit;
        row.poses = poses_.size();
        double bytes = 0;
        std::array<std::uint64_t*, 4> leavesBySize = {&row.leavesOf1, &row.leavesOf2, &row.leavesOf3,
                                                      &row.leavesOf4};
        for (const Model& model : asked.environment) {
            const BuildReport& report = model.report();
            row.buildSeconds += report.seconds;
            bytes += static_cast<double>(report.tree.bytes);
            row.triangles += report.triangles;
            row.leaves += report.tree.leaves;
            for (std::size_t i = 0; i < leavesBySize.size() && i + 1 < report.tree.leavesBySize.size(); ++i) {
                *leavesBySize[i] += report.tree.leavesBySize[i + 1];
            }
        }
        row.megabytes = bytes / kBytesPerMegabyte;
        row.colliding = static_cast<std::uint64_t>(std::count(touching_.begin(), touching_.end(), true));
        row.distancesBlockSeconds = times.distances;
        row.collisionsBlockSeconds = times.collisions;
        row.distancesPerSecond = rateOf(times.distances);
        row.collisionsPerSecond = rateOf(times.collisions);
        addThesis(row);
        return row;
    }

    double rateOf(const std::vector<double>& blocks) const {
        return static_cast<double>(poses_.size()) / std::accumulate(blocks.begin(), blocks.end(), 0.0);
    }

    void addThesis(TreeRow& row) const {
        const ThesisScene* thesis = thesisSceneOf(problem_.name);
        if (thesis == nullptr) return;
        const auto value = [&](TreeMeasure measure) {
            return thesisValue(*thesis, measure, row.generalSplit, row.leafSplit);
        };
        row.thesisScene = thesis->name;
        row.thesisDistances = value(TreeMeasure::kDistancesPerSecond);
        row.thesisCollisions = value(TreeMeasure::kCollisionsPerSecond);
        row.thesisBuildSeconds = value(TreeMeasure::kBuildSeconds);
        row.thesisMegabytes = value(TreeMeasure::kMegabytes);
        row.thesisLeaves = value(TreeMeasure::kLeaves);
    }

    const StudyProblem& problem_;
    const std::vector<Pose>& poses_;
    const StudyOptions& options_;
    std::vector<std::unique_ptr<Asked>> asked_;
    std::vector<bool> touching_;
    std::vector<Asked::Interval> intervals_;
    std::vector<BlockTimes> times_;
};

const std::vector<ThesisScene>& thesisScenes() {
    using Leaves = std::array<std::array<double, 4>, 4>;
    static const std::vector<ThesisScene> kScenes = {
        {"Cembox",
         "cembox",
         {563, 595, 578, 528},
         {3842, 3842, 3842, 3842},
         {205, 595},
         {3.72, 6.31},
         {41, 35},
         std::nullopt},
        {"TunnelConsole",
         "tunnel-console",
         {335, 358, 339, 283},
         {2240, 2240, 2200, 2126},
         {230, 358},
         {2.42, 4.05},
         {28, 24},
         Leaves{{{5469, 25513, 41062, 30180},
                 {36310, 38221, 35639, 20183},
                 {88144, 40539, 26613, 12835},
                 {300401, 0, 0, 0}}}},
        {"LargeEnvironment",
         "large-environment",
         {35.8, 58.3, 37.9, 38.7},
         {3151, 16223, 16310, 16310},
         {18, 58},
         {14.61, 25.97},
         {150, 128},
         std::nullopt},
    };
    return kScenes;
}

}  // namespace

const ThesisScene* thesisSceneOf(const std::string& scene) {
    for (const ThesisScene& each : thesisScenes()) {
        if (scene.rfind(each.family, 0) == 0) return &each;
    }
    return nullptr;
}

Measure thesisValue(const ThesisScene& scene, TreeMeasure measure, const std::string& generalSplit,
                    const std::string& leafSplit) {
    const auto found = std::find(kThesisLeafSplits.begin(), kThesisLeafSplits.end(), leafSplit);
    if (found == kThesisLeafSplits.end()) return std::nullopt;
    const auto leaf = static_cast<std::size_t>(found - kThesisLeafSplits.begin());
    const bool isAxis = generalSplit == "axis", isChain = leafSplit == "chain";
    if (measure == TreeMeasure::kDistancesPerSecond && isAxis) return scene.distances[leaf];
    if (measure == TreeMeasure::kCollisionsPerSecond && isAxis) return scene.collisions[leaf];
    if (measure == TreeMeasure::kLeaves && isAxis && scene.leaves) {
        const auto& bySize = (*scene.leaves)[leaf];
        return std::accumulate(bySize.begin(), bySize.end(), 0.0);
    }
    if (!isChain || (!isAxis && generalSplit != "mean")) return std::nullopt;
    if (measure == TreeMeasure::kDistancesPerSecond) return scene.generalDistances[0];
    if (measure == TreeMeasure::kBuildSeconds) return scene.buildSeconds[isAxis];
    if (measure == TreeMeasure::kMegabytes) return scene.megabytes[isAxis];
    return std::nullopt;
}

Columns<TreeRow> treeColumns() {
    using Row = TreeRow;
    return {{"scene", &Row::scene},
            {"node_width", &Row::nodeWidth},
            {"fit", &Row::fit},
            {"general_split", &Row::generalSplit},
            {"leaf_split", &Row::leafSplit},
            {"triangles", &Row::triangles},
            {"build_seconds", &Row::buildSeconds},
            {"megabytes", &Row::megabytes},
            {"leaves_1", &Row::leavesOf1},
            {"leaves_2", &Row::leavesOf2},
            {"leaves_3", &Row::leavesOf3},
            {"leaves_4", &Row::leavesOf4},
            {"leaves", &Row::leaves},
            {"poses", &Row::poses},
            {"colliding", &Row::colliding},
            {"distances_per_second", &Row::distancesPerSecond},
            {"collisions_per_second", &Row::collisionsPerSecond},
            {"distances_block_seconds", &Row::distancesBlockSeconds},
            {"collisions_block_seconds", &Row::collisionsBlockSeconds},
            {"thesis_scene", &Row::thesisScene},
            {"thesis_distances_per_second", &Row::thesisDistances},
            {"thesis_collisions_per_second", &Row::thesisCollisions},
            {"thesis_build_seconds", &Row::thesisBuildSeconds},
            {"thesis_megabytes", &Row::thesisMegabytes},
            {"thesis_leaves", &Row::thesisLeaves}};
}

std::size_t treeRowCount(const std::string& scene) {
    return thesisSceneOf(scene) ? measuredTrees().size() : 0;
}

std::optional<std::vector<TreeRow>> measureTrees(const StudyProblem& problem, const std::vector<Pose>& poses,
                                                 const StudyOptions& options) {
    std::vector<TreeRow> rows;
    if (!Measuring(problem, poses, options).run(rows)) return std::nullopt;
    return rows;
}

}  // namespace clearway::study
