// The corners of a mesh's triangles in float, one after the other in the order in which a split arranges the triangles.
#pragma once

#include <array>
#include <cstddef>

#include "build/scratch_array.h"
#include "mesh/clean.h"
#include "tree/flat_tree.h"
#include "tree/normalisation.h"

namespace clearway {

/// A corner in normalised coordinates. With the first corner comes the triangle's position in the mesh, as storeWholeNumber
/// stores it.
struct alignas(16) Corner {
    float at[4];
};

struct TriangleCorners {
    std::array<ScratchArray<Corner>, 3> corner;

    explicit TriangleCorners(std::size_t triangles) {
        for (ScratchArray<Corner>& corners : corner) corners.withRoomFor(triangles);
    }

    std::uint32_t triangle(std::size_t i) const { return wholeNumberIn(corner[0][i].at[3]); }

    void set(std::size_t i, std::uint32_t triangle, const CleanMesh& mesh, const Normalisation& normalised) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3 point = normalised(mesh.vertices[mesh.triangles[triangle][k]]);
            corner[k][i] = {{float(point[0]), float(point[1]), float(point[2]), 0}};
        }
        storeWholeNumber(triangle, corner[0][i].at[3]);
    }
};

}  // namespace clearway
