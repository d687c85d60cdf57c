// The mean of points and the axes along which they spread.
#pragma once

#include <vector>

#include "clearway/types.h"

namespace clearway {

struct PrincipalFrame {
    Vector3 mean;
    Matrix3 axes;  ///< orthonormal, right-handed; the columns by falling spread
};

/// Of the points' covariance, each point with weight 1. At least one point; any scale; equal points give some
/// frame.
PrincipalFrame principalFrame(const std::vector<Vector3>& points);

}  // namespace clearway
