// The options for building a tree. Strategies are named as in the tables under src/build.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway {

/// The largest BuildOptions::leafSize, in triangles.
constexpr int kLargestLeafSize = 16;

/// The options of a build. Their default values are those of the preset "best".
struct BuildOptions {
    std::string generalSplit = "sah";  ///< see generalSplitNames()
    std::string leafSplit = "none";    ///< see leafSplitNames()
    int leafSize = 4;                  ///< most triangles that a leaf may hold, 1 to kLargestLeafSize
    int nodeWidth = 8;  ///< children of a node: 8, or 2 for the binary engine with exact rectangle distances
    std::string fit = "frames";  ///< see fitNames()
    /// Most threads to build with, 0 to 1024 (0: as many as oneTBB gives the caller). The tree does not
    /// depend on it.
    int threads = 0;
};

/// The options of a preset: "best" makes the fastest queries, "fast" builds in less time. Throws
/// ArgumentError that lists the known names.
BuildOptions buildPreset(const std::string& name);

/// The names of all presets: "best" and, unless clearway was built without Embree, "fast".
std::vector<std::string> buildPresetNames();

/// The names of all general splits, which divide a mesh into groups of triangles: "mean", "axis", "sah" and,
/// unless clearway was built without Embree, "embree".
std::vector<std::string> generalSplitNames();

/// The names of all leaf splits, which divide a group of triangles further: "none", "chain", "edge", "all".
std::vector<std::string> leafSplitNames();

/// The names of all fits, which place a volume around its triangles: "frames", "covariance".
std::vector<std::string> fitNames();

/// All node widths, that is, numbers of children of a node; the widest first.
std::vector<int> nodeWidths();

/// Checks the options. Throws ArgumentError that names the wrong option, its value and the possible
/// values.
void requireBuildOptions(const BuildOptions& options);

}  // namespace clearway

#pragma GCC visibility pop
