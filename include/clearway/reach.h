// What the poses of a scene can bring together: a build may leave out the rest of the environment.
#pragma once

#include "clearway/types.h"

namespace clearway {

/// The poses X_environmentPart that will be asked about, whatever their rotation, and how far from the part
/// the answers matter. Lengths in environment units.
struct Reach {
    Box positions;  ///< of their translation: where the origin of the part's coordinates (those of its Mesh)
                    ///< may be, environment's frame; its border counts
    double partRadius = 0;  ///< at least Model::radiusAboutOrigin() of the part
    double cap = 0;         ///< no interest in a distance beyond it
};

}  // namespace clearway
