// The volumes of a tree's wide nodes, each fitted to all corners of the triangles below it. A new fit is one row of the table here
// and its frames in fit_volumes.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "build/collapse.h"
#include "build/leaf_order.h"
#include "tree/binary_tree.h"
#include "tree/flat_tree.h"
#include "tree/rss.h"

namespace clearway {

/// The frames in which volumes are fitted.
enum class FitFrames {
    /// Tries the frames of the vertices' and of the area's covariance, the one that the binary node found and, except for leaves,
    /// that of the wide node above, each with three normals. Keeps the volume of least area.
    leastOfSeveral,
    /// PQP's: of the covariance of the corners, where a vertex weighs as much as the number of the node's triangles around it. The
    /// normal is the axis of least spread.
    ofCorners,
};

struct NamedFit {
    const char* name;
    FitFrames frames;
};

constexpr NamedFit kFits[] = {
    {"frames", FitFrames::leastOfSeveral},
    {"covariance", FitFrames::ofCorners},
};

/// Throws ArgumentError that lists the known names.
const NamedFit& fitNamed(const std::string& name);

/// The lanes of a wide node.
struct WideLanes {
    int count = 0;
    std::array<std::int32_t, Collapse::kMostLanes> binaryNode;
    std::array<std::int32_t, Collapse::kMostLanes> child;  ///< the lane's own wide node; -1 for a leaf
    std::uint32_t parent = 0;                              ///< the wide node above
};

/// Takes the volume of a lane of a wide node. Called from several threads at once, once for each lane.
using PutVolume = std::function<void(std::size_t node, int lane, const FloatRss& volume)>;

/// Fits a volume to each lane, wide nodes before those below them, subtrees in parallel. nodes: [0] is above all others. tree: gives
/// its origin and unit. The volumes depend on neither the number of threads nor the instruction set.
void fitVolumes(const std::vector<WideLanes>& nodes, const BinaryTree& binary, const LeafOrder& mesh,
                const FlatTree& tree, FitFrames frames, const PutVolume& put);

}  // namespace clearway
