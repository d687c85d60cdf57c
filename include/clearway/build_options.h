// The options for building a tree, and the report of a build. Strategies are named as in the tables under src/build.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway {

/// The largest BuildOptions::leafSize, in triangles.
constexpr int kLargestLeafSize = 16;

/// The options of a build. Their default values make the fastest queries.
struct BuildOptions {
    std::string generalSplit = "sah";  ///< see generalSplitNames()
    std::string leafSplit = "cost";    ///< see leafSplitNames()
    /// Most triangles that a leaf may hold, 1 to kLargestLeafSize. The leaf split "cost" makes leaves of up to 4.
    int leafSize = 4;
    int nodeWidth = 8;  ///< children of a node: 8, or 2 for the binary engine with exact rectangle distances
    std::string fit = "frames";  ///< see fitNames()
    /// Most threads to build with, 0 to 1024 (0: as many as oneTBB gives the caller). The tree does not
    /// depend on it.
    int threads = 0;
};

/// The default options, for "best" and for "fast", which had other ones before building became as fast. Throws ArgumentError for
/// any other name.
[[deprecated("BuildOptions() has these values")]] BuildOptions buildPreset(const std::string& name);

/// The names that buildPreset takes.
[[deprecated("BuildOptions() has the values of all presets")]] std::vector<std::string> buildPresetNames();

/// The names of all general splits, which divide a mesh into groups of triangles: "mean", "axis", "sah" and,
/// unless clearway was built without Embree, "embree".
std::vector<std::string> generalSplitNames();

/// The names of all leaf splits, which divide a group of triangles further: "none", "chain", "edge", "all",
/// "cost".
std::vector<std::string> leafSplitNames();

/// The names of all fits, which place a volume around its triangles: "frames", "covariance".
std::vector<std::string> fitNames();

/// All node widths, that is, numbers of children of a node; the widest first.
std::vector<int> nodeWidths();

/// Checks the options. Throws ArgumentError that names the wrong option, its value and the possible
/// values.
void requireBuildOptions(const BuildOptions& options);

/// The report of cleaning. Cleaning removes no part of the surface, only repetitions of it.
struct CleanReport {
    std::size_t weldedVertices = 0;       ///< vertices exactly equal to an earlier one
    std::size_t unusedVertices = 0;       ///< vertices that no triangle uses
    std::size_t degenerateTriangles = 0;  ///< zero area; kept as the segment or point they are
    std::size_t duplicateTriangles = 0;   ///< three vertices of an earlier triangle, in any order; dropped
};

/// The shape of a tree.
struct TreeStatistics {
    std::size_t nodes = 0;                  ///< wide nodes
    std::size_t leaves = 0;                 ///< groups of triangles at the ends of the tree
    std::vector<std::size_t> leavesBySize;  ///< [k] = leaves that hold k triangles; [0] unused
    int depth = 0;                          ///< wide nodes on the longest path from the root to a leaf
    double meanChildren = 0;                ///< used lanes per node
    std::size_t bytes = 0;                  ///< all memory of the tree, including exact vertices and ids
};

/// How a model was built, and what came out of it.
struct BuildReport {
    BuildOptions options;                  ///< as given
    CleanReport clean;                     ///< about the mesh as given
    TreeStatistics tree;                   ///< about the tree that queries use
    std::size_t triangles = 0;             ///< in the tree, without duplicates and unreachable ones
    std::size_t unreachableTriangles = 0;  ///< left out because no pose within the range comes near them
    double seconds = 0;                    ///< cleaning, fitting, splitting and flattening
};

}  // namespace clearway

#pragma GCC visibility pop
