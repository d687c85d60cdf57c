// Tables 5 to 11 of the thesis, measured on one of clearway's scenes: build cost, leaves and speed of trees
// by the thesis's strategies. Each figure is measured in the thesis's engine (nodes of 2 children, volumes
// fitted by covariance) and in clearway's, and stands beside the thesis's own figure.
// Source: R. Ytterlid, SIMD Optimized Bounding Volume Hierarchies for Fast Proximity Queries, 2013.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "demos/study/experiment.h"
#include "demos/study/table.h"

namespace clearway::study {

/// Figures of the thesis, measured on one Core 2 Duo of 2.66 GHz, 32 bit, with leaves of up to 4 triangles,
/// on the thesis's own scenes, which are not public. Rates are per second, with AxisSplit, one for each leaf
/// split in the order of kThesisLeafSplits.
struct ThesisScene {
    const char* name;
    const char* family;  ///< clearway's scenes of this size and kind have names that begin so
    std::array<double, 4> distances;
    std::array<double, 4> collisions;
    /// Values with ChainSplit, for MeanSplit and then AxisSplit. Build times and memory are those of the
    /// static model.
    std::array<double, 2> generalDistances;
    std::array<double, 2> buildSeconds;
    std::array<double, 2> megabytes;
    /// The leaves of 1, 2, 3 and 4 triangles in the static model with AxisSplit, for each leaf split. The
    /// thesis does not give them for all scenes.
    std::optional<std::array<std::array<double, 4>, 4>> leaves;
};

constexpr std::array<const char*, 4> kThesisLeafSplits = {"none", "chain", "edge", "all"};

/// Returns null when the scene belongs to no family.
const ThesisScene* thesisSceneOf(const std::string& scene);

enum class TreeMeasure { kDistancesPerSecond, kCollisionsPerSecond, kBuildSeconds, kMegabytes, kLeaves };

/// The thesis's value for trees of a general and a leaf split; empty if the thesis has none.
Measure thesisValue(const ThesisScene& scene, TreeMeasure measure, const std::string& generalSplit,
                    const std::string& leafSplit);

/// A row of trees.csv, about the trees of a scene's environment. The part's tree is built with equal options.
struct TreeRow {
    std::string scene;
    int nodeWidth = 0;
    std::string fit, generalSplit, leafSplit;
    std::uint64_t triangles = 0;
    double buildSeconds = 0, megabytes = 0;
    /// Number of leaves with so many triangles.
    std::uint64_t leavesOf1 = 0, leavesOf2 = 0, leavesOf3 = 0, leavesOf4 = 0;
    std::uint64_t leaves = 0;
    std::uint64_t poses = 0, colliding = 0;
    double distancesPerSecond = 0, collisionsPerSecond = 0;
    /// The seconds of each block of poses. Claims are judged by these.
    std::vector<double> distancesBlockSeconds, collisionsBlockSeconds;
    std::string thesisScene;  ///< empty for a scene that belongs to no family
    Measure thesisDistances, thesisCollisions, thesisBuildSeconds, thesisMegabytes, thesisLeaves;
};

Columns<TreeRow> treeColumns();

/// The number of rows that a scene has; 0 for a scene that belongs to no family.
std::size_t treeRowCount(const std::string& scene);

/// Measures a scene. One thread builds the trees. All trees are asked at equal poses, in turn, each pose with the warm start of the pose
/// before. A block's time is the median of the repetitions, in processor time. poses: at least one. Returns nothing when the study was
/// stopped. Throws std::logic_error when two engines contradict each other.
std::optional<std::vector<TreeRow>> measureTrees(const StudyProblem& problem, const std::vector<Pose>& poses,
                                                 const StudyOptions& options);

}  // namespace clearway::study
