#include "build/leaf_centre.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "tree/flat_tree.h"

namespace clearway {
namespace {

/// A centre is a multiple of about this share of the box's half side: a number of few bits, so that the corners' differences
/// from it have few.
constexpr int kGridExponent = -6;

/// A centre's coordinate may be 0 if the corners' are at most this many times the box's half side along it, or this share
/// of the box's largest half side.
constexpr double kReachOfZero = 4, kShareOfZero = 0.125;

struct Coordinate {
    float stored;
    double value;
};

bool isDenormal(float x) {
    return x != 0 && std::abs(x) < std::numeric_limits<float>::min();
}

/// The coordinate that is stored for a value.
Coordinate nearestTo(double value, double origin, double unit, double inverseUnit) {
    float stored = static_cast<float>((value - origin) * inverseUnit);
    if (isDenormal(stored)) stored = 0;
    return {stored, leafCentre(origin, unit, stored)};
}

/// The exponent of a normal number, and less than any for a denormal one. In place of std::ilogb, which is a call.
int exponentOf(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return static_cast<int>((bits >> 52) & 2047) - 1023;
}

/// 2 to a normal number's exponent.
double powerOfTwo(int exponent) {
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    double power;
    std::memcpy(&power, &bits, sizeof power);
    return power;
}

/// The multiple of a power of two, about 2^kGridExponent times the half side, that is nearest to the middle.
double coarseMiddle(double middle, double halfSide) {
    if (middle == 0 || halfSide == 0) return middle;
    // A double is a multiple of 2^-52 times its own power of two already.
    const int exponent = std::max(exponentOf(halfSide) + kGridExponent, exponentOf(middle) - 52);
    if (std::abs(exponent) > 1000) return middle;
    return std::nearbyint(middle * powerOfTwo(-exponent)) * powerOfTwo(exponent);
}

/// Whether centre plus offset is each corner. A program may have told the processor to take denormal numbers for 0, so no
/// offset may be denormal.
bool areSums(const double* corners, std::size_t count, double centre, double unit, double inverseUnit) {
    int isSum = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const float offset = leafOffset(corners[i], centre, inverseUnit);
        isSum &= int(!isDenormal(offset)) & int(centre + unit * double(offset) == corners[i]);
    }
    return isSum != 0;
}

}  // namespace

LeafCentre chooseLeafCentre(const LeafCorners& corners, const Vector3& origin, double unit) {
    const double inverseUnit = 1 / unit;
    double low[3], high[3], half[3];
    for (int k = 0; k < 3; ++k) {
        const auto [least, greatest] = std::minmax_element(corners.at[k], corners.at[k] + corners.count);
        low[k] = *least;
        high[k] = *greatest;
        half[k] = 0.5 * high[k] - 0.5 * low[k];
    }
    LeafCentre middles{{}, {}, true}, chosen{{}, {}, true};
    for (int k = 0; k < 3; ++k) {
        const auto take = [k](const Coordinate& from, LeafCentre& centre) {
            centre.stored[std::size_t(k)] = from.stored;
            centre.point[k] = from.value;
        };
        const double middle = 0.5 * low[k] + 0.5 * high[k];
        const Coordinate near = nearestTo(coarseMiddle(middle, half[k]), origin[k], unit, inverseUnit);
        take(near, middles);
        take(near, chosen);
        if (areSums(corners.at[k], corners.count, near.value, unit, inverseUnit)) continue;
        const Coordinate zero = nearestTo(0, origin[k], unit, inverseUnit);
        const double farthest = std::max(std::abs(low[k]), std::abs(high[k]));
        const double mostNear =
            std::max(kReachOfZero * half[k], kShareOfZero * *std::max_element(half, half + 3));
        if (zero.value == 0 && farthest <= mostNear &&
            areSums(corners.at[k], corners.count, 0, unit, inverseUnit)) {
            take(zero, chosen);
        } else {
            chosen.isExact = false;
        }
    }
    if (chosen.isExact) return chosen;
    middles.isExact = false;
    return middles;
}

}  // namespace clearway
