#include "shrink/depth_limit.h"

#include <algorithm>
#include <cmath>

#include "clearway/query.h"

namespace clearway {
namespace {

constexpr int kMostPieces = 24;      ///< in which a piece is looked at
constexpr double kSamePlane = 1e-9;  ///< 1 - cosine, and relative to the part's size

}  // namespace

std::vector<std::uint32_t> DepthLimit::differentPlanes(const std::vector<std::uint32_t>& triangles) const {
    const double same = kSamePlane * surface_.model().box().diagonal().norm();
    std::vector<std::uint32_t> different;
    for (const std::uint32_t t : triangles) {
        const Vector3 normal = surface_.outwardNormal(t).normalized();
        if (!(normal.squaredNorm() > 0)) continue;
        const bool isKnown = std::any_of(different.begin(), different.end(), [&](std::uint32_t other) {
            if (other == t) return true;
            if (surface_.outwardNormal(other).normalized().dot(normal) < 1 - kSamePlane) return false;
            return std::abs(normal.dot(surface_.corners(other)[0] - surface_.corners(t)[0])) <= same;
        });
        if (!isKnown) different.push_back(t);
    }
    return different;
}

bool DepthLimit::holdsIn(const Polytope& piece, const std::vector<std::uint32_t>& planes, std::size_t next,
                         Workspace& workspace) const {
    int pieces = kMostPieces;
    if (isNearSurface(piece, pieces, workspace)) return true;
    if (planes.empty()) return false;
    if (isOutside(piece, workspace)) return true;
    for (; next < planes.size(); ++next) {
        const Vector3 normal = surface_.outwardNormal(planes[next]).normalized();
        const Vector3 base = surface_.corners(planes[next])[0];
        const auto height = [&](const Vector3& p) { return normal.dot(p - base) - front_; };
        const auto depth = [&](const Vector3& p) { return -height(p); };
        const Polytope high = piece.above(height), low = piece.above(depth);
        if (high.isFlat(height) || low.isFlat(depth)) continue;  // all of the piece is on one side
        return holdsIn(high, planes, next + 1, workspace) && holdsIn(low, planes, next + 1, workspace);
    }
    return false;
}

/// Whether each point is near enough to some triangle. The distance to one triangle is convex, so corners decide. Cuts
/// off what is beside the triangle nearest to the centre and looks at it apart.
bool DepthLimit::isNearSurface(Polytope piece, int& pieces, Workspace& workspace) const {
    if (pieces-- == 0 || !piece.isSimple()) return false;
    const std::uint32_t triangle = surface_.nearest(piece.centre(), workspace);
    const Corners3 corners = surface_.corners(triangle);
    if (distanceToTriangle(piece.centre(), corners) > limit_) return false;
    const auto isNear = [&] {
        return std::all_of(piece.corners().begin(), piece.corners().end(),
                           [&](const Polytope::Corner& corner) {
                               return distanceToTriangle(corner.point, corners) <= limit_;
                           });
    };
    if (isNear()) return true;
    const Vector3 normal = surface_.outwardNormal(triangle);
    const double turned = normal.dot((corners[1] - corners[0]).cross(corners[2] - corners[0])) < 0 ? -1 : 1;
    for (int k = 0; k < 3; ++k) {
        const Vector3 across = turned * (corners[(k + 1) % 3] - corners[k]).cross(normal).normalized();
        const auto height = [&](const Vector3& p) {
            const double exact = across.dot(p - corners[k]);
            return std::abs(exact) <= surface_.rounding() ? 0.0 : exact;
        };
        Polytope beside = piece.above(height);
        if (beside.isFlat(height)) continue;
        piece = piece.above([&](const Vector3& p) { return -height(p); });
        if (piece.isEmpty() || !isNearSurface(std::move(beside), pieces, workspace)) return false;
    }
    return isNear();
}

/// Whether the surface has no point in the piece, and its centre is outside the part.
bool DepthLimit::isOutside(const Polytope& piece, Workspace& workspace) const {
    const Vector3 centre = piece.centre();
    const double outside = -surface_.at(centre, workspace).depth;
    if (outside <= 0) return false;
    const auto& corners = piece.corners();
    const bool isFarFromSurface =
        std::all_of(corners.begin(), corners.end(), [&](const Polytope::Corner& corner) {
            return (corner.point - centre).norm() + surface_.rounding() < outside;
        });
    if (isFarFromSurface) return true;
    const Mesh mesh = piece.surface();
    if (mesh.triangles.empty()) return false;
    const Box box = boundingBox(mesh);
    for (const Vector3& v : surface_.shellVertices()) {
        if (box.contains(v)) return false;
    }
    return !isWithin(smallModel(mesh), surface_.model(), {}, surface_.rounding(), workspace);
}

}  // namespace clearway
