// MeanSplit: cuts each node at the mean of its corners, square to their greatest spread.
#include <utility>

#include "build/fit_rss.h"
#include "build/general_splits.h"
#include "build/top_down.h"

namespace clearway {

BinaryTree buildByMeanSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup) {
    return buildTopDown(mesh, std::move(triangles), largestGroup, [&mesh] {
        return [&mesh, corners = std::vector<Vector3>()](TriangleRun run) mutable {
            gatherCorners(mesh, run.first, run.size(), corners);
            const PrincipalFrame frame = principalFrame(corners);
            return partitionByPlane(mesh, run, {frame.mean, frame.axes.col(0)});
        };
    });
}

}  // namespace clearway
