// Pairs of small meshes that fit each other, and poses in which they rest on each other or nearly do.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "support/random_meshes.h"

namespace clearway::testing {

struct MeshFamily {
    std::string name;
    Mesh part;
    Mesh environment;
    double size;  ///< of the smaller mesh: where poses are drawn, steps are scaled
    std::function<Pose(Random&)>
        resting;  ///< in contact, or on the verge of it by the rounding of its numbers
};

/// Boxes face to face, combs and stepped profiles in one another, pegs in holes they fill or nearly do,
/// tessellated spheres and fans of needles. Some have whole coordinates, so that contact is exact.
std::vector<MeshFamily> meshFamilies();

/// Teeth 1 wide, 1 apart and 4 long in the plane z = 0, 2 deep, on a back: turned by half a circle about z
/// and moved by odd numbers it fills another.
Mesh comb(int teeth);

/// Four boxes around a square hole of half side 3 along z, 4 deep; its middle is the origin.
Mesh squareHole(int cells);

/// Nearest points of part and environment at a pose: the way to contact.
using WayToContact = std::function<Vector3(const Pose&)>;

/// Resting, resting and slid or turned, or any pose brought to contact along the way there; then moved by a
/// few units in the last place or a small share of the size, or not at all.
Pose adversarialPose(Random& random, const MeshFamily& family, const WayToContact& wayToContact);

}  // namespace clearway::testing
