// Fits a rectangle swept sphere to points: in a given frame, in the frame of their covariance, or in the best
// of several frames. Source: Larsen, Gottschalk, Lin, Manocha, Fast Proximity Queries with Swept Sphere
// Volumes, TR99-018, 1999.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "tree/rss.h"

namespace clearway {

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

/// Finds among several frames, each with three choices of the normal, the one whose fit has the least area.
/// Frames are compared in float, several points at a time; the best one is fitted in double. Reused from node
/// to node for its storage; not to be shared by threads.
class FrameSearch {
  public:
    /// Starts with new points, at least one, which are not copied. Forgets the frames tried before.
    void begin(const std::vector<Vector3>& points);

    /// Tries a frame. axes: orthonormal columns; each of the three may become the rectangle's normal.
    void consider(const Matrix3& axes);

    /// The fit in the frame of least area, up to the rounding of floats. At least one frame must have been
    /// considered.
    Rss leastArea() const;

  private:
    static constexpr int kLanes = 8;
    using Lanes = Eigen::Array<float, kLanes, 1>;

    struct Extent {
        float low, high;
    };

    Extent project(const Eigen::Vector3f& axis, std::vector<Lanes>& coordinates) const;
    float area(const std::vector<Lanes>& side0, const std::vector<Lanes>& side1,
               const std::vector<Lanes>& normal, const Extent& depth) const;

    const std::vector<Vector3>* points_ = nullptr;
    std::vector<Lanes> x_, y_, z_;  ///< normalised; the last point fills up the last lanes
    std::vector<Lanes> projected_[3];
    float leastArea_ = std::numeric_limits<float>::infinity();
    Matrix3 bestAxes_;
};

}  // namespace clearway
