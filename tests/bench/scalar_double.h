// The plain way: the same trees walked volume by volume in double, without vectors, and every pair of
// triangles that a few slabs do not prove far resolved in double. What the float traversal is measured
// against.
#pragma once

#include <memory>

#include "bench/peer.h"
#include "clearway/model.h"

namespace clearway::testing {

/// Models with nodes of 8 children. Not to be shared by threads.
class ScalarDouble {
  public:
    /// Throws std::invalid_argument when a model has nodes of another width.
    ScalarDouble(const Model& part, const Model& environment);
    ~ScalarDouble();

    /// lower <= true distance <= upper; the value is the distance of the two closest points found, 0 on
    /// contact.
    Answer distance(const Pose& X_environmentPart);

    /// One bound and no more: between the volumes around all of the part and all of the environment. value =
    /// lower, upper is infinite.
    Answer rootBound(const Pose& X_environmentPart) const;

    /// Makes the next query a cold one.
    void forgetWarmStart();

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace clearway::testing
