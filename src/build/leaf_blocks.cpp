// Runs of leaves are written to blocks of their own, in parallel, and then put one after the other.
#include "build/leaf_blocks.h"

#include <algorithm>
#include <cassert>
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

constexpr std::size_t kLeavesInRun = 2048;

/// The blocks of a run of leaves. Numbers of vertices are still those of the leaf order.
struct Run {
    std::vector<float> blocks;
    std::vector<std::size_t> starts;  ///< of each leaf's block
};

class LeafWriter {
  public:
    LeafWriter(const BinaryTree& binary, const LeafOrder& order, const CleanMesh& mesh, const FlatTree& tree)
        : binary_(binary), order_(order), mesh_(mesh), tree_(tree) {}

    void add(const BinaryNode& leaf, Run& run) {
        const std::uint32_t count = leaf.triangleCount;
        const TriangleIndices* triangles = order_.triangles().data() + leaf.firstTriangle;
        corners_.clear();
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const std::uint32_t vertex : triangles[i]) corners_.push_back(order_.vertex(vertex));
        }
        const LeafCentre centre = chooseLeafCentre(corners_, tree_.origin, tree_.unit);
        const std::size_t start = run.blocks.size();
        run.starts.push_back(start);
        run.blocks.resize(start + leafBlockSize(count, centre.isExact));
        float* next = run.blocks.data() + start;
        next = std::copy(centre.stored.begin(), centre.stored.end(), next);
        *next++ = roundedUp(largestDistance(centre.point) / tree_.unit);
        storeWholeNumber(count + (centre.isExact ? 0 : kHasVertices), *next++);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (int k = 0; k < 3; ++k) {
                for (std::size_t i = corner; i < corners_.size(); i += 3)
                    *next++ = leafOffset(corners_[i][k], centre.point[k], tree_.unit);
            }
        }
        for (std::uint32_t i = 0; i < count; ++i)
            storeWholeNumber(mesh_.triangleIds[binary_.order[leaf.firstTriangle + i]], *next++);
        if (centre.isExact) return;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const std::uint32_t vertex : triangles[i]) storeWholeNumber(vertex, *next++);
        }
    }

  private:
    double largestDistance(const Vector3& from) const {
        double largest = 0;
        for (const Vector3& corner : corners_) largest = std::max(largest, (corner - from).stableNorm());
        return largest * kLengthRounding;
    }

    const BinaryTree& binary_;
    const LeafOrder& order_;
    const CleanMesh& mesh_;
    const FlatTree& tree_;
    std::vector<Vector3> corners_;
};

/// Gives the vertices of leaves that are not exact the numbers under which the tree keeps them.
void addVertices(const std::vector<LeafReference>& leaves, const LeafOrder& order, FlatTree& tree) {
    FirstUseOrder numberOf(order.vertexCount());
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
    tree.vertices.shrink_to_fit();
}

}  // namespace

std::vector<LeafReference> addLeafBlocks(const std::vector<LeafPlace>& leaves, const BinaryTree& binary,
                                         const LeafOrder& order, const CleanMesh& mesh, FlatTree& tree) {
    std::vector<Run> runs((leaves.size() + kLeavesInRun - 1) / kLeavesInRun);
    forEachInParallel(runs.size(), [&](std::size_t i) {
        LeafWriter writer(binary, order, mesh, tree);
        const std::size_t last = std::min(leaves.size(), (i + 1) * kLeavesInRun);
        for (std::size_t leaf = i * kLeavesInRun; leaf < last; ++leaf)
            writer.add(binary.nodes[std::size_t(leaves[leaf].binaryNode)], runs[i]);
    });
    std::vector<LeafReference> references;
    references.reserve(leaves.size());
    std::size_t total = 0;
    for (const Run& run : runs) total += run.blocks.size();
    if (total >= kLeafBlocksEnd) throw ArgumentError("the mesh has too many triangles for one tree");
    tree.leafBlocks.reserve(total + kLeafPadding);
    for (const Run& run : runs) {
        for (const std::size_t start : run.starts)
            references.push_back(static_cast<LeafReference>(tree.leafBlocks.size() + start));
        tree.leafBlocks.insert(tree.leafBlocks.end(), run.blocks.begin(), run.blocks.end());
    }
    tree.leafBlocks.resize(total + kLeafPadding, 0.0f);
    addVertices(references, order, tree);
    return references;
}

}  // namespace clearway
