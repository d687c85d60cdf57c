// The spread of a surface or of its corners, in double, to be summed over the parts of a tree.
#include <cmath>

#include "build/frames-inl.h"

#if defined(CLEARWAY_BUILD_WEIGHTED_SPREAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_BUILD_WEIGHTED_SPREAD_INL_H_
#undef CLEARWAY_BUILD_WEIGHTED_SPREAD_INL_H_
#else
#define CLEARWAY_BUILD_WEIGHTED_SPREAD_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// Mean and spread of weighted points. Each part of a surface weighs as much as its area, or each corner as much as the others.
struct WeightedSpread {
    double weight = 0;
    double mean[3] = {};
    double second[6] = {};  ///< sums of w (x - mean) (x - mean)^T: xx, yy, zz, xy, yz, zx

    void add(const WeightedSpread& other) {
        if (!(other.weight > 0)) return;
        const double share = other.weight / (weight + other.weight);
        double offset[3];
        for (int k = 0; k < 3; ++k) {
            offset[k] = other.mean[k] - mean[k];
            mean[k] += share * offset[k];
        }
        for (int k = 0; k < 6; ++k) {
            const int p = k % 3, q = k < 3 ? p : (p + 1) % 3;
            second[k] += other.second[k] + weight * share * offset[p] * offset[q];
        }
        weight += other.weight;
    }

    Covariance covariance() const {
        const double first[3] = {};
        return CovarianceOf(weight, first, second);
    }
};

/// The spread of a triangle's area, or of its corners. The scatter of the area about its mean is area / 12 times the sum over the
/// corners; that of the corners themselves is this sum.
inline WeightedSpread SpreadOfTriangle(const double (&corners)[3][3], bool isByArea) {
    WeightedSpread spread;
    double normalSquared = 0;
    for (int k = 0; k < 3; ++k) {
        const int p = k, q = (k + 1) % 3;
        const double normal = (corners[1][p] - corners[0][p]) * (corners[2][q] - corners[0][q]) -
                              (corners[1][q] - corners[0][q]) * (corners[2][p] - corners[0][p]);
        normalSquared += normal * normal;
        spread.mean[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
    }
    spread.weight = isByArea ? std::sqrt(normalSquared) : 3;
    const double share = isByArea ? spread.weight / 12 : 1;
    for (int k = 0; k < 6; ++k) {
        const int p = k % 3, q = k < 3 ? p : (p + 1) % 3;
        for (const auto& corner : corners)
            spread.second[k] += share * (corner[p] - spread.mean[p]) * (corner[q] - spread.mean[q]);
    }
    return spread;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif  // CLEARWAY_BUILD_WEIGHTED_SPREAD_INL_H_
