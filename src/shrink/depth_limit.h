// Whether convex pieces of space reach deeper into a part than a limit.
#pragma once

#include <cstdint>
#include <vector>

#include "isosurface/polytope.h"
#include "shrink/surface_depth.h"

namespace clearway {

class DepthLimit {
  public:
    /// limit: the greatest depth allowed. front: some height above 0 and not above the limit; planes in front of faces
    /// by so much part what is outside from what is near a face.
    DepthLimit(const SurfaceDepth& surface, double limit, double front)
        : surface_(surface), limit_(limit), front_(front) {}

    double limit() const { return limit_; }

    /// Whether certainly each point of the piece is outside the part or at most as deep as the limit. planes: triangles
    /// near the piece, in front of which the part's outside may be, each plane once; none for a piece in the part.
    bool holdsIn(const Polytope& piece, const std::vector<std::uint32_t>& planes,
                 Workspace& workspace) const {
        return holdsIn(piece, planes, 0, workspace);
    }

    /// Leaves out triangles in planes of others.
    std::vector<std::uint32_t> differentPlanes(const std::vector<std::uint32_t>& triangles) const;

  private:
    bool holdsIn(const Polytope& piece, const std::vector<std::uint32_t>& planes, std::size_t next,
                 Workspace& workspace) const;
    bool isNearSurface(Polytope piece, int& pieces, Workspace& workspace) const;
    bool isOutside(const Polytope& piece, Workspace& workspace) const;

    const SurfaceDepth& surface_;
    double limit_, front_;
};

}  // namespace clearway
