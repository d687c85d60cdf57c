#include "build/split/mean.h"

#include <utility>

#include "bounds/covariance.h"
#include "build/split/plane.h"
#include "build/top_down.h"

namespace clearway {

BinaryTree buildByMeanSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup) {
    std::vector<Vector3> corners;
    return buildTopDown(mesh, std::move(triangles), largestGroup, [&](TriangleRun run) {
        gatherCorners(mesh, run.first, run.size(), corners);
        const PrincipalFrame frame = principalFrame(corners);
        return partitionByPlane(mesh, run, {frame.mean, frame.axes.col(0)});
    });
}

}  // namespace clearway
