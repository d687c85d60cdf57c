// Compares the answers about meshes at a pose with the mesh oracle, which is exact on contact.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"
#include "support/oracle.h"
#include "torture/mesh_families.h"

namespace clearway::testing {

struct CheckedPose {
    bool touches = false;
    double distance = 0;
    bool falseValid = false;  ///< a query says free although there is contact
    std::vector<std::string> complaints;
};

class MeshCheck {
  public:
    explicit MeshCheck(const MeshFamily& family);

    /// Draws the next pose of the family, and checks the queries there.
    Pose draw(Random& random);
    CheckedPose check(const Pose& pose, Random& random);

    const MeshFamily& family() const { return family_; }
    double sceneSize() const { return oracle_.sceneSize(); }

  private:
    MeshFamily family_;
    MeshOracle oracle_;
    Model part_, environment_;
    Workspace workspace_;
    double largest_;  ///< largest coordinate of either mesh
};

}  // namespace clearway::testing
