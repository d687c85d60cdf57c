// Queries in float alone: the library's own traversal, margins and kernels without the finish in double. It
// exists for comparison in the benchmarks; planners should not use it.
#pragma once

#include <memory>

#include "bench/peer.h"
#include "clearway/model.h"

namespace clearway::testing {

/// Queries in float for two models of equal node width. Threads must not share an object, because it keeps a
/// stack and a warm start, as a Workspace does.
class FloatOnly {
  public:
    /// exactRectangles: bounds volumes of wide nodes, too, by the exact distance of their rectangles.
    FloatOnly(const Model& part, const Model& environment, bool exactRectangles = false);
    ~FloatOnly();

    /// lower <= true distance <= upper, both proved in float. A pair that float does not prove apart counts
    /// as contact and ends the query: value and lower are then 0, and upper is that of the pairs met so far.
    /// Otherwise the value is the middle of the nearest pair's bounds, without the rounding margins: the
    /// number that the kernel computed.
    Answer distance(const Pose& X_environmentPart);

    /// Forgets the warm start, so that the next query is cold.
    void forgetWarmStart();

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace clearway::testing
