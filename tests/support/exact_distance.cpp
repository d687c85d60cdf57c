#include "support/exact_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway::testing {
namespace {

using Integer = ExactDistance::Integer;

constexpr int kNoExponent = std::numeric_limits<int>::max();

/// The number mantissa 2^exponent; the mantissa is odd or 0.
struct Scaled {
    std::int64_t mantissa = 0;
    int exponent = kNoExponent;
};

Scaled scaled(double x) {
    if (x == 0) return {};
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    exponent -= 53;
    while (mantissa % 2 == 0) {
        mantissa /= 2;
        ++exponent;
    }
    return {mantissa, exponent};
}

/// A sum of products of two doubles each, not yet evaluated.
struct ProductSum {
    std::array<Scaled, 4> a, b;
    int terms = 0;

    void add(double x, double y) {
        if (x == 0 || y == 0) return;
        a[terms] = scaled(x);
        b[terms++] = scaled(y);
    }
    int leastExponent() const {
        int least = kNoExponent;
        for (int k = 0; k < terms; ++k) least = std::min(least, a[k].exponent + b[k].exponent);
        return least;
    }
    Integer over(int exponent) const {
        Integer sum = 0;
        for (int k = 0; k < terms; ++k) {
            Integer product = a[k].mantissa;
            product *= b[k].mantissa;
            sum += product << (a[k].exponent + b[k].exponent - exponent);
        }
        return sum;
    }
};

using Point = std::array<Integer, 3>;
using Corners = std::array<Point, 3>;

Point operator-(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Integer dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The least fraction so far.
struct Least {
    Integer numerator = -1;  ///< -1: none yet
    Integer denominator = 1;

    void take(const Integer& n, const Integer& d) {
        if (numerator >= 0 && n * denominator >= numerator * d) return;
        numerator = n;
        denominator = d;
    }
};

struct Side {
    Corners corner, edge;
    Point normal;
    Integer normalSquared;
    std::array<Integer, 3> edgeSquared;

    explicit Side(const Corners& corners)
        : corner(corners),
          edge{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]},
          normal(cross(edge[0], edge[1])),
          normalSquared(dot(normal, normal)),
          edgeSquared{dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2])} {}
};

void takeCorners(const Side& a, const Side& b, Least& least) {
    for (const Point& p : a.corner) {
        for (const Point& q : b.corner) {
            const Point between = q - p;
            least.take(dot(between, between), 1);
        }
    }
}

// The ends of the edge are corners, which were taken before.
void takeCornersOverEdges(const Side& corners, const Side& edges, Least& least) {
    for (const Point& p : corners.corner) {
        for (int k = 0; k < 3; ++k) {
            const Point from = p - edges.corner[k];
            const Integer along = dot(from, edges.edge[k]);
            if (along <= 0 || along >= edges.edgeSquared[k]) continue;
            const Point across = cross(from, edges.edge[k]);
            least.take(dot(across, across), edges.edgeSquared[k]);
        }
    }
}

// Takes a pair of edges only if the common normal of their lines meets both edges. Otherwise a corner is
// closest.
void takeEdges(const Side& a, const Side& b, Least& least) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Point normal = cross(a.edge[i], b.edge[j]);
            const Integer squared = dot(normal, normal);
            if (squared == 0) continue;
            const Point between = b.corner[j] - a.corner[i];
            const Integer s = dot(cross(between, b.edge[j]), normal);
            if (s < 0 || s > squared) continue;
            const Integer t = dot(cross(between, a.edge[i]), normal);
            if (t < 0 || t > squared) continue;
            const Integer height = dot(between, normal);
            least.take(height * height, squared);
        }
    }
}

void takeCornersOverFace(const Side& corners, const Side& face, Least& least) {
    if (face.normalSquared == 0) return;
    for (const Point& p : corners.corner) {
        const Point from[3] = {p - face.corner[0], p - face.corner[1], p - face.corner[2]};
        const auto isInside = [&](int k) { return dot(cross(face.edge[k], from[k]), face.normal) >= 0; };
        if (!isInside(0) || !isInside(1) || !isInside(2)) continue;
        const Integer height = dot(from[0], face.normal);
        least.take(height * height, face.normalSquared);
    }
}

