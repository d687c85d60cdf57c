// The outside of a part whose closed surfaces touch or run into each other.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/model.h"
#include "model/solids.h"

namespace clearway {

using Corners3 = std::array<Vector3, 3>;

/// A triangle with less height over its longest edge than 1e-4 of that edge: its normal, given as a vector whose
/// length is twice its area, is too inexact to rely on.
bool isSliver(const Corners3& triangle, const Vector3& normal);

/// A model of few triangles, made in little time.
Model smallModel(const Mesh& mesh);

/// A connected closed surface that does not pass through itself.
struct SurfaceShell {
    std::size_t component;
    bool isCavity;    ///< the component is around it
    double outwards;  ///< 1, or -1 if its triangles are listed to face inwards
    Mesh mesh;
    std::vector<std::uint32_t> triangles;  ///< the position of each triangle in the part's mesh
    Solid solid;
    Model model;
};

struct OuterSurface {
    Mesh mesh;                             ///< triangles of the part, or pieces of them
    std::vector<std::uint32_t> triangles;  ///< the one of the part that each is of
};

/// The shells without what is covered. isCovered: whether a point is inside some component. A point of a shell is
/// covered if the point in front of it, at the distance `fineness`, is. So gaps narrower than that count as filled.
/// Triangles that are covered in part are bisected; a piece smaller than `fineness` is kept whole if one of four
/// points of it is not covered. So each point of the result is within the fineness of a point of the outside.
/// Throws ArgumentError when too many pieces are needed.
OuterSurface outerSurface(const std::vector<SurfaceShell>& shells,
                          const std::function<bool(const Vector3&)>& isCovered, double fineness);

}  // namespace clearway
