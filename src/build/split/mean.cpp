#include "build/split/mean.h"

#include <utility>

#include "build/fit/point_covariance.h"
#include "build/split/plane.h"
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
