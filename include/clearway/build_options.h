// What can be chosen about a tree. The names are the rows of the strategy tables under src/build.
#pragma once

#include <string>
#include <vector>

namespace clearway {

/// The default values are those of the preset "best".
struct BuildOptions {
    std::string generalSplit = "sah";  ///< see generalSplitNames()
    std::string leafSplit = "none";    ///< see leafSplitNames()
    int leafSize = 4;                  ///< most triangles a leaf may hold, 1 to 16
    int nodeWidth = 8;  ///< children of a node: 8, or 2 for the binary engine with exact rectangle distances
    std::string fit = "frames";  ///< see fitNames()
    /// Most threads to build with, 0 to 1024; 0: as many as oneTBB gives the caller. The tree is the same for all.
    int threads = 0;
};

/// Options to start from: "best" makes the fastest queries, "fast" builds in less time. Throws std::invalid_argument
/// that lists the known names.
BuildOptions buildPreset(const std::string& name);

/// The known presets ("best", "fast"), general splits ("sah", "embree", "axis", ...), leaf splits ("none", "chain",
/// "edge", "all"), fits ("frames", "covariance") and node widths, the widest first.
std::vector<std::string> buildPresetNames();
std::vector<std::string> generalSplitNames();
std::vector<std::string> leafSplitNames();
std::vector<std::string> fitNames();
std::vector<int> nodeWidths();

/// Throws std::invalid_argument that names the wrong option, its value and the known ones.
void requireBuildOptions(const BuildOptions& options);

}  // namespace clearway
