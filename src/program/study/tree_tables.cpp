#include "program/study/tree_tables.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "core/number.h"
#include "program/study/paired_ratio.h"
#include "program/study/thesis.h"
#include "program/study/thread_clock.h"

namespace clearway::study {
namespace {

constexpr std::size_t kBlocks = 20;
constexpr std::size_t kLeafSizes = 4;
constexpr double kBytesPerMegabyte = 1024.0 * 1024.0;
constexpr const char* kThesisMeasures[] = {"distances_per_second", "collisions_per_second", "build_seconds",
                                           "megabytes", "leaves"};

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

/// A part and an environment of several models, asked as one.
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

/// [block] seconds.
struct BlockTimes {
    std::vector<double> distances, collisions;
};

class Measuring {
  public:
    Measuring(const StudyProblem& problem, const std::vector<Pose>& poses, const StudyOptions& options)
        : problem_(problem), poses_(poses), options_(options) {}

    bool run(std::vector<TableRow>& rows) {
        for (const BuildOptions& build : measuredTrees()) {
            if (isStopped()) return false;
            if (options_.tell) options_.tell(problem_.name + ": tables, building " + nameOf(build));
            asked_.push_back(std::make_unique<Asked>(problem_, build));
            compareWithFirst(*asked_.back());
        }
        if (options_.tell)
            options_.tell(problem_.name + ": tables, " + std::to_string(poses_.size()) + " poses");
        if (!timeAll()) return false;
        for (std::size_t i = 0; i < asked_.size(); ++i) rows.push_back(rowOf(*asked_[i], times_[i]));
        return true;
    }

  private:
    bool isStopped() const { return options_.isStopped && options_.isStopped(); }

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
            throw std::logic_error("at pose " + std::to_string(i + 1) + " " + nameOf(asked_[0]->build) +
                                   " and " + nameOf(asked.build) + " contradict each other");
        }
    }

    bool timeAll() {
        const std::size_t engines = asked_.size();
        using Repeated = std::vector<std::vector<double>>;  // [block][repetition]
        std::vector<Repeated> distances(engines, Repeated(kBlocks)), collisions = distances;
        for (int repetition = 0; repetition < options_.repetitions; ++repetition) {
            for (std::size_t turn = 0; turn < engines; ++turn) {
                if (isStopped()) return false;
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

    TableRow rowOf(const Asked& asked, const BlockTimes& times) const {
        TableRow row = {{"scene", problem_.name},
                        {"node_width", std::to_string(asked.build.nodeWidth)},
                        {"fit", asked.build.fit},
                        {"general_split", asked.build.generalSplit},
                        {"leaf_split", asked.build.leafSplit},
                        {"poses", std::to_string(poses_.size())}};
        double seconds = 0, bytes = 0;
        std::size_t triangles = 0;
        std::vector<std::size_t> leaves(kLeafSizes + 1);
        for (const Model& model : asked.environment) {
            const BuildReport& report = model.report();
            seconds += report.seconds;
            bytes += static_cast<double>(report.tree.bytes);
            triangles += report.triangles;
            leaves[0] += report.tree.leaves;
            for (std::size_t size = 1; size <= kLeafSizes && size < report.tree.leavesBySize.size(); ++size) {
                leaves[size] += report.tree.leavesBySize[size];
            }
        }
        row["triangles"] = std::to_string(triangles);
        row["build_seconds"] = shortNumber(seconds);
        row["megabytes"] = shortNumber(bytes / kBytesPerMegabyte);
        row["leaves"] = std::to_string(leaves[0]);
        for (std::size_t size = 1; size <= kLeafSizes; ++size) {
            row["leaves_" + std::to_string(size)] = std::to_string(leaves[size]);
        }
        row["colliding"] = std::to_string(std::count(touching_.begin(), touching_.end(), true));
        writeTimes("distances", times.distances, row);
        writeTimes("collisions", times.collisions, row);
        writeThesis(row);
        return row;
    }

    void writeTimes(const std::string& what, const std::vector<double>& blocks, TableRow& row) const {
        const double all = std::accumulate(blocks.begin(), blocks.end(), 0.0);
        row[what + "_per_second"] = shortNumber(static_cast<double>(poses_.size()) / all);
        std::string& text = row[what + "_block_seconds"];
        for (const double seconds : blocks) text += (text.empty() ? "" : " ") + shortNumber(seconds);
    }

    void writeThesis(TableRow& row) const {
        const ThesisScene* thesis = thesisSceneOf(problem_.name);
        if (thesis == nullptr) return;
        row["thesis_scene"] = thesis->name;
        for (const char* measure : kThesisMeasures) {
            const auto value = thesisValue(*thesis, measure, row["general_split"], row["leaf_split"]);
            if (value) row[std::string("thesis_") + measure] = shortNumber(*value);
        }
    }

    const StudyProblem& problem_;
    const std::vector<Pose>& poses_;
    const StudyOptions& options_;
    std::vector<std::unique_ptr<Asked>> asked_;
    std::vector<bool> touching_;
    std::vector<Asked::Interval> intervals_;
    std::vector<BlockTimes> times_;
};

}  // namespace

std::vector<std::string> treeColumns() {
    std::vector<std::string> columns = {"scene",      "node_width", "fit",           "general_split",
                                        "leaf_split", "triangles",  "build_seconds", "megabytes",
                                        "leaves_1",   "leaves_2",   "leaves_3",      "leaves_4",
                                        "leaves",     "poses",      "colliding"};
    columns.insert(columns.end(), {"distances_per_second", "collisions_per_second", "distances_block_seconds",
                                   "collisions_block_seconds", "thesis_scene"});
    for (const char* measure : kThesisMeasures) columns.push_back(std::string("thesis_") + measure);
    return columns;
}

bool measureTrees(const StudyProblem& problem, const std::vector<Pose>& poses, const StudyOptions& options,
                  GrowingTable& trees) {
    const auto isOfScene = [&](const TableRow& row) { return row.at("scene") == problem.name; };
    const auto there = std::count_if(trees.rows().begin(), trees.rows().end(), isOfScene);
    if (static_cast<std::size_t>(there) >= measuredTrees().size()) return true;
    if (there > 0) trees.remove(isOfScene);  // the program's end cut them short
    if (poses.empty())
        throw std::invalid_argument(problem.name + " has no poses to measure at, expected at least one");
    std::vector<TableRow> rows;
    if (!Measuring(problem, poses, options).run(rows)) return false;
    trees.append(rows);
    return true;
}

}  // namespace clearway::study
