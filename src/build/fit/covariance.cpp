#include "build/fit/covariance.h"

#include "build/fit/point_covariance.h"

namespace clearway {

Rss fitByCovariance(const FitInput& node, FitScratch& scratch) {
    scratch.corners.clear();
    for (std::uint32_t i = 0; i < node.triangleCount; ++i) {
        for (const std::uint32_t vertex : node.mesh.triangles()[node.firstTriangle + i])
            scratch.corners.push_back(node.mesh.vertices()[vertex]);
    }
    return fitRss(node.points, principalFrame(scratch.corners).axes);
}

}  // namespace clearway
