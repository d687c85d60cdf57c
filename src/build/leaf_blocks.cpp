// How large a leaf's block is shows only when its centre is chosen: blocks are written elsewhere, in parallel, and then joined.
#include "build/leaf_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "build/leaf_centre.h"
#include "clearway/errors.h"
#include "core/parallel.h"
#include "mesh/renumber.h"
#include "tree/rss.h"

namespace clearway {

namespace {

/// References to leaves stay below this, so that no node takes ~reference for kNoChild.
constexpr std::size_t kLeafBlocksEnd = std::numeric_limits<std::int32_t>::max();

/// So many parts of so many leaves are written in parallel and then put one after the other.
constexpr std::size_t kParts = 8, kLeavesInPart = 512;

class LeafWriter {
  public:
    LeafWriter(const BinaryTree& binary, const LeafOrder& order, const CleanMesh& mesh, const FlatTree& tree)
        : binary_(binary), order_(order), mesh_(mesh), tree_(tree), inverseUnit_(1 / tree.unit) {}

    std::size_t mostFloatsOf(const LeafPlace& place) const {
        return leafBlockSize(leafAt(place).triangleCount, false);
    }

    /// Writes the leaf's block from `next` on, and returns its end. Numbers of vertices are still those of the leaf order.
    float* write(const LeafPlace& place, float* next) const {
        const BinaryNode& leaf = leafAt(place);
        const std::uint32_t count = leaf.triangleCount;
        const TriangleIndices* triangles = order_.triangles().data() + leaf.firstTriangle;
        LeafCorners corners;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const std::uint32_t vertex : triangles[i]) corners.add(order_.vertex(vertex));
        }
        const LeafCentre centre = chooseLeafCentre(corners, tree_.origin, tree_.unit);
        next = std::copy(centre.stored.begin(), centre.stored.end(), next);
        *next++ = roundedUp(largestDistance(corners, centre.point) * inverseUnit_);
        storeWholeNumber(count + (centre.isExact ? 0 : kHasVertices), *next++);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (int k = 0; k < 3; ++k) {
                for (std::size_t i = corner; i < corners.count; i += 3)
                    *next++ = leafOffset(corners.at[k][i], centre.point[k], inverseUnit_);
            }
        }
        for (std::uint32_t i = 0; i < count; ++i)
            storeWholeNumber(mesh_.triangleIds[binary_.order[leaf.firstTriangle + i]], *next++);
        if (centre.isExact) return next;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const std::uint32_t vertex : triangles[i]) storeWholeNumber(vertex, *next++);
        }
        return next;
    }

  private:
    const BinaryNode& leafAt(const LeafPlace& place) const {
        return binary_.nodes[std::size_t(place.binaryNode)];
    }

    /// An upper bound, mesh units.
    static double largestDistance(const LeafCorners& corners, const Vector3& from) {
        double largestSquared = 0;
        for (std::size_t i = 0; i < corners.count; ++i)
            largestSquared = std::max(largestSquared, (corners.corner(i) - from).squaredNorm());
        if (areSquaresSafe(largestSquared)) return std::sqrt(largestSquared) * kLengthRounding;
        double largest = 0;
        for (std::size_t i = 0; i < corners.count; ++i)
            largest = std::max(largest, (corners.corner(i) - from).stableNorm());
        return largest * kLengthRounding;
    }

    const BinaryTree& binary_;
    const LeafOrder& order_;
    const CleanMesh& mesh_;
    const FlatTree& tree_;
    const double inverseUnit_;
};

/// The blocks of some leaves one after the other.
struct Blocks {
    ScratchArray<float> floats;
    std::vector<std::size_t> ends;

    void write(const LeafWriter& writer, const LeafPlace* first, const LeafPlace* last) {
        std::size_t most = 0;
        for (const LeafPlace* leaf = first; leaf != last; ++leaf) most += writer.mostFloatsOf(*leaf);
        float* const begin = floats.withRoomFor(most);
        float* next = begin;
        ends.clear();
        for (const LeafPlace* leaf = first; leaf != last; ++leaf) {
            next = writer.write(*leaf, next);
            ends.push_back(std::size_t(next - begin));
        }
    }
};

/// Gives the vertices of leaves that are not exact the numbers under which the tree keeps them.
void addVertices(const std::vector<LeafReference>& leaves, const LeafOrder& order, FlatTree& tree) {
    const auto isExact = [&](LeafReference at) { return tree.leaf(at).isExact; };
    if (std::all_of(leaves.begin(), leaves.end(), isExact)) return;
    FirstUseOrder numberOf(order.vertexCount());
    tree.vertices.reserve(order.vertexCount());
    for (const LeafReference at : leaves) {
        const Leaf leaf = tree.leaf(at);
        if (leaf.isExact) continue;
        float* numbers = tree.leafBlocks.data() + at + leafBlockSize(leaf.triangleCount, true);
        for (std::size_t i = 0; i < 3 * std::size_t(leaf.triangleCount); ++i) {
            const std::uint32_t number = numberOf(wholeNumberIn(numbers[i]), [&](std::uint32_t used) {
                tree.vertices.push_back(order.vertex(used));
            });
            storeWholeNumber(number, numbers[i]);
        }
    }
}

}  // namespace

std::vector<LeafReference> addLeafBlocks(const std::vector<LeafPlace>& leaves, const BinaryTree& binary,
                                         const LeafOrder& order, const CleanMesh& mesh, FlatTree& tree) {
    const LeafWriter writer(binary, order, mesh, tree);
    std::vector<LeafReference> references;
    references.reserve(leaves.size());
    std::size_t most = kLeafPadding;
    for (const LeafPlace& leaf : leaves) most += writer.mostFloatsOf(leaf);
    tree.leafBlocks.reserve(most);
    std::vector<Blocks> blocks(kParts);
    for (std::size_t first = 0; first < leaves.size(); first += kParts * kLeavesInPart) {
        const auto partEnd = [&](std::size_t part) {
            return leaves.data() + std::min(leaves.size(), first + part * kLeavesInPart);
        };
        forEachInParallel(
            kParts, [&](std::size_t part) { blocks[part].write(writer, partEnd(part), partEnd(part + 1)); });
        for (const Blocks& part : blocks) {
            const std::size_t start = tree.leafBlocks.size();
            if (part.ends.empty()) break;
            if (start + part.ends.back() >= kLeafBlocksEnd)
                throw ArgumentError("the mesh has too many triangles for one tree");
            references.push_back(static_cast<LeafReference>(start));
            for (std::size_t i = 0; i + 1 < part.ends.size(); ++i)
                references.push_back(static_cast<LeafReference>(start + part.ends[i]));
            tree.leafBlocks.insert(tree.leafBlocks.end(), part.floats.data(),
                                   part.floats.data() + part.ends.back());
        }
    }
    tree.leafBlocks.resize(tree.leafBlocks.size() + kLeafPadding, 0.0f);
    addVertices(references, order, tree);
    return references;
}

}  // namespace clearway
