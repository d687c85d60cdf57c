// FCL's answers to the torture cases.
#pragma once

#include "bench/peer.h"
#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway::testing {

struct FclAnswer {
    bool isThere = true;  ///< false if FCL threw or its distance is not a number
    double distance = 0;  ///< 0 or less on contact
    bool collides = false;
};

/// FCL's trees of two meshes: RSS for distances, OBBRSS for collisions.
class FclCheck {
  public:
    FclCheck(const Mesh& part, const Mesh& environment);
    FclAnswer ask(const Pose& pose) const;

  private:
    Peer distances_, collisions_;
};

}  // namespace clearway::testing
