// The subjects of the leaf-strategy study: its options, its engines (ways to build and query trees), and its
// problems, whose scenes are built again for each engine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "core/clock.h"
#include "demos/study/calls.h"
#include "program/bench/table.h"

namespace clearway::study {

struct StudyPlanner {
    std::string name;  ///< OMPL's class
    std::string
        objective;  ///< one of objectiveNames(); empty: the first path, or the planner's own objective
};

struct StudyRun;

struct StudyOptions {
    std::vector<StudyPlanner> planners = {
        {"RRTConnect", ""}, {"KPIECE1", ""}, {"PRM", ""}, {"RRTstar", ""}, {"BITstar", "max_min_clearance"}};
    std::vector<std::string> generalSplits = {"axis", "sah"};
    /// Leaf splits after the first are compared with the first.
    std::vector<std::string> leafSplits = {"none", "chain", "edge", "all"};
    int seeds = 10;       ///< the seeds 1 to this, for each planner with each strategy
    double seconds = 20;  ///< for each run
    double megabytes = 8192;
    CallSampling sampling;
    int repetitions = 7;  ///< of each replay
    /// True: other leaf sizes and instruction sets are replayed with one general split only.
    bool isShort = false;
    int tablePoses = 1000;
    /// Builds each model. A cache calls buildCached here.
    std::function<Model(const Mesh& mesh, const BuildOptions& options,
                        const std::optional<QueryRange>& range)>
        build = Model::build;

    std::function<bool()> isStopped;
    std::function<void(const std::string&)> tell;  ///< takes one line
    /// Takes the place of doing the planners' runs here, which are given by their numbers (see plannedRuns()): gives each one
    /// that ends to `keep`. Returns whether it has all of them.
    std::function<bool(const std::vector<std::size_t>& runs,
                       const std::function<void(const StudyRun&)>& keep)>
        doRuns;

    bool mustStop() const { return isStopped && isStopped(); }
    void report(const std::string& line) const {
        if (tell) tell(line);
    }
};

/// How trees are built, and which instruction set queries run on. The defaults are those of BuildOptions and the
/// machine's best instruction set.
struct Engine {
    std::string generalSplit, leafSplit;
    int leafSize = BuildOptions().leafSize;
    int nodeWidth = BuildOptions().nodeWidth;
    std::string instructions = "best";  ///< a name that useTarget takes

    BuildOptions build() const;

    /// The splits, and each value that differs from the defaults: "sah/chain", "sah/chain leaves of 16 avx2".
    std::string name() const;

    bool sharesTreesWith(const Engine& other) const;
    bool operator==(const Engine& other) const;
};

/// Engines that differ in the leaf split alone. The first engine is the baseline of the others.
using EngineGroup = std::vector<Engine>;

/// The engines that planners are run with, a group for each general split.
std::vector<EngineGroup> plannedGroups(const StudyOptions& options);

/// The engines that recorded calls are replayed with: the planned ones, MeanSplit, leaves of up to 8 and 16,
/// the machine's other vector instruction sets, and nodes of two children. Groups that share trees follow
/// each other.
std::vector<EngineGroup> replayedGroups(const StudyOptions& options);

struct StudyProblem {
    std::string name;  ///< names its rows and files: letters, digits, - . and _
    Problem problem;
    Mesh part;
    ObstacleGroups obstacles;
    std::shared_ptr<const Solids> partSolids;  ///< null unless an obstacle is solid
    std::vector<ShrunkPart> shrunk;            ///< one for each overlap of the obstacles
    std::vector<Pose> replayPoses;  ///< for the tables of trees; empty: the poses of recorded calls

    /// A text that differs for problems with different meshes, obstacles, start, goal, bounds or planner
    /// settings.
    std::string fingerprint() const;
};

/// Builds the scene. The environment's range suffices for planning, also with a clearance objective.
Scene buildScene(const StudyProblem& problem, const Engine& engine, const StudyOptions& options);

/// Estimates how long the remaining pieces of work take, when all pieces take equally long.
class TimeLeft {
  public:
    /// mostEach: the most seconds that a piece can take, for the estimate before the first piece is done.
    TimeLeft(std::size_t pieces, double mostEach);

    void step() { ++done_; }
    std::size_t done() const { return done_; }
    std::size_t all() const { return pieces_; }

    /// "about 12 min left", "at most 3 h 20 min left".
    std::string text() const;

  private:
    std::size_t pieces_;
    double mostEach_;
    std::size_t done_ = 0;
    Clock::time_point begin_;
};

/// The columns general_split, leaf_size, node_width, instructions and leaf_split of an engine's rows.
template <class Row>
Columns<Row> engineColumns() {
    return {{"general_split", &Row::generalSplit},
            {"leaf_size", &Row::leafSize},
            {"node_width", &Row::nodeWidth},
            {"instructions", &Row::instructions},
            {"leaf_split", &Row::leafSplit}};
}

/// Appends columns to others.
template <class Row>
Columns<Row> operator+(Columns<Row> columns, const Columns<Row>& more) {
    columns.insert(columns.end(), more.begin(), more.end());
    return columns;
}

}  // namespace clearway::study
