// The reach of a scene's poses: a build may leave out the triangles of the environment beyond it.
#pragma once

#include "clearway/types.h"

namespace clearway {

/// The poses X_environmentPart of future queries, with any rotation, and the largest distance from the part
/// that matters. Lengths in environment units.
struct Reach {
    /// The poses' translations, that is, the places of the origin of the part's mesh coordinates, in the
    /// environment's frame. The border belongs to the box.
    Box positions;
    double partRadius = 0;  ///< at least Model::radiusAboutOrigin() of the part
    double cap = 0;         ///< larger distances do not matter
};

}  // namespace clearway
