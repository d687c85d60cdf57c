#include "support/triangle_distance.h"

#include <algorithm>
#include <limits>

namespace clearway::testing {
namespace {

void keepNearer(TriangleDistance& best, const LongVector& onA, const LongVector& onB) {
    const long double distance = (onA - onB).norm();
    if (distance < best.distance) best = {distance, onA, onB};
}

LongVector closestOnSegment(const LongVector& point, const LongVector& start, const LongVector& end) {
    const LongVector along = end - start;
    const long double lengthSquared = along.squaredNorm();
    if (!(lengthSquared > 0)) return start;
    const long double fromStart = along.dot(point - start);
    // Measured from the nearer end, so that a point beside the far end loses no digits.
    if (2 * fromStart <= lengthSquared) return start + std::max(fromStart / lengthSquared, 0.0L) * along;
    return end - std::max(along.dot(end - point) / lengthSquared, 0.0L) * along;
}

// The point where the lines' common normal meets the first segment, computed with determinants. This keeps
// its digits for nearly parallel lines, where the usual quotient of dot products loses half of them. The
// vertex-face pairs try the ends, which cover every other case.
void tryEdges(TriangleDistance& best, const LongVector& a0, const LongVector& a1, const LongVector& b0,
              const LongVector& b1) {
    const LongVector alongA = a1 - a0;
    const LongVector alongB = b1 - b0;
    const LongVector normal = alongA.cross(alongB);
    const long double normalSquared = normal.squaredNorm();
    if (!(normalSquared > 0)) return;
    const long double s = (b0 - a0).cross(alongB).dot(normal) / normalSquared;
    const LongVector onA = a0 + std::clamp(s, 0.0L, 1.0L) * alongA;
    const LongVector onB = closestOnSegment(onA, b0, b1);
    keepNearer(best, onA, onB);
    keepNearer(best, closestOnSegment(onB, a0, a1), onB);
}

// The point of the face under `point`, if there is one.
bool footOnFace(const LongVector& point, const LongTriangle& triangle, LongVector& foot) {
    const LongVector u = triangle[1] - triangle[0];
    const LongVector v = triangle[2] - triangle[0];
    const LongVector toPoint = point - triangle[0];
    const LongVector normal = u.cross(v);
    const long double normalSquared = normal.squaredNorm();
    if (!(normalSquared > 0)) return false;
    const long double s = toPoint.cross(v).dot(normal) / normalSquared;
    const long double t = u.cross(toPoint).dot(normal) / normalSquared;
    if (!(s >= 0 && t >= 0 && s + t <= 1)) return false;
    foot = triangle[0] + s * u + t * v;
    return true;
}

// For an edge whose ends lie on both sides of a face: the edge's point in the face's plane, and the face's
// point nearest to it.
void tryPiercing(TriangleDistance& best, const LongVector& start, const LongVector& end,
                 const LongTriangle& face, bool edgeIsOfA) {
    const LongVector normal = (face[1] - face[0]).cross(face[2] - face[0]);
    const long double heightOfStart = normal.dot(start - face[0]);
    const long double heightOfEnd = normal.dot(end - face[0]);
    if (!((heightOfStart < 0 && heightOfEnd > 0) || (heightOfStart > 0 && heightOfEnd < 0))) return;
    const LongVector crossing = start + heightOfStart / (heightOfStart - heightOfEnd) * (end - start);
    const LongVector onFace = closestOnTriangle(crossing, face);
    edgeIsOfA ? keepNearer(best, crossing, onFace) : keepNearer(best, onFace, crossing);
}

}  // namespace

LongVector closestOnTriangle(const LongVector& point, const LongTriangle& triangle) {
    LongVector closest = closestOnSegment(point, triangle[2], triangle[0]);
    for (int i = 0; i < 2; ++i) {
        const LongVector onEdge = closestOnSegment(point, triangle[i], triangle[i + 1]);
        if ((point - onEdge).squaredNorm() < (point - closest).squaredNorm()) closest = onEdge;
    }
    LongVector foot;
    if (footOnFace(point, triangle, foot) && (point - foot).squaredNorm() < (point - closest).squaredNorm()) {
        closest = foot;
    }
    return closest;
}

TriangleDistance triangleDistance(const LongTriangle& first, const LongTriangle& second) {
    // Coordinates relative to a corner keep the digits of a pair far from the origin.
    const LongVector& origin = first[0];
    const LongTriangle a = {first[0] - origin, first[1] - origin, first[2] - origin};
    const LongTriangle b = {second[0] - origin, second[1] - origin, second[2] - origin};
    TriangleDistance best{std::numeric_limits<long double>::infinity(), {}, {}};
    for (int i = 0; i < 3; ++i) {
        keepNearer(best, a[i], closestOnTriangle(a[i], b));
        keepNearer(best, closestOnTriangle(b[i], a), b[i]);
        tryPiercing(best, a[i], a[(i + 1) % 3], b, true);
        tryPiercing(best, b[i], b[(i + 1) % 3], a, false);
        for (int j = 0; j < 3; ++j) {
            tryEdges(best, a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]);
        }
    }
    best.pointOnA += origin;
    best.pointOnB += origin;
    return best;
}

LongTriangle toLong(const std::array<Vector3, 3>& triangle) {
    return {triangle[0].cast<long double>(), triangle[1].cast<long double>(),
            triangle[2].cast<long double>()};
}

LongVector moved(const Pose& X_ab, const Vector3& point) {
    const Eigen::Matrix<long double, 3, 3> rotation = X_ab.rotation.cast<long double>();
    return rotation * point.cast<long double>() + X_ab.translation.cast<long double>();
}

LongTriangle moved(const Pose& X_ab, const std::array<Vector3, 3>& triangle) {
    return {moved(X_ab, triangle[0]), moved(X_ab, triangle[1]), moved(X_ab, triangle[2])};
}

}  // namespace clearway::testing
