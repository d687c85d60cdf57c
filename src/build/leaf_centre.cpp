#include "build/leaf_centre.h"

#include <algorithm>
#include <cmath>

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
    return std::fpclassify(x) == FP_SUBNORMAL;
}

/// The coordinate that is stored for a value.
Coordinate nearestTo(double value, double origin, double unit) {
    float stored = static_cast<float>((value - origin) / unit);
    if (isDenormal(stored)) stored = 0;
    return {stored, leafCentre(origin, unit, stored)};
}

/// The multiple of a power of two, about 2^kGridExponent times the half side, that is nearest to the middle.
double coarseMiddle(double middle, double halfSide) {
    if (middle == 0 || halfSide == 0) return middle;
    // A double is a multiple of 2^-52 times its own power of two already.
    const int exponent = std::max(std::ilogb(halfSide) + kGridExponent, std::ilogb(middle) - 52);
    const double grid = std::ldexp(1.0, exponent);
    return grid > 0 ? std::nearbyint(middle / grid) * grid : middle;
}

/// Whether centre plus offset is the corner. A program may have told the processor to take denormal numbers for 0, so no
/// offset may be denormal.
bool isSum(double corner, double centre, double unit) {
    const float offset = leafOffset(corner, centre, unit);
    return !isDenormal(offset) && centre + unit * double(offset) == corner;
}

bool areSums(const std::vector<Vector3>& corners, int k, double centre, double unit) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vector3& corner) { return isSum(corner[k], centre, unit); });
}

}  // namespace

LeafCentre chooseLeafCentre(const std::vector<Vector3>& corners, const Vector3& origin, double unit) {
    Box box;
    for (const Vector3& corner : corners) box.extend(corner);
    const Vector3 middle = 0.5 * box.min() + 0.5 * box.max(), half = 0.5 * box.max() - 0.5 * box.min();
    LeafCentre middles{{}, {}, true}, chosen{{}, {}, true};
    for (int k = 0; k < 3; ++k) {
        const auto take = [k](const Coordinate& from, LeafCentre& centre) {
            centre.stored[std::size_t(k)] = from.stored;
            centre.point[k] = from.value;
        };
        const Coordinate near = nearestTo(coarseMiddle(middle[k], half[k]), origin[k], unit);
        take(near, middles);
        take(near, chosen);
        if (areSums(corners, k, near.value, unit)) continue;
        const Coordinate zero = nearestTo(0, origin[k], unit);
        const double farthest = std::max(std::abs(box.min()[k]), std::abs(box.max()[k]));
        const bool isNear = farthest <= std::max(kReachOfZero * half[k], kShareOfZero * half.maxCoeff());
        if (zero.value == 0 && isNear && areSums(corners, k, 0, unit)) {
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
