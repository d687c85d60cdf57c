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
    double size;  ///< size of the smaller mesh; scales the drawn poses and steps
    /// Draws poses in contact, or on the verge of contact up to rounding.
    std::function<Pose(Random&)> resting;
};

/// Boxes face to face, combs and stepped profiles in one another, pegs in holes that they fill exactly or
/// nearly, tessellated spheres and fans of needles. Some have whole coordinates, so that contact is exact.
std::vector<MeshFamily> meshFamilies();

/// A comb with teeth 1 wide, 1 apart, 4 long in the plane z = 0, and 2 deep, on a back. Turned by half a
/// circle about z and moved by odd numbers, it fills another comb.
Mesh comb(int teeth);

/// Four boxes around a square hole of half side 3 along z, 4 deep; its middle is the origin.
Mesh squareHole(int cells);

/// The nearest points of part and environment at a pose, which show the way to contact.
using WayToContact = std::function<Vector3(const Pose&)>;

/// Draws a resting pose, a resting pose that is slid or turned, or any pose brought to contact along the
/// nearest points. Then moves it by a few units in the last place, by a small share of the size, or not at
/// all.
Pose adversarialPose(Random& random, const MeshFamily& family, const WayToContact& wayToContact);

}  // namespace clearway::testing
