// The polygons of a COLLADA geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/read/dae_document.h"

namespace clearway {

struct DaeShape {
    std::vector<Vector3> vertices;
    std::vector<std::uint32_t> corners;       ///< of all polygons; positions among the vertices
    std::vector<std::uint32_t> cornerCounts;  ///< of each polygon
    std::size_t lines = 0;
};

/// Reads a <geometry>. Refuses splines, boundary representations and polygons with holes.
DaeShape readDaeGeometry(const DaeDocument& document, const pugi::xml_node& geometry);

}  // namespace clearway
