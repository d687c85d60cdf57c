// The tree as queries read it: wide nodes in structure-of-arrays order, leaves' triangles in float relative to their own
// centre, and the exact vertices in double behind them.
//
// All floats are in the tree's unit, 2^unitExponent mesh units, chosen so that the mesh's radius about the tree's origin is
// at most 1: they neither overflow nor vanish, whatever the mesh's scale, and scaling by the unit is exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "clearway/types.h"

namespace clearway {

/// The volumes of a node's kWidth children, one lane per child. An unused lane has child kNoChild and radius -infinity,
/// so that its lower bound is +infinity. kWidth * 56 bytes.
template <int kWidth>
struct alignas(kWidth * 4) WideNode {
    float centre[3][kWidth];
    float axis0[3][kWidth];
    float axis1[3][kWidth];
    float halfLength0[kWidth];
    float halfLength1[kWidth];
    float radius[kWidth];
    float size
        [kWidth];  ///< side of a square as large as the rectangle grown by the radius; says which side to open
    std::int32_t child[kWidth];  ///< >= 0 a node, < 0 the leaf ~child; used lanes come first
};
static_assert(sizeof(WideNode<8>) == 8 * 56 && sizeof(WideNode<2>) == 2 * 56);

constexpr std::int32_t kNoChild = std::numeric_limits<std::int32_t>::min();

/// A lane of a node: node * kWidth + lane. The root volume is lane 0 of node 0, which has no other lane.
using VolumeReference = std::uint32_t;

struct Leaf {
    std::array<double, 3> centre;  ///< mesh coordinates; what its float vertices are relative to
    std::uint32_t firstTriangle;   ///< into FlatTree::triangles
    std::uint32_t triangleCount;   ///< 1 to 16
    float radius;                  ///< largest vertex distance from the centre, tree units, rounded up
};

struct FlatTree {
    int nodeWidth = 8;
    Vector3 origin = Vector3::Zero();  ///< mesh coordinates; what node floats are relative to
    int unitExponent = 0;
    float radius = 0;  ///< of the vertices about the origin, tree units, rounded up; <= 1

    std::vector<WideNode<2>> nodes2;  ///< one of the two is empty
    std::vector<WideNode<8>> nodes8;
    std::vector<Leaf> leaves;
    /// For a leaf of n triangles, 9 n floats from 9 * firstTriangle: x of the n first corners, their y, their z, then the
    /// second corners and the third. (vertex - leaf centre) / unit, rounded. Ends with padding for whole-vector loads.
    std::vector<float> leafVertices;

    std::vector<Vector3> vertices;                        ///< exact, mesh coordinates
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into vertices, in leaf order
    std::vector<std::uint32_t> triangleIds;               ///< the loader's id of each, in leaf order
    Box box;                           ///< of the mesh, triangles left out of the tree included
    double radiusAboutMeshOrigin = 0;  ///< largest |vertex|, rounded up

    template <int kWidth>
    const WideNode<kWidth>* nodes() const {
        if constexpr (kWidth == 2) {
            return nodes2.data();
        } else {
            static_assert(kWidth == 8);
            return nodes8.data();
        }
    }
};

/// Floats kept after the last leaf's vertices, so that a kernel may load past the end.
constexpr std::size_t kLeafPadding = 16;

}  // namespace clearway
