// From a fitted volume in double to the stored one in float that still holds every point.
#include <algorithm>
#include <cmath>

#include "core/round.h"
#include "tree/rss.h"

namespace clearway {

namespace {

/// Lengths and axis entries below these are stored as 0: products of what is left never are denormal floats,
/// which are slow. The radius, measured from the rectangle as stored, makes good for it; so small a length is
/// lost in any rounding.
constexpr double kLeastLength = 0x1p-60;  // tree units
constexpr double kLeastAxisEntry = 0x1p-40;

/// Covers the rounding of a point's distance from the rectangle, computed in double from numbers of sum 1:
/// carrying the point over (1 rounding), its offset (1), taking off both sides (4) and the norm (4) make at
/// most 10 u64. Tree units.
constexpr double kDistanceRounding = 16 * 0x1p-53;

/// Covers what underflows in the squares of lengths. Tree units.
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
        stored.centre[i] = flushed(centre[i], kLeastLength);
        stored.axis0[i] = flushed(rss.axes(i, 0), kLeastAxisEntry);
        stored.axis1[i] = flushed(rss.axes(i, 1), kLeastAxisEntry);
    }
    stored.halfLength0 = flushed(rss.halfLength0 * inverseUnit, kLeastLength);
    stored.halfLength1 = flushed(rss.halfLength1 * inverseUnit, kLeastLength);
    return stored;
}

}  // namespace

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
        // Any s and t within the half lengths give a point of the rectangle: their own rounding does not
        // matter.
        const double s = std::clamp(offset.dot(axis0), -halfLength0, halfLength0);
        const double t = std::clamp(offset.dot(axis1), -halfLength1, halfLength1);
        largestDistanceSquared =
            std::max(largestDistanceSquared, (offset - s * axis0 - t * axis1).squaredNorm());
        largestNormSquared = std::max(largestNormSquared, x.squaredNorm());
    }
    const double magnitude = std::sqrt(largestNormSquared) + centre.norm() + halfLength0 + halfLength1;
    // Points at the origin are met without any rounding: their radius is exactly 0.
    stored.radius =
        magnitude == 0
            ? 0.0f
            : roundedUp(std::sqrt(largestDistanceSquared) + kDistanceRounding * magnitude + kUnderflow);
    return stored;
}

}  // namespace clearway
