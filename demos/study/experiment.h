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
#include "demos/study/calls.h"
#include "demos/study/table.h"

namespace clearway::study {

struct StudyOptions {
    /// OMPL's and clearway's classes. They plan for a first path; a run ends with it.
    std::vector<std::string> planners = {
        "RRTConnect", "SlidingRRTConnect", "KPIECE1", "PRM",
        "RRTstar",    "BITstar",           "LazyPRM", "AnytimePathShortening"};
    std::vector<std::string> generalSplits = {"axis", "mean", "sah"};
    std::vector<std::string> leafSplits = {"none", "chain", "edge", "all", "cost"};
    int seeds = 10;                 ///< the seeds 1 to this, for each planner and problem
    double qualifyingSeconds = 10;  ///< limit of each qualifying run
    double mostMedian = 1;          ///< seconds; a planner with a larger median does not enter a problem
    double leastLimit = 0.2;        ///< seconds; below it, a busy system could end a run before its path
    double minutes = 100;     ///< for the whole study; slow cells are left out where they would take more
    double megabytes = 8192;  ///< memory growth limit of a process while planners run
    CallSampling sampling;
    int recordedSeeds = 2;  ///< the seeds 1 to this leave samples of their calls
    int repetitions = 5;    ///< of each replay
    int loads = 3;          ///< of each scene's files, and builds of each tree; the median counts
    /// True: other leaf sizes, widths and instruction sets are not replayed.
    bool isShort = false;
    int tablePoses = 1000;

    std::function<bool()> isStopped;
    std::function<void(const std::string&)> tell;  ///< takes one line

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

/// Engines that are compared with each other.
using EngineGroup = std::vector<Engine>;

/// The engines that planners are run with, one general split after the other.
std::vector<Engine> plannedEngines(const StudyOptions& options);

/// The tree that planners qualify with: the last general split with the first leaf split.
Engine qualifyingEngine(const StudyOptions& options);

/// The engines that recorded calls are replayed with, a group at a time: first all planned ones on each of the machine's vector
/// instruction sets, then for each general split leaves of up to 8 and 16, and nodes of two children.
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
Scene buildScene(const StudyProblem& problem, const Engine& engine);

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
