#include "exact/ray_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/ball.h"
#include "exact/integer.h"

namespace clearway {
namespace {

/// Bounds the origin's error relative to the lengths involved. The origin is computed with the pose's transposed rotation instead of
/// its inverse; the two differ by 3 kPoseDefect at most.
constexpr double kOriginSlack = 8 * kPoseDefect;

template <class Number>
std::optional<int> signOf(const Number& x) {
    const Verdict notNegative = isNotNegative(x), notPositive = isNotNegative(-x);
    if (notNegative == Verdict::yes && notPositive == Verdict::yes) return 0;
    if (notNegative == Verdict::yes && notPositive == Verdict::no) return 1;
    if (notNegative == Verdict::no && notPositive == Verdict::yes) return -1;
    return std::nullopt;
}

template <class Number>
Number determinant(const Triple<Number>& a, const Triple<Number>& b, const Triple<Number>& c) {
    return a.dot(b.cross(c));
}

/// The side on which a point lies of an edge that it is in line with, after a move by (e, e^2) in the mesh's
/// x and y with e positive and vanishing. The edge's direction decides it; 0 for an edge along z.
int sideOfMovedPoint(const Vector3& from, const Vector3& to) {
    if (from.y() != to.y()) return from.y() > to.y() ? 1 : -1;
    return from.x() == to.x() ? 0 : from.x() < to.x() ? 1 : -1;
}

/// The crossing of the ray from 0 along z; empty when the numbers are too inexact to decide. w: the corners, z: the mesh's z axis, both
/// in the frame of the decision.
template <class Number>
std::optional<int> crossingOf(const std::array<Triple<Number>, 3>& w, const Triple<Number>& z,
                              const CornerPointers& corners) {
    int side = 0;
    for (int k = 0; k < 3; ++k) {
        std::optional<int> sign = signOf(determinant(w[k], w[(k + 1) % 3], z));
        if (!sign) return std::nullopt;
        if (*sign == 0) sign = sideOfMovedPoint(*corners[k], *corners[(k + 1) % 3]);
        if (*sign == 0 || (side != 0 && *sign != side)) return 0;
        side = *sign;
    }
    const std::optional<int> height = signOf(determinant(w[0], w[1] - w[0], w[2] - w[0]));
    if (!height) return std::nullopt;
    return *height == side ? side : 0;
}

/// The sign where the error bound leaves no doubt of it, else 0, also after an overflow.
int sureSign(double value, double error) {
    return value > error ? 1 : -value > error ? -1 : 0;
}

/// Decides the crossing of the ray from p, which is within `error` of the true origin, in double; empty where the sign of a determinant
/// is in doubt.
///
/// The signs are those that crossingOf() asks for: the frame of the decision is an affine map of the mesh's, with a determinant above 0.
/// With u64 = 2^-53, each difference of coordinates has a relative error of u64. So a product of two has at most 3 u64, and the difference
/// of two such products at most 4 u64 of the sum of their sizes. A height sums three such differences, each times a difference: 8 u64.
/// The bounds take twice as much, which also covers the rounding of the bounds themselves. Products that underflow lose at most
/// 2^-1074 each, which kLeast covers. A move of p by `error` moves an edge's determinant by at most the error times the edge's
/// length, and the height by the error times the normal's length; both are bounded by sums of sizes, and doubled.
std::optional<int> roundedCrossing(const Vector3& p, double error, const CornerPointers& corners) {
    constexpr double kRounding = 0x1p-53, kLeast = std::numeric_limits<double>::min();
    const Vector3 &a = *corners[0], &b = *corners[1], &c = *corners[2];
    const Vector3 pa = a - p, pb = b - p, pc = c - p, ab = b - a, bc = c - b, ca = a - c;
    const auto sideOfEdge = [&](const Vector3& from, const Vector3& edge) {
        const double left = from.x() * edge.y(), right = from.y() * edge.x();
        const double rounding = 8 * kRounding * (std::abs(left) + std::abs(right)) + kLeast;
        return sureSign(left - right, rounding + 2 * error * (std::abs(edge.x()) + std::abs(edge.y())));
    };
    const int sides[] = {sideOfEdge(pa, ab), sideOfEdge(pb, bc), sideOfEdge(pc, ca)};
    const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
    if (least < 0 && most > 0) return 0;
    if (sides[0] == 0 || sides[1] == 0 || sides[2] == 0) return std::nullopt;

    double height = 0, rounding = kLeast;  // pa times the normal, (a - c) x (b - a)
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double left = ca[i] * ab[j], right = ca[j] * ab[i];
        const double size = std::abs(left) + std::abs(right) + kLeast;
        height += pa[k] * (left - right);
        rounding += 16 * kRounding * (std::abs(pa[k]) * size) + 2 * error * size;
    }
    const int above = sureSign(height, rounding);
    if (above == 0) return std::nullopt;
    return above == sides[0] ? above : 0;
}

bool isIdentity(const Pose& pose) {
    return pose.rotation == Matrix3::Identity() && pose.translation == Vector3::Zero();
}

}  // namespace

ZRay::ZRay(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point)
    : X_aMesh_(X_aMesh), X_aPoint_(X_aPoint), point_(point), origin_(point), error_(0) {
    if (isIdentity(X_aMesh) && isIdentity(X_aPoint)) return;
    const Vector3 away = X_aPoint * point - X_aMesh.translation;
    origin_ = X_aMesh.rotation.transpose() * away;
    const double lengths = away.lpNorm<1>() + X_aMesh.translation.lpNorm<1>() +
                           X_aPoint.translation.lpNorm<1>() + point.lpNorm<1>();
    error_ = kOriginSlack * lengths + std::numeric_limits<double>::min();
}

int ZRay::crossing(const CornerPointers& corners) const {
    const std::optional<int> sure = roundedCrossing(origin_, error_, corners);
    return sure ? *sure : exactCrossing(corners);
}

int ZRay::exactCrossing(const CornerPointers& corners) const {
    const Triple<Ball> q = movedBall(X_aPoint_, point_);
    std::array<Triple<Ball>, 3> w;
    for (int k = 0; k < 3; ++k) w[k] = movedBall(X_aMesh_, *corners[k]) - q;
    const Pose X_aAxes{X_aMesh_.rotation, Vector3::Zero()};
    const Vector3 z = Vector3::UnitZ();
    if (const std::optional<int> sure = crossingOf(w, movedBall(X_aAxes, z), corners)) return *sure;

    int exponent = lastBitOf(X_aPoint_, point_);
    for (const Vector3* corner : corners) exponent = std::min(exponent, lastBitOf(X_aMesh_, *corner));
    const Triple<Integer> base = movedInteger(X_aPoint_, point_, exponent);
    std::array<Triple<Integer>, 3> exact;
    for (int k = 0; k < 3; ++k) exact[k] = movedInteger(X_aMesh_, *corners[k], exponent) - base;
    return crossingOf(exact, movedInteger(X_aAxes, z, lastBitOf(X_aAxes, z)), corners).value();
}

}  // namespace clearway