// The edge pierces the face: its ends are on opposite sides of the plane, and its line is on one side of all
// three edges.
bool pierces(const Side& edges, const Side& face) {
    if (face.normalSquared == 0) return false;
    std::array<int, 3> side;
    for (int k = 0; k < 3; ++k) side[k] = dot(edges.corner[k] - face.corner[0], face.normal).sign();
    for (int k = 0; k < 3; ++k) {
        if (side[k] * side[(k + 1) % 3] >= 0) continue;  // ends that touch count as corners over the face
        bool isAnyLeft = false, isAnyRight = false;
        for (int j = 0; j < 3; ++j) {
            const Point from = face.corner[j] - edges.corner[k];
            const int turn = dot(cross(from, face.edge[j]), edges.edge[k]).sign();
            isAnyLeft |= turn > 0;
            isAnyRight |= turn < 0;
        }
        if (!(isAnyLeft && isAnyRight)) return true;
    }
    return false;
}

Least leastSquare(const Side& a, const Side& b) {
    Least least;
    if (pierces(a, b) || pierces(b, a)) {
        least.take(0, 1);
        return least;
    }
    takeCorners(a, b, least);
    if (least.numerator == 0) return least;
    takeCornersOverEdges(a, b, least);
    takeCornersOverEdges(b, a, least);
    takeCornersOverFace(a, b, least);
    takeCornersOverFace(b, a, least);
    if (least.numerator == 0) return least;
    takeEdges(a, b, least);
    return least;
}

/// The sign of a - b 2^exponent.
int compareShifted(const Integer& a, const Integer& b, int exponent) {
    return exponent >= 0 ? a.compare(b << exponent) : Integer(a << -exponent).compare(b);
}

}  // namespace

int ExactDistance::compare(double d) const {
    if (std::isinf(d)) return -1;
    const Scaled bound = scaled(d);
    if (bound.mantissa == 0) return isZero() ? 0 : 1;
    Integer square = bound.mantissa;
    square *= square;
    return compareShifted(numerator, square * denominator, 2 * (bound.exponent - exponent));
}

int ExactDistance::compare(const ExactDistance& other) const {
    return compareShifted(numerator * other.denominator, other.numerator * denominator,
                          2 * (other.exponent - exponent));
}

long double ExactDistance::rounded() const {
    if (isZero()) return 0;
    // A quotient of about 130 bits with an even exponent.
    int shift = 130 + int(msb(denominator)) - int(msb(numerator));
    shift += shift % 2;
    const Integer quotient =
        shift >= 0 ? Integer((numerator << shift) / denominator) : numerator / (denominator << -shift);
    return std::ldexp(std::sqrt(static_cast<long double>(quotient)), exponent - shift / 2);
}

Rational ExactDistance::squared() const {
    using boost::multiprecision::cpp_int;
    const Rational power(cpp_int(1) << std::abs(2 * exponent));
    const Rational square = Rational(cpp_int(numerator), cpp_int(denominator));
    return exponent >= 0 ? square * power : square / power;
}

ExactDistance exactDistance(const Pose& X_environmentPart, const std::array<Vector3, 3>& part,
                            const std::array<Vector3, 3>& environment) {
    std::array<std::array<ProductSum, 3>, 3> moved, fixed;
    int exponent = kNoExponent;
    for (int corner = 0; corner < 3; ++corner) {
        for (int row = 0; row < 3; ++row) {
            ProductSum& sum = moved[corner][row];
            for (int column = 0; column < 3; ++column) {
                sum.add(X_environmentPart.rotation(row, column), part[corner][column]);
            }
            sum.add(X_environmentPart.translation[row], 1);
            fixed[corner][row].add(environment[corner][row], 1);
            exponent = std::min({exponent, sum.leastExponent(), fixed[corner][row].leastExponent()});
        }
    }
    if (exponent == kNoExponent) return {};  // all corners at the origin
    Corners a, b;
    for (int corner = 0; corner < 3; ++corner) {
        for (int row = 0; row < 3; ++row) {
            a[corner][row] = moved[corner][row].over(exponent);
            b[corner][row] = fixed[corner][row].over(exponent);
        }
    }
    const Least least = leastSquare(Side(a), Side(b));
    return {least.numerator, least.denominator, exponent};
}

}  // namespace clearway::testing
