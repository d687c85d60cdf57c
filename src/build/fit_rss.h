// Fits a rectangle swept sphere to points: in a given frame, or in the frame of their covariance. Source: Larsen, Gottschalk,
// Lin, Manocha, Fast Proximity Queries with Swept Sphere Volumes, TR99-018, 1999.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tree/rss.h"

namespace clearway {

/// The eigenvectors of a covariance, by rising spread: orthonormal unless the covariance is not finite.
Matrix3 spreadAxes(const Matrix3& covariance);

/// The mean of points and the axes along which they spread.
struct PrincipalFrame {
    Vector3 mean;
    Matrix3 axes;  ///< orthonormal, right-handed; the columns by falling spread
};

/// The frame of the points' covariance, each point with weight 1. Needs at least one point; takes any scale.
/// Equal points give some frame.
PrincipalFrame principalFrame(const std::vector<Vector3>& points);

/// Larsen's fit around the points. The rectangle lies along the frame's first two columns (orthonormal;
/// either side may be the longer one). The volume holds every point up to rounding in double. Needs at least
/// one point. Scaling all points by a power of two scales the result exactly, and the order of the points
/// does not matter.
Rss fitRss(const std::vector<Vector3>& points, const Matrix3& axes);

/// Larsen's fit in the points' principal frame: a0 along the greatest spread, the normal along the smallest.
/// A point that comes twice weighs twice.
Rss fitRss(const std::vector<Vector3>& points);

}  // namespace clearway
