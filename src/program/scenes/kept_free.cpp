#include "program/scenes/kept_free.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

/// No point of the part moves further between two poses that are looked at; the boxes grow by half of it.
constexpr double kStep = 3;  // mm

constexpr Box::CornerType corner(int i) {
    return static_cast<Box::CornerType>(i);
}

Box grown(const Box& box, double by) {
    return {box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by)};
}

/// Whether the axis has a gap between the triangle and the box of that half size about the origin.
bool isSeparating(const Vector3& axis, const Vector3 (&triangle)[3], const Vector3& half) {
    const double p = axis.dot(triangle[0]), q = axis.dot(triangle[1]), r = axis.dot(triangle[2]);
    const double reach = axis.cwiseAbs().dot(half);
    return std::min({p, q, r}) > reach || std::max({p, q, r}) < -reach;
}

/// By the thirteen axes of a triangle and a box.
bool meetsBox(const Vector3 (&triangle)[3], const Vector3& half) {
    const Vector3 edges[3] = {triangle[1] - triangle[0], triangle[2] - triangle[1],
                              triangle[0] - triangle[2]};
    if (isSeparating(edges[0].cross(edges[1]), triangle, half)) return false;
    for (int k = 0; k < 3; ++k) {
        if (isSeparating(Vector3::Unit(k), triangle, half)) return false;
        for (const Vector3& edge : edges) {
            if (isSeparating(Vector3::Unit(k).cross(edge), triangle, half)) return false;
        }
    }
    return true;
}

}  // namespace

KeptFree::KeptFree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (const Box& box : boxes_) {
        for (int i = 0; i < 8; ++i) radius_ = std::max(radius_, box.corner(corner(i)).norm());
    }
}

void KeptFree::addMotion(const PartState& from, const PartState& to, double margin) {
    const double motion =
        (to.position - from.position).norm() + radius_ * from.rotation.angularDistance(to.rotation);
    const int steps = std::max(1, static_cast<int>(std::ceil(motion / kStep)));
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        PartState state;
        state.position = (1 - share) * from.position + share * to.position;
        state.rotation = from.rotation.slerp(share, to.rotation);
        const Pose X_worldPart = poseOf(state);
        for (const Box& box : boxes_) {
            Obstacle obstacle{inverse(X_worldPart), grown(box, margin + kStep / 2), {}};
            for (int k = 0; k < 8; ++k) obstacle.inWorld.extend(X_worldPart * obstacle.box.corner(corner(k)));
            all_.extend(obstacle.inWorld);
            obstacles_.push_back(obstacle);
        }
    }
}

bool KeptFree::meets(const Vector3& a, const Vector3& b, const Vector3& c) const {
    Box bounds(a);
    bounds.extend(b), bounds.extend(c);
    if (!bounds.intersects(all_)) return false;
    for (const Obstacle& obstacle : obstacles_) {
        if (!bounds.intersects(obstacle.inWorld)) continue;
        const Vector3 middle = obstacle.box.center(), half = obstacle.box.sizes() / 2;
        const Vector3 triangle[3] = {obstacle.X_partWorld * a - middle, obstacle.X_partWorld * b - middle,
                                     obstacle.X_partWorld * c - middle};
        if (meetsBox(triangle, half)) return true;
    }
    return false;
}

bool KeptFree::isClearOf(const Piece& piece) const {
    Box bounds;
    for (const Vector3& vertex : piece.vertices) bounds.extend(vertex);
    if (!bounds.intersects(all_)) return true;
    for (const TriangleIndices& t : piece.triangles) {
        if (meets(piece.vertices[t[0]], piece.vertices[t[1]], piece.vertices[t[2]])) return false;
    }
    return true;
}

}  // namespace clearway::scenes
