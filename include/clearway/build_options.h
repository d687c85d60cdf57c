// The options for building a tree. Strategies are named as in the tables under src/build.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway {

constexpr int kLargestLeafSize = 16;  ///< triangles

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
/// std::invalid_argument that lists the known names.
BuildOptions buildPreset(const std::string& name);

/// The names of all presets ("best", "fast"), general splits ("sah", "embree", "axis", ...), leaf splits
/// ("none", "chain", "edge", "all") and fits ("frames", "covariance"), and all node widths, the widest first.
/// A build without Embree has neither "fast" nor "embree".
std::vector<std::string> buildPresetNames();
std::vector<std::string> generalSplitNames();
std::vector<std::string> leafSplitNames();
std::vector<std::string> fitNames();
std::vector<int> nodeWidths();

/// Throws std::invalid_argument that names the wrong option, its value and the possible values.
void requireBuildOptions(const BuildOptions& options);

}  // namespace clearway

#pragma GCC visibility pop
