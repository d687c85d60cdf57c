// Counts and checks of flat trees.
#include "tree/flat_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "clearway/build_options.h"
#include "core/text.h"

namespace clearway {
namespace {

template <class Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.size() * sizeof(Value);
}

template <int kWidth>
void countNodes(const std::vector<WideNode<kWidth>>& nodes, TreeStatistics& counted) {
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

/// Children must come after their parent, so that every path downwards ends.
/// isLeaf: by place in the tree's leafBlocks, whether a leaf's block begins there.
template <int kWidth>
bool areNodesSound(const std::vector<WideNode<kWidth>>& nodes, const std::vector<bool>& isLeaf) {
    if (nodes.empty()) return false;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        bool ended = false;
        for (int lane = 0; lane < kWidth; ++lane) {
            const std::int32_t child = nodes[n].child[lane];
            if (child == kNoChild) {
                ended = true;
                continue;
            }
            if (ended || (n == 0 && lane > 0)) return false;
            const bool sound = child < 0 ? std::size_t(~child) < isLeaf.size() && isLeaf[std::size_t(~child)]
                                         : std::size_t(child) > n && std::size_t(child) < nodes.size();
            if (!sound) return false;
        }
        if (nodes[n].child[0] == kNoChild) return false;
    }
    return true;
}

/// Whether every node but the first, and every leaf, is the child of exactly one node: the search of a tree with shared children
/// would visit them once for each way that leads there. The nodes must be sound.
template <int kWidth>
bool isTree(const std::vector<WideNode<kWidth>>& nodes, const std::vector<bool>& isLeaf) {
    std::vector<bool> isNodeFree(nodes.size(), true), isLeafFree = isLeaf;
    std::size_t left = nodes.size() - 1 + std::size_t(std::count(isLeaf.begin(), isLeaf.end(), true));
    for (const WideNode<kWidth>& node : nodes) {
        for (const std::int32_t child : node.child) {
            if (child == kNoChild) continue;
            std::vector<bool>& isFree = child < 0 ? isLeafFree : isNodeFree;
            const auto place = std::size_t(child < 0 ? ~child : child);
            if (!isFree[place]) return false;
            isFree[place] = false;
            --left;
        }
    }
    return left == 0;
}

template <int... kWidths>
bool isNodeWidth(int nodeWidth, std::integer_sequence<int, kWidths...>) {
    return ((nodeWidth == kWidths) || ...);
}

template <int... kWidths>
bool areNodesSound(const FlatTree& tree, const std::vector<bool>& isLeaf,
                   std::integer_sequence<int, kWidths...>) {
    return ((tree.nodeWidth == kWidths ? areNodesSound(tree.nodes<kWidths>(), isLeaf)
                                       : tree.nodes<kWidths>().empty()) &&
            ...);
}

std::size_t endOfLeaves(const FlatTree& tree) {
    return tree.leafBlocks.size() < kLeafPadding ? 0 : tree.leafBlocks.size() - kLeafPadding;
}

bool areFinite(const float* values, std::size_t count) {
    return std::all_of(values, values + count, [](float value) { return std::isfinite(value); });
}

const char* const kNotFinite = "its coordinates are not finite";

/// Checks the blocks of the leaves from first to last, and marks where each begins.
const char* faultOfLeaves(const FlatTree& tree, std::size_t meshTriangles, std::vector<bool>& isLeaf) {
    const std::size_t end = endOfLeaves(tree);
    isLeaf.assign(end, false);
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
            if (wholeNumberIn(ids[i]) >= meshTriangles) return "its triangle ids are out of range";
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
    return nullptr;
}

}  // namespace

void refuseNodeWidth(int nodeWidth) {
    std::vector<std::string> known;
    for (const int width : nodeWidths()) known.push_back(std::to_string(width));
    throw std::invalid_argument("nodeWidth is " + std::to_string(nodeWidth) + ", expected one of " +
                                joined(known));
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

const char* faultOf(const FlatTree& tree, std::size_t meshTriangles) {
    if (!isNodeWidth(tree.nodeWidth, NodeWidths())) return "its node width is unknown";
    std::vector<bool> isLeaf;
    if (const char* fault = faultOfLeaves(tree, meshTriangles, isLeaf)) return fault;
    if (!areNodesSound(tree, isLeaf, NodeWidths())) return "its nodes refer to what is not there";
    bool isOneTree = false;
    withNodeWidth(tree.nodeWidth, [&](auto width) { isOneTree = isTree(tree.nodes<width>(), isLeaf); });
    if (!isOneTree) return "its nodes share children, or leave out some";
    const auto isFinite = [](const Vector3& vertex) { return vertex.allFinite(); };
    if (!std::all_of(tree.vertices.begin(), tree.vertices.end(), isFinite) || !tree.origin.allFinite() ||
        !std::isfinite(tree.radius) || std::abs(tree.unitExponent) > 1000 || !tree.box.min().allFinite() ||
        !tree.box.max().allFinite()) {
        return kNotFinite;
    }
    return nullptr;
}

}  // namespace clearway
