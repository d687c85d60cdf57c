// The tree as queries read it: wide nodes as structures of arrays, and leaves whose triangles are floats relative to the
// leaf's centre. In most leaves centre plus float is the vertex exactly; the others refer to vertices in double. Here too:
// the node widths a tree may have.
//
// All floats are in the tree's unit, 2^unitExponent mesh units. The unit is chosen so that the mesh's radius
// about the tree's origin is at most 1: floats neither overflow nor vanish at any scale, and scaling by the
// unit is exact.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/types.h"
#include "core/large_vector.h"

namespace clearway {

/// The widths a node may have. A new width is one more number here and a new version of saved models.
using NodeWidths = std::integer_sequence<int, 2, 8>;

template <int... kWidths>
constexpr int widestOf(std::integer_sequence<int, kWidths...>) {
    return std::max({kWidths...});
}

/// Throws ArgumentError that lists the known widths.
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
/// ArgumentError if no tree has nodes of this width.
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
std::tuple<LargeVector<WideNode<kWidths>>...> wideNodesOf(std::integer_sequence<int, kWidths...>);

/// One array of nodes for each width.
using WideNodesByWidth = decltype(wideNodesOf(NodeWidths()));

constexpr std::int32_t kNoChild = std::numeric_limits<std::int32_t>::min();

/// A lane of a node, as node * kWidth + lane. The root volume is lane 0 of node 0, which uses no other lane.
using VolumeReference = std::uint32_t;

/// The place of a leaf's block in FlatTree::leafBlocks.
using LeafReference = std::uint32_t;

/// A triangle of a tree: its leaf, and its number among the leaf's triangles.
struct TriangleAt {
    LeafReference leaf = 0;
    std::uint32_t number = 0;
};
inline bool operator==(const TriangleAt& a, const TriangleAt& b) {
    return a.leaf == b.leaf && a.number == b.number;
}

/// A leaf, as read from its block.
struct Leaf {
    LeafReference at;
    bool isExact;                  ///< whether each vertex is centre + unit * offset, as computed in double
    std::uint32_t triangleCount;   ///< 1 to 16
    float radius;                  ///< largest vertex distance from the centre, tree units, rounded up
    std::array<double, 3> centre;  ///< mesh coordinates
    /// The vertices less the centre, in tree units, rounded: x of the n first corners, their y, their z, then the second
    /// corners and the third. Whole vectors may be loaded past the last one, since what follows are ordinary floats, too.
    const float* offsets;
};

/// A leaf's block begins with the centre in tree units about the tree's origin (3 floats), the radius, and the number of
/// triangles, plus kHasVertices if the leaf is not exact. Then come the offsets, the loader's ids of the triangles, and
/// the numbers of their vertices if the leaf is not exact, three for each triangle. A whole number is stored as the float
/// that is so many steps above 1: numbers below 2^30 are then ordinary floats, never denormal ones, with which kernels
/// would be slow.
constexpr std::size_t kLeafHeader = 5;
constexpr std::uint32_t kHasVertices = 32;

/// Floats of a leaf's block.
constexpr std::size_t leafBlockSize(std::uint32_t triangleCount, bool isExact) {
    return kLeafHeader + triangleCount * std::size_t(isExact ? 10 : 13);
}

constexpr std::uint32_t kBitsOfOne = 0x3F800000;

/// The whole number that is stored in place of a float.
inline std::uint32_t wholeNumberIn(const float& place) {
    std::uint32_t bits;
    std::memcpy(&bits, &place, sizeof bits);
    return bits - kBitsOfOne;
}
inline void storeWholeNumber(std::uint32_t number, float& place) {
    const std::uint32_t bits = number + kBitsOfOne;
    std::memcpy(&place, &bits, sizeof bits);
}

/// The centre's coordinate as every reader of a leaf computes it.
inline double leafCentre(double origin, double unit, float stored) {
    return origin + unit * double(stored);
}

struct FlatTree {
    int nodeWidth = 8;
    Vector3 origin = Vector3::Zero();  ///< mesh coordinates; origin of the floats in nodes
    int unitExponent = 0;
    double unit = 1;   ///< 2^unitExponent mesh units
    float radius = 0;  ///< of the vertices about the origin, tree units, rounded up; <= 1

    WideNodesByWidth nodesByWidth;     ///< only the array of nodeWidth has nodes
    LargeVector<float> leafBlocks;     ///< one after the other; kLeafPadding zeros follow
    std::vector<Vector3> vertices;     ///< those of leaves that are not exact; mesh coordinates
    Box box;                           ///< of the mesh, including triangles left out of the tree
    double radiusAboutMeshOrigin = 0;  ///< largest |vertex|, rounded up

    template <int kWidth>
    const LargeVector<WideNode<kWidth>>& nodes() const {
        return std::get<LargeVector<WideNode<kWidth>>>(nodesByWidth);
    }
    template <int kWidth>
    LargeVector<WideNode<kWidth>>& nodes() {
        return std::get<LargeVector<WideNode<kWidth>>>(nodesByWidth);
    }

    Leaf leaf(LeafReference at) const {
        const float* block = leafBlocks.data() + at;
        const std::uint32_t word = wholeNumberIn(block[kLeafHeader - 1]);
        const auto centre = [&](int k) { return leafCentre(origin[k], unit, block[k]); };
        return {at,
                word < kHasVertices,
                word % kHasVertices,
                block[3],
                {centre(0), centre(1), centre(2)},
                block + kLeafHeader};
    }

    /// The loader's id of a triangle.
    std::uint32_t triangleId(TriangleAt triangle) const {
        const Leaf from = leaf(triangle.leaf);
        return wholeNumberIn(from.offsets[9 * std::size_t(from.triangleCount) + triangle.number]);
    }

    /// The exact corners of a triangle, mesh coordinates.
    std::array<Vector3, 3> corners(TriangleAt triangle) const {
        const Leaf from = leaf(triangle.leaf);
        const std::size_t n = from.triangleCount;
        std::array<Vector3, 3> found;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (from.isExact) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const float offset = from.offsets[(3 * corner + k) * n + triangle.number];
                    found[corner][Eigen::Index(k)] = from.centre[k] + unit * double(offset);
                }
            } else {
                found[corner] = vertices[wholeNumberIn(from.offsets[10 * n + 3 * triangle.number + corner])];
            }
        }
        return found;
    }

    /// All leaves, in the order of their blocks.
    std::vector<LeafReference> leaves() const;
};

/// Floats kept after the last leaf's block, so that a kernel may load whole vectors past its end.
constexpr std::size_t kLeafPadding = 16;

/// Counts what the tree holds. Node 0, which holds only the root's volume, counts like any other.
TreeStatistics statistics(const FlatTree& tree);

/// The most nodes on a way from the root to a leaf; searches may call themselves for each. A build stays well below it.
constexpr int kDeepestTree = 256;

/// Checks a tree from outside: returns nothing when every reference stays within the tree and all nodes and leaves are
/// one tree, so that a search visits each at most once; otherwise the fault in words. All triangle ids must be below
/// meshTriangles and differ.
std::string faultOf(const FlatTree& tree, std::size_t meshTriangles);

}  // namespace clearway
