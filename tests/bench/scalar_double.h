// The plain way, for comparison with the float traversal: searches clearway's trees volume by volume in
// double, without vectors, and resolves in double every pair of triangles that a few slabs do not prove far
// apart.
#pragma once

#include <memory>

#include "bench/peer.h"
#include "clearway/model.h"

namespace clearway::testing {

/// Queries in scalar double. As in the library, rectangles of binary trees have their exact distance, and those of wide nodes a
/// cheap bound. Threads must not share an object.
class ScalarDouble {
  public:
    /// The models have nodes of one width.
    ScalarDouble(const Model& part, const Model& environment);
    ~ScalarDouble();

    /// lower <= true distance <= upper; the value is the distance of the two closest points found, 0 on
    /// contact.
    Answer distance(const Pose& X_environmentPart);

    /// One bound between the volumes around all of the part and all of the environment. value = lower; upper
    /// is infinite.
    Answer rootBound(const Pose& X_environmentPart) const;

    /// Forgets the warm start, so that the next query is cold.
    void forgetWarmStart();

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace clearway::testing
