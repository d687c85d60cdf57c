// What can be chosen about a tree. The names are the rows of the strategy tables under src/build.
#pragma once

#include <string>
#include <vector>

namespace clearway {

struct BuildOptions {
    std::string generalSplit = "axis";  ///< see generalSplitNames()
    std::string leafSplit = "none";     ///< see leafSplitNames()
    int leafSize = 4;                   ///< most triangles a leaf may hold, 1 to 16
    int nodeWidth = 8;                  ///< children of a node: 8, or 2 for the binary engine with exact rectangle distances
};

/// The known general splits ("mean", "axis", ...), leaf splits ("none", "chain", "edge", "all") and node widths.
std::vector<std::string> generalSplitNames();
std::vector<std::string> leafSplitNames();
std::vector<int> nodeWidths();

/// Throws std::invalid_argument that names the wrong option, its value and the known ones.
void requireBuildOptions(const BuildOptions& options);

}  // namespace clearway
