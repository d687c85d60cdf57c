// A box whose faces are cut into grids of cells, two triangles each: many equal triangles in few planes.
#pragma once

#include "program/scenes/piece.h"

namespace clearway::scenes {

/// The cells are as near to cubes as their number allows. So that there are exactly `triangles` (one less if
/// that is odd), some cells are cut into four about their middle. triangles: 12 or more.
Piece gridBox(const Box& box, std::size_t triangles);

}  // namespace clearway::scenes
