#include "support/exact_triangle.h"

#include <cmath>

namespace clearway::testing {
namespace {

ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational dot(const ExactPoint& a, const ExactPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactPoint cross(const ExactPoint& a, const ExactPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ExactPoint alongLine(const ExactPoint& start, const Rational& share, const ExactPoint& direction) {
    return {start[0] + share * direction[0], start[1] + share * direction[1],
            start[2] + share * direction[2]};
}

void keepSmaller(Rational& best, const Rational& value) {
    if (value < best) best = value;
}

Rational squaredToSegment(const ExactPoint& point, const ExactPoint& start, const ExactPoint& end) {
    const ExactPoint along = end - start;
    const ExactPoint toPoint = point - start;
    const Rational lengthSquared = dot(along, along);
    const Rational share = lengthSquared == 0 ? Rational(0) : dot(toPoint, along) / lengthSquared;
    if (share <= 0) return dot(toPoint, toPoint);
    const ExactPoint rest = point - (share >= 1 ? end : alongLine(start, share, along));
    return dot(rest, rest);
}

// The least of |a0 + s d1 - b0 - t d2|^2 over the unit square: at the stationary point if that lies inside,
// otherwise on the square's border, which the four end-to-segment distances cover.
Rational squaredSegments(const ExactPoint& a0, const ExactPoint& a1, const ExactPoint& b0,
                         const ExactPoint& b1) {
    Rational best = squaredToSegment(a0, b0, b1);
    keepSmaller(best, squaredToSegment(a1, b0, b1));
    keepSmaller(best, squaredToSegment(b0, a0, a1));
    keepSmaller(best, squaredToSegment(b1, a0, a1));
    const ExactPoint d1 = a1 - a0;
    const ExactPoint d2 = b1 - b0;
    const ExactPoint between = b0 - a0;
    const Rational d11 = dot(d1, d1), d12 = dot(d1, d2), d22 = dot(d2, d2);
    const Rational determinant = d11 * d22 - d12 * d12;
    if (determinant == 0) return best;
    const Rational r1 = dot(between, d1), r2 = dot(between, d2);
    const Rational s = (r1 * d22 - r2 * d12) / determinant;
    const Rational t = (r1 * d12 - r2 * d11) / determinant;
    if (s < 0 || s > 1 || t < 0 || t > 1) return best;
    const ExactPoint rest = alongLine(a0, s, d1) - alongLine(b0, t, d2);
    keepSmaller(best, dot(rest, rest));
    return best;
}

// Whether the point's projection onto the triangle's plane lies in the triangle; false for a triangle without
// area.
bool footIsInside(const ExactPoint& point, const ExactTriangle& triangle, const ExactPoint& normal) {
    for (int i = 0; i < 3; ++i) {
        const ExactPoint edge = triangle[(i + 1) % 3] - triangle[i];
        if (dot(cross(edge, point - triangle[i]), normal) < 0) return false;
    }
    return true;
}

// No value stands for infinity: the edges' distances bound the answer in that case.
void keepSmallerToFace(Rational& best, const ExactPoint& point, const ExactTriangle& face,
                       const ExactPoint& normal) {
    const Rational normalSquared = dot(normal, normal);
    if (normalSquared == 0 || !footIsInside(point, face, normal)) return;
    const Rational height = dot(point - face[0], normal);
    keepSmaller(best, height * height / normalSquared);
}

bool pierces(const ExactPoint& start, const ExactPoint& end, const ExactTriangle& face,
             const ExactPoint& normal) {
    const Rational heightOfStart = dot(start - face[0], normal);
    const Rational heightOfEnd = dot(end - face[0], normal);
    if (heightOfStart * heightOfEnd >= 0) return false;  // touching ends are vertex-face cases
    const Rational share = heightOfStart / (heightOfStart - heightOfEnd);
    return footIsInside(alongLine(start, share, end - start), face, normal);
}

ExactPoint normalOf(const ExactTriangle& triangle) {
    return cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

}  // namespace

Rational exactDistanceSquared(const ExactTriangle& a, const ExactTriangle& b) {
    const ExactPoint normalOfA = normalOf(a);
    const ExactPoint normalOfB = normalOf(b);
    Rational best = squaredSegments(a[0], a[1], b[0], b[1]);
    for (int i = 0; i < 3; ++i) {
        const ExactPoint& endOfA = a[(i + 1) % 3];
        const ExactPoint& endOfB = b[(i + 1) % 3];
        if (pierces(a[i], endOfA, b, normalOfB) || pierces(b[i], endOfB, a, normalOfA)) return 0;
        keepSmallerToFace(best, a[i], b, normalOfB);
        keepSmallerToFace(best, b[i], a, normalOfA);
        for (int j = 0; j < 3; ++j) {
            if (best == 0) return best;
            keepSmaller(best, squaredSegments(a[i], endOfA, b[j], b[(j + 1) % 3]));
        }
    }
    return best;
}

bool sharePoint(const ExactTriangle& a, const ExactTriangle& b) {
    return exactDistanceSquared(a, b) == 0;
}

ExactTriangle toExact(const std::array<Vector3, 3>& triangle) {
    return exactlyMoved(Pose{}, triangle);
}

ExactTriangle exactlyMoved(const Pose& X_ab, const std::array<Vector3, 3>& triangle) {
    ExactTriangle result;
    for (int corner = 0; corner < 3; ++corner) {
        for (int row = 0; row < 3; ++row) {
            Rational sum(X_ab.translation[row]);
            for (int column = 0; column < 3; ++column) {
                sum += Rational(X_ab.rotation(row, column)) * Rational(triangle[corner][column]);
            }
            result[corner][row] = sum;
        }
    }
    return result;
}

long double rootOf(const Rational& square) {
    return std::sqrt(static_cast<long double>(square));
}

}  // namespace clearway::testing
