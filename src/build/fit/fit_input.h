// What a fit is given of a node.
#pragma once

#include <cstdint>
#include <vector>

#include "build/fit/area_moments.h"
#include "build/fit/frame_search.h"
#include "build/leaf_order.h"

namespace clearway {

struct FitInput {
    const LeafOrder& mesh;
    std::uint32_t firstTriangle;  ///< into the mesh's
    std::uint32_t triangleCount;
    const std::vector<Vector3>& points;  ///< its distinct vertices
    const AreaMoments& moments;          ///< of its triangles, in some unit
    const Matrix3* parentAxes;           ///< of the parent's volume; null for the root
};

/// Kept from node to node for its storage. Not to be shared by threads.
struct FitScratch {
    FrameSearch frames;
    std::vector<Vector3> corners;
};

}  // namespace clearway
