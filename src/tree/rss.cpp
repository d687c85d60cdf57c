// Measures of a rectangle swept sphere, and its rounding from double to the stored floats. Source of the
// measures: Ytterlid's thesis, 2013. The longest extent differs: the thesis prints the product of the squared
// sides, where the geometry asks for their sum.
#include "tree/rss.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway {

namespace {

constexpr double kPi = 3.14159265358979323846;

constexpr double kLeastLength = 0x1p-60;  // tree units
constexpr double kLeastAxisEntry = 0x1p-40;

/// Covers the rounding of a point's distance from the rectangle, computed in double from numbers whose sum is
/// 1: moving the point to tree units (1 rounding), its offset (1), subtracting both sides (4) and the norm
/// (4) make at most 10 u64. Tree units.
constexpr double kDistanceRounding = 16 * 0x1p-53;

/// Covers the underflow of squared lengths. Tree units.
constexpr double kUnderflow = 0x1p-100;

float flushed(double value, double least) {
    return std::abs(value) < least ? 0.0f : static_cast<float>(value);
}

Vector3 vectorOf(const float (&values)[3]) {
    return Vector3(values[0], values[1], values[2]);
}

FloatRss roundRectangle(const Rss& rss, const Vector3& origin, double inverseUnit) {
    FloatRss stored;
    const Vector3 centre = rss.centre * inverseUnit - origin * inverseUnit;
    for (int i = 0; i < 3; ++i) {
        stored.centre[i] = storedLength(centre[i]);
        stored.axis0[i] = storedAxisEntry(rss.axes(i, 0));
        stored.axis1[i] = storedAxisEntry(rss.axes(i, 1));
    }
    stored.halfLength0 = storedLength(rss.halfLength0 * inverseUnit);
    stored.halfLength1 = storedLength(rss.halfLength1 * inverseUnit);
    return stored;
}

}  // namespace

double Rss::area() const {
    const double l = 2 * halfLength0;
    const double w = 2 * halfLength1;
    return 4 * kPi * radius * radius + 2 * l * w + 2 * kPi * radius * (l + w);
}

double Rss::volume() const {
    const double l = 2 * halfLength0;
    const double w = 2 * halfLength1;
    return 4.0 / 3.0 * kPi * radius * radius * radius + 2 * radius * l * w + kPi * radius * radius * (l + w);
}

double Rss::longestExtent() const {
    return 2 * std::hypot(halfLength0, halfLength1) + 2 * radius;
}

float roundedUp(double value) {
    const float nearest = static_cast<float>(value);
    return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

float storedLength(double length) {
    return flushed(length, kLeastLength);
}

float storedAxisEntry(double entry) {
    return flushed(entry, kLeastAxisEntry);
}

float storedRadius(const FloatRss& rectangle, double distanceSquared, double normSquared) {
    const double magnitude = std::sqrt(normSquared) + vectorOf(rectangle.centre).norm() +
                             double(rectangle.halfLength0) + double(rectangle.halfLength1);
    if (magnitude == 0) return 0;  // points at the origin need no rounding
    return roundedUp(std::sqrt(distanceSquared) + kDistanceRounding * magnitude + kUnderflow);
}

FloatRss roundOutward(const Rss& rss, const std::vector<Vector3>& points, const Vector3& origin,
                      double unit) {
    const double inverseUnit = 1 / unit;
    FloatRss stored = roundRectangle(rss, origin, inverseUnit);
    const Vector3 centre = vectorOf(stored.centre);
    const Vector3 axis0 = vectorOf(stored.axis0);
    const Vector3 axis1 = vectorOf(stored.axis1);
    const double halfLength0 = stored.halfLength0;
    const double halfLength1 = stored.halfLength1;

    const Vector3 scaledOrigin = origin * inverseUnit;
    double largestDistanceSquared = 0;
    double largestNormSquared = 0;
    for (const Vector3& point : points) {
        const Vector3 x = point * inverseUnit - scaledOrigin;
        const Vector3 offset = x - centre;
        // Any s and t within the half lengths give a point of the rectangle, so their rounding does not
        // matter.
        const double s = std::clamp(offset.dot(axis0), -halfLength0, halfLength0);
        const double t = std::clamp(offset.dot(axis1), -halfLength1, halfLength1);
        largestDistanceSquared =
            std::max(largestDistanceSquared, (offset - s * axis0 - t * axis1).squaredNorm());
        largestNormSquared = std::max(largestNormSquared, x.squaredNorm());
    }
    stored.radius = storedRadius(stored, largestDistanceSquared, largestNormSquared);
    return stored;
}

}  // namespace clearway
