// Draws meshes and poses from bytes such that near misses are likely: small integers and halves, earlier
// numbers and points again, numbers that differ from them by a last digit or a small power of two, and points
// on earlier edges.
#pragma once

#include <vector>

#include "clearway/build_options.h"
#include "clearway/mesh.h"
#include "fuzz/bytes.h"

namespace clearway::testing {

class SoupReader {
  public:
    /// isWild: any double may come, also infinities and NaN.
    SoupReader(Bytes& bytes, bool isWild) : bytes_(bytes), isWild_(isWild) {}

    double coordinate();
    Vector3 point();
    /// A mesh of 1 to `most` triangles over its own points.
    Mesh soup(std::size_t most);
    /// A rotation by quarter turns or by a drawn quaternion; sometimes without translation.
    Pose pose();

  private:
    double earlier() { return numbers_[bytes_.below(std::min<std::size_t>(numbers_.size(), 256))]; }
    Bytes& bytes_;
    bool isWild_;
    std::vector<double> numbers_{0};
    std::vector<Vector3> points_{Vector3::Zero()};
};

BuildOptions takeOptions(Bytes& bytes);

}  // namespace clearway::testing
