// The room that a part takes on its way: a mesh around all its places, for those who design what stands beside it.
#pragma once

#include <functional>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/sweep.h"

namespace clearway {

struct SweptVolumeOptions {
    double tolerance = 0;  ///< environment units, > 0: how far the mesh may be from all places of the part

    /// Poses may be off the motions by so much, because they are rounded. Below an eighth of the tolerance.
    double poseError = 0;

    /// Asked now and then; true ends the work, and the result is empty.
    std::function<bool()> isStopped;
};

/// A closed mesh, each edge of which belongs to two triangles, in the environment's frame. It holds the part at every
/// pose of the motions, and no point of its surface is further than the tolerance from the part at some pose. What is
/// inside a closed component of the part at some pose is inside the mesh; other rooms that the part never enters are
/// left out, as cavities where they are closed in.
///
/// The distance from a point to the part's nearest place changes no faster than places. So tetrahedra smaller than the
/// tolerance tell where it is half the tolerance, by the distances of their corners ("marching tetrahedra"); larger
/// ones do where it is far from that. Time and memory grow with the surface's area over the tolerance's square.
///
/// Throws std::invalid_argument when an option is out of its range, there is no motion, or the tolerance takes more
/// than eight million points.
Mesh sweptVolume(const Mesh& part, const std::vector<RigidMotion>& motions,
                 const SweptVolumeOptions& options);

}  // namespace clearway
