// The cost of contact for `collides`: resting poses compared with these poses moved to a gap of a hundredth
// of the size.
#pragma once

#include <iosfwd>

namespace clearway::testing {

/// Times resting and free poses of boxes face to face, pegs in fitting holes, shared edges and combs, warm
/// and cold. Prints each ratio, and prints and returns the median over the meshes.
double measureResting(std::ostream& out, int repetitions);

}  // namespace clearway::testing
