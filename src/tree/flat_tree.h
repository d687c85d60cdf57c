// The tree as queries read it: wide nodes as structures of arrays, the leaves' triangles in float relative to
// the leaf's centre, and the exact vertices in double. Here too: the node widths a tree may have.
//
// All floats are in the tree's unit, 2^unitExponent mesh units. The unit is chosen so that the mesh's radius
// about the tree's origin is at most 1: floats neither overflow nor vanish at any scale, and scaling by the
// unit is exact.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "clearway/build_report.h"
#include "clearway/types.h"

namespace clearway {

/// The widths a node may have. A new width is one more number here and a new version of saved models.
using NodeWidths = std::integer_sequence<int, 2, 8>;

template <int... kWidths>
constexpr int widestOf(std::integer_sequence<int, kWidths...>) {
    return std::max({kWidths...});
}

/// Throws std::invalid_argument that lists the known widths.
[[noreturn]] void refuseNodeWidth(int nodeWidth);

template <class Work, int kFirst, int... kOthers>
auto withNodeWidth(int nodeWidth, const Work& work, std::integer_sequence<int, kFirst, kOthers...>) {
    if (nodeWidth == kFirst) return work(std::integral_constant<int, kFirst>());
    if constexpr (sizeof...(kOthers) > 0) {
        return withNodeWidth(nodeWidth, work, std::integer_sequence<int, kOthers...>());
    } else {
        refuseNodeWidth(nodeWidth);
    }
}

/// Calls `work` with the node width as a std::integral_constant<int, width>, which templates can use. Throws
/// std::invalid_argument if no tree has nodes of this width.
template <class Work>
auto withNodeWidth(int nodeWidth, const Work& work) {
    return withNodeWidth(nodeWidth, work, NodeWidths());
}

/// The volumes of a node's kWidth children, one lane per child. An unused lane has child kNoChild and radius
/// -infinity, so that its lower bound is +infinity. kWidth * 56 bytes.
template <int kWidth>
struct alignas(kWidth * 4) WideNode {
    float centre[3][kWidth];
    float axis0[3][kWidth];
    float axis1[3][kWidth];
    float halfLength0[kWidth];
    float halfLength1[kWidth];
    float radius[kWidth];
    /// Side of a square with the area of the rectangle grown by the radius; decides which of two volumes to
    /// open.
    float size[kWidth];
    std::int32_t child[kWidth];  ///< >= 0 a node, < 0 the leaf ~child; used lanes come first
};
static_assert(sizeof(WideNode<8>) == 8 * 56 && sizeof(WideNode<2>) == 2 * 56);

template <int... kWidths>
std::tuple<std::vector<WideNode<kWidths>>...> wideNodesOf(std::integer_sequence<int, kWidths...>);

/// One array of nodes for each width.
using WideNodesByWidth = decltype(wideNodesOf(NodeWidths()));

constexpr std::int32_t kNoChild = std::numeric_limits<std::int32_t>::min();

/// A lane of a node, as node * kWidth + lane. The root volume is lane 0 of node 0, which uses no other lane.
using VolumeReference = std::uint32_t;

struct Leaf {
    std::array<double, 3> centre;  ///< mesh coordinates; origin of its float vertices
    std::uint32_t firstTriangle;   ///< into FlatTree::triangles
    std::uint32_t triangleCount;   ///< 1 to 16
    float radius;                  ///< largest vertex distance from the centre, tree units, rounded up
};

struct FlatTree {
    int nodeWidth = 8;
    Vector3 origin = Vector3::Zero();  ///< mesh coordinates; origin of the floats in nodes
    int unitExponent = 0;
    float radius = 0;  ///< of the vertices about the origin, tree units, rounded up; <= 1

    WideNodesByWidth nodesByWidth;  ///< only the array of nodeWidth has nodes
    std::vector<Leaf> leaves;
    /// A leaf of n triangles has 9 n floats from 9 * firstTriangle on: x of the n first corners, their y,
    /// their z, then the second corners and the third. Each is (vertex - leaf centre) / unit, rounded.
    /// kLeafPadding zeros follow.
    std::vector<float> leafVertices;

    std::vector<Vector3> vertices;                        ///< exact, mesh coordinates
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into vertices, in leaf order
    std::vector<std::uint32_t> triangleIds;               ///< the loader's id of each, in leaf order
    Box box;                           ///< of the mesh, including triangles left out of the tree
    double radiusAboutMeshOrigin = 0;  ///< largest |vertex|, rounded up

    template <int kWidth>
    const std::vector<WideNode<kWidth>>& nodes() const {
        return std::get<std::vector<WideNode<kWidth>>>(nodesByWidth);
    }
    template <int kWidth>
    std::vector<WideNode<kWidth>>& nodes() {
        return std::get<std::vector<WideNode<kWidth>>>(nodesByWidth);
    }
};

/// Floats kept after the last leaf's vertices, so that a kernel may load whole vectors past the end.
constexpr std::size_t kLeafPadding = 16;

/// Counts what the tree holds. Node 0, which holds only the root's volume, counts like any other.
TreeStatistics statistics(const FlatTree& tree);

/// Checks a tree from outside: returns nullptr when every reference stays within the tree and no search can
/// run in a circle, otherwise the fault in words. All triangle ids must be below meshTriangles.
const char* faultOf(const FlatTree& tree, std::size_t meshTriangles);

}  // namespace clearway
