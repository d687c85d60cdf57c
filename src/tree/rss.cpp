// The area of a rectangle swept sphere, as in Ytterlid's thesis, 2013, and its rounding from double to the stored floats.
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

}  // namespace

double Rss::area() const {
    const double l = 2 * halfLength0;
    const double w = 2 * halfLength1;
    return 4 * kPi * radius * radius + 2 * l * w + 2 * kPi * radius * (l + w);
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

}  // namespace clearway
