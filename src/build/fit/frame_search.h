// The multi-frame fit: of several frames, each with three choices of the normal, the one whose RSS has the
// least area. Candidates are compared in float, several points at a time; the winner is fitted in double.
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "tree/normalisation.h"
#include "tree/rss.h"

namespace clearway {

/// Kept from node to node for its storage. Not to be shared by threads.
class FrameSearch {
  public:
    /// Forgets the frames tried. The points, of which there is at least one, are not copied.
    void begin(const std::vector<Vector3>& points);

    /// axes: orthonormal columns; each of the three may become the rectangle's normal.
    void consider(const Matrix3& axes);

    /// The fit in the frame of least area, up to the rounding of floats; at least one frame was considered.
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
