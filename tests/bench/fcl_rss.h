// FCL 0.7's mesh distance with its RSS tree, behind three lines: the peer of the benchmark.
//
// Debian's library holds the explicit instantiations of BVHModel<RSS<double>> and fcl::distance<double> that
// this uses, so the traversal timed is Debian's own -O2 code; only what its headers leave to be inlined is
// compiled with our flags.
#pragma once

#include <memory>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway::testing {

class FclRssPair {
  public:
    FclRssPair(const Mesh& part, const Mesh& environment);
    ~FclRssPair();

    struct Answer {
        double distance = 0;
        double nanoseconds = 0;  ///< of the query alone
    };

    /// Exact distance (no tolerance), without nearest points, which is the least FCL can be asked for.
    Answer distance(const Pose& X_environmentPart) const;

    double buildSeconds() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace clearway::testing
