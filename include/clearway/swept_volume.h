// The volume swept by a part along its path, as a mesh: for those who design what stands beside it.
#pragma once

#include <functional>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/sweep.h"

#pragma GCC visibility push(default)

namespace clearway {

/// How closely sweptVolume follows the part. Lengths in environment units.
struct SweptVolumeOptions {
    double tolerance = 0;  ///< environment units, > 0: how far the mesh may be from all places of the part

    /// Poses may be off the motions by this length, because they are rounded. Below an eighth of the tolerance;
    /// environment units.
    double poseError = 0;

    /// Called now and then; true ends the work, and the result is empty.
    std::function<bool()> isStopped;
};

/// The volume swept by the part along its motions: a closed mesh, each edge of which belongs to two triangles, in the
/// environment's frame. It holds the part at every pose of the motions, and no point of its surface is further than
/// the tolerance from the part at some pose. What is inside a closed component of the part at some pose is inside the
/// mesh. Enclosed spaces that the part never enters are left out as cavities, or filled if they are narrower than
/// four tolerances.
///
/// The surface lies at half the tolerance from the part's places ("marching tetrahedra"). In small tetrahedra the
/// distances of corners show that it is off the part and near it. In larger ones, which suffice at flat and slightly
/// bent places, its triangles are certified: that the part keeps off them along all motions, and that they are near
/// one place. Time and memory grow with the area of the bent surface over the tolerance's square.
///
/// Throws ArgumentError when an option is out of its range, there is no motion, or the tolerance takes more
/// than eight million points.
Mesh sweptVolume(const Mesh& part, const std::vector<RigidMotion>& motions,
                 const SweptVolumeOptions& options);

}  // namespace clearway

#pragma GCC visibility pop
