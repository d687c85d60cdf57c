// A plate with holes, triangulated as CAD exports do it: long thin triangles from a cell's corners to its
// hole.
#pragma once

#include <functional>

#include "program/scenes/section.h"

namespace clearway::scenes {

/// The radius of the hole in the middle of a cell, 0 for none; less than half the cell's shorter side.
using HoleRadius = std::function<double(std::size_t column, std::size_t row)>;

/// Cells between increasing lines xs and ys. holeSegments: a multiple of 4.
Section holedSection(const std::vector<double>& xs, const std::vector<double>& ys, const HoleRadius& radiusOf,
                     int holeSegments);

}  // namespace clearway::scenes
