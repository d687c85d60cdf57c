// Counts and checks of flat trees.
#include "tree/flat_tree.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "clearway/build_options.h"
#include "clearway/errors.h"
#include "core/text.h"

namespace clearway {
namespace {

template <class Values>
std::size_t bytesOf(const Values& values) {
    return values.size() * sizeof(values[0]);
}

template <int kWidth>
void countNodes(const LargeVector<WideNode<kWidth>>& nodes, TreeStatistics& counted) {
    std::vector<int> depths(nodes.size(), 1);  // children come after their parent
    std::size_t children = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        counted.depth = std::max(counted.depth, depths[i]);
        for (const std::int32_t child : nodes[i].child) {
            if (child == kNoChild) continue;
            ++children;
            if (child >= 0) depths[child] = depths[i] + 1;
        }
    }
    counted.nodes = nodes.size();
    counted.meanChildren = static_cast<double>(children) / static_cast<double>(nodes.size());
    counted.bytes += bytesOf(nodes);
}

/// Whether the floats of a lane's volume are finite.
template <int kWidth>
bool isFinite(const WideNode<kWidth>& node, int lane) {
    constexpr std::size_t kFloats = offsetof(WideNode<kWidth>, child) / sizeof(float);
    const float* const floats = node.centre[0];
    for (std::size_t i = std::size_t(lane); i < kFloats; i += kWidth) {
        if (!std::isfinite(floats[i])) return false;
    }
    return true;
}

const char* const kNotFinite = "its coordinates are not finite";

/// Above the ids that storeWholeNumber can store.
constexpr std::size_t kTriangleIdsEnd = std::size_t(1) << 30;

/// Children must come after their parent, so that every path downwards ends, and have only one parent: shared children would
/// make a search exponential. isLeaf: by place in the tree's leafBlocks, whether a leaf's block begins there.
template <int kWidth>
std::string faultOfNodes(const LargeVector<WideNode<kWidth>>& nodes, const std::vector<bool>& isLeaf) {
    std::vector<bool> isLeafReached(isLeaf.size());
    std::vector<int> depths(nodes.size());  // 0: no earlier node has this child
    if (!nodes.empty()) depths[0] = 1;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const auto fault = [&](const std::string& text) { return fmt::format("node {}{}", n, text); };
        if (depths[n] == 0) return fault(" has no parent");
        if (depths[n] > kDeepestTree) return fault(fmt::format(" is below {} others", kDeepestTree));
        const auto isUsed = [](std::int32_t child) { return child != kNoChild; };
        const std::int32_t* const first = nodes[n].child;
        const auto used = int(std::find_if_not(first, first + kWidth, isUsed) - first);
        if (used == 0 || (n == 0 && used > 1) || std::any_of(first + used, first + kWidth, isUsed))
            return fault(" has an impossible number of children");
        for (int lane = 0; lane < used; ++lane) {
            if (!isFinite(nodes[n], lane)) return fault(" has a volume that is not finite");
            const bool toLeaf = first[lane] < 0;
            const auto child = std::size_t(toLeaf ? ~first[lane] : first[lane]);
            if (toLeaf ? child >= isLeaf.size() || !isLeaf[child] : child <= n || child >= nodes.size())
                return fault(" refers to what is not there");
            if (toLeaf ? isLeafReached[child] : depths[child] > 0) return fault(" shares a child");
            if (toLeaf) {
                isLeafReached[child] = true;
            } else {
                depths[child] = depths[n] + 1;
            }
        }
    }
    const auto leftOut = std::mismatch(isLeaf.begin(), isLeaf.end(), isLeafReached.begin()).first;
    if (leftOut == isLeaf.end()) return "";
    return fmt::format("the leaf at {} has no parent", leftOut - isLeaf.begin());
}

template <int... kWidths>
bool isNodeWidth(int nodeWidth, std::integer_sequence<int, kWidths...>) {
    return ((nodeWidth == kWidths) || ...);
}

std::size_t endOfLeaves(const FlatTree& tree) {
    return tree.leafBlocks.size() < kLeafPadding ? 0 : tree.leafBlocks.size() - kLeafPadding;
}

bool areFinite(const float* values, std::size_t count) {
    return std::all_of(values, values + count, [](float value) { return std::isfinite(value); });
}

