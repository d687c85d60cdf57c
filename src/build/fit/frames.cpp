#include "build/fit/frames.h"

#include <algorithm>
#include <array>

#include "build/fit/point_covariance.h"

namespace clearway {

namespace {

/// Above this many triangles a single one says little about the shape of all.
constexpr std::uint32_t kMostForEdges = 64;
constexpr int kEdgeFrames = 4;

struct EdgeFrame {
    double areaSquared = 0;  ///< of the triangle, times 4
    Matrix3 axes;
};

/// Along the triangle's longest edge and its normal. Without area when it has none.
EdgeFrame edgeFrame(const Vector3& a, const Vector3& b, const Vector3& c) {
    Vector3 longest = b - a;
    for (const Vector3& edge : {Vector3(c - b), Vector3(a - c)}) {
        if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
    }
    const Vector3 normal = (b - a).cross(c - a);
    EdgeFrame frame;
    frame.areaSquared = normal.squaredNorm();
    frame.axes.col(0) = longest.stableNormalized();
    frame.axes.col(2) = normal.stableNormalized();
    frame.axes.col(1) = frame.axes.col(2).cross(frame.axes.col(0)).normalized();
    return frame;
}

bool isOrthonormal(const Matrix3& axes) {
    return (axes.transpose() * axes - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-9;
}

void considerLargestTriangles(const FitInput& node, FrameSearch& frames) {
    std::array<std::pair<double, std::uint32_t>, kMostForEdges> byArea;
    for (std::uint32_t i = 0; i < node.triangleCount; ++i) {
        const auto& [a, b, c] = node.mesh.triangles()[node.firstTriangle + i];
        const auto& v = node.mesh.vertices();
        byArea[i] = {-(v[b] - v[a]).cross(v[c] - v[a]).squaredNorm(), i};
    }
    const std::size_t count = std::min<std::size_t>(kEdgeFrames, node.triangleCount);
    std::partial_sort(byArea.begin(), byArea.begin() + count, byArea.begin() + node.triangleCount);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [a, b, c] = node.mesh.triangles()[node.firstTriangle + byArea[i].second];
        const auto& v = node.mesh.vertices();
        const EdgeFrame frame = edgeFrame(v[a], v[b], v[c]);
        if (isOrthonormal(frame.axes)) frames.consider(frame.axes);
    }
}

}  // namespace

Rss fitLeastOfFrames(const FitInput& node, FitScratch& scratch) {
    FrameSearch& frames = scratch.frames;
    frames.begin(node.points);
    frames.consider(principalFrame(node.points).axes);
    if (node.moments.area > 0) frames.consider(node.moments.axes());
    if (node.parentAxes != nullptr) frames.consider(*node.parentAxes);
    frames.consider(Matrix3::Identity());
    if (node.triangleCount <= kMostForEdges) considerLargestTriangles(node, frames);
    return frames.leastArea();
}

}  // namespace clearway
