// What contact costs `collides`: resting poses against the same pose with a gap of a hundredth of the size.
#pragma once

#include <iosfwd>

namespace clearway::testing {

/// Times both for boxes face to face, pegs in fitting holes and shared edges, warm and cold, and prints each
/// ratio and the median over the meshes, which is returned.
double measureResting(std::ostream& out, int repetitions);

}  // namespace clearway::testing
