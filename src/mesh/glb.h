// Writes binary glTF 2.0 (.glb), which keeps floats, order and names exactly. assimp's own exporter joins
// vertices that lie within 1e-5 of each other on the way.
#pragma once

#include <iosfwd>
#include <vector>

#include "mesh/save_parts.h"

namespace clearway {

/// One node with one mesh for each part, both by its name. Throws std::invalid_argument when the parts need
/// more than the 4 GiB the format can address.
void writeGlb(const std::vector<SavePart>& parts, std::ostream& stream);

}  // namespace clearway
