// Finds the frame in which the rectangle swept sphere around points has the least area.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "build/fit_rss.h"

namespace clearway {

/// Finds among several frames, each with three choices of the normal, the one whose fit has the least area.
/// Frames are compared in float, four frames at a time; the best one is fitted in double. Reused from node to
/// node for its storage; not to be shared by threads.
class FrameSearch {
  public:
    /// Starts with new points, at least one, which are not copied. Forgets the frames tried before.
    void begin(const std::vector<Vector3>& points);

    /// Tries a frame. axes: orthonormal columns; each of the three may become the rectangle's normal. Axes
    /// that are not finite are left out.
    void consider(const Matrix3& axes);

    /// The fit in the frame of least area, up to the rounding of floats. At least one frame must have been
    /// considered.
    Rss leastArea();

  private:
    static constexpr int kFrames = 4;
    using Frames = Eigen::Array<float, kFrames, 1>;  ///< a number for each of four frames

    struct Extent {
        Frames low = Frames::Constant(std::numeric_limits<float>::infinity());
        Frames high = Frames::Constant(-std::numeric_limits<float>::infinity());
        Frames length() const { return high - low; }
    };

    void rateWaiting();
    Frames areas(int side0, int side1, int normal, const Extent& depth) const;

    const std::vector<Vector3>* points_ = nullptr;
    std::vector<Eigen::Vector3f> normalised_;
    std::vector<std::array<Frames, 3>> projected_;  ///< by point, along the frames' three axes
    Matrix3 waiting_[kFrames];                      ///< frames that are not rated yet
    int waitingCount_ = 0;
    float leastArea_ = std::numeric_limits<float>::infinity();
    Matrix3 bestAxes_;
};

}  // namespace clearway
