// Writes binary glTF 2.0 (.glb), which keeps floats, order and names exactly. assimp's own exporter joins
// vertices that lie within 1e-5 of each other on the way.
#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "mesh/save_parts.h"

namespace clearway {

/// One node with one mesh for each part, both by its name. Throws std::invalid_argument when the parts need
/// more than the 4 GiB the format can address.
void writeGlb(const std::vector<SavePart>& parts, std::ostream& stream);

/// Where the moving parts are at a time; between two keys they go straight and turn evenly, the shorter way.
struct GlbKey {
    float seconds = 0;
    std::array<float, 3> position{};
    std::array<float, 4> rotation{0, 0, 0, 1};  ///< x y z w, unit length
};

/// What stands still, what moves, and how.
struct GlbMotion {
    std::vector<SavePart> still;
    std::vector<SavePart> moving;  ///< in coordinates of the node that moves
    std::string name;              ///< of that node and of the animation
    std::vector<GlbKey> keys;      ///< at least one, times rising from 0
};

/// Under a root that turns z, which is up here, to y, which is up in glTF: the still parts, and a node with
/// the moving ones and the animation. Throws as writeGlb does.
void writeMovingGlb(const GlbMotion& motion, std::ostream& stream);

}  // namespace clearway