/// Checks the blocks of the leaves from first to last, and marks where each begins.
std::string faultOfLeaves(const FlatTree& tree, std::size_t meshTriangles, std::vector<bool>& isLeaf) {
    const std::size_t end = endOfLeaves(tree);
    isLeaf.assign(end, false);
    std::vector<bool> isHeld(std::min(meshTriangles, kTriangleIdsEnd));
    for (std::size_t at = 0; at < end;) {
        const float* block = tree.leafBlocks.data() + at;
        if (end - at < kLeafHeader) return "its last leaf is cut off";
        const std::uint32_t word = wholeNumberIn(block[kLeafHeader - 1]), count = word % kHasVertices;
        const bool isExact = word < kHasVertices;
        if (word >= 2 * kHasVertices || count < 1 || count > std::uint32_t(kLargestLeafSize)) {
            return "its leaves hold an impossible number of triangles";
        }
        const std::size_t size = leafBlockSize(count, isExact);
        if (end - at < size) return "its last leaf is cut off";
        const float* offsets = block + kLeafHeader;
        const float* ids = offsets + 9 * std::size_t(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t id = wholeNumberIn(ids[i]);
            if (id >= isHeld.size()) return "its triangle ids are out of range";
            if (isHeld[id]) return fmt::format("its leaves hold triangle {} twice", id);
            isHeld[id] = true;
        }
        for (std::size_t i = count; i < (isExact ? 1 : 4) * std::size_t(count); ++i) {
            if (wholeNumberIn(ids[i]) >= tree.vertices.size()) {
                return "its triangles refer to vertices that are not there";
            }
        }
        if (!areFinite(block, kLeafHeader - 1) || !areFinite(offsets, 9 * std::size_t(count))) {
            return kNotFinite;
        }
        isLeaf[at] = true;
        at += size;
    }
    return "";
}

}  // namespace

void refuseNodeWidth(int nodeWidth) {
    std::vector<std::string> known;
    for (const int width : nodeWidths()) known.push_back(std::to_string(width));
    throw ArgumentError(fmt::format("nodeWidth is {}, expected one of {}", nodeWidth, joined(known)));
}

TreeStatistics statistics(const FlatTree& tree) {
    TreeStatistics counted;
    withNodeWidth(tree.nodeWidth, [&](auto width) { countNodes(tree.nodes<width>(), counted); });
    for (const LeafReference at : tree.leaves()) {
        const std::uint32_t count = tree.leaf(at).triangleCount;
        if (counted.leavesBySize.size() <= count) counted.leavesBySize.resize(count + 1);
        ++counted.leavesBySize[count];
        ++counted.leaves;
    }
    counted.bytes += sizeof(FlatTree) + bytesOf(tree.leafBlocks) + bytesOf(tree.vertices);
    return counted;
}

std::vector<LeafReference> FlatTree::leaves() const {
    std::vector<LeafReference> found;
    for (std::size_t at = 0, end = endOfLeaves(*this); at < end;) {
        found.push_back(static_cast<LeafReference>(at));
        const Leaf next = leaf(found.back());
        at += leafBlockSize(next.triangleCount, next.isExact);
    }
    return found;
}

std::string faultOf(const FlatTree& tree, std::size_t meshTriangles) {
    if (!isNodeWidth(tree.nodeWidth, NodeWidths())) return "its node width is unknown";
    std::vector<bool> isLeaf;
    std::string fault = faultOfLeaves(tree, meshTriangles, isLeaf);
    if (!fault.empty()) return fault;
    const bool hasNodes =
        withNodeWidth(tree.nodeWidth, [&](auto width) { return !tree.nodes<width>().empty(); });
    std::size_t arrays = 0;
    std::apply([&](const auto&... nodes) { ((arrays += !nodes.empty()), ...); }, tree.nodesByWidth);
    if (!hasNodes || arrays > 1) return fmt::format("its nodes are not all {} wide", tree.nodeWidth);
    fault =
        withNodeWidth(tree.nodeWidth, [&](auto width) { return faultOfNodes(tree.nodes<width>(), isLeaf); });
    if (!fault.empty()) return fault;
    const auto isFinite = [](const Vector3& vertex) { return vertex.allFinite(); };
    if (!std::all_of(tree.vertices.begin(), tree.vertices.end(), isFinite) || !tree.origin.allFinite() ||
        !std::isfinite(tree.radius) || !std::isfinite(tree.radiusAboutMeshOrigin) ||
        tree.unitExponent < -1000 || tree.unitExponent > 1000 || !tree.box.min().allFinite() ||
        !tree.box.max().allFinite()) {
        return kNotFinite;
    }
    return "";
}

}  // namespace clearway
