// Nodes are rated in batches, so that the principal frames of several are found at once. Parents come before their children, which
// try their frames.
#include "build/rate_nodes.h"

#include <algorithm>
#include <array>
#include <vector>

#include "build/top_down.h"
#include "core/parallel.h"
#include "tree/normalisation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/rate_nodes.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h

#include "build/corner_lanes-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// Rates nodes of one tree, one task after the other.
class NodeRating {
  public:
    NodeRating(BinaryTree& tree, const CleanMesh& mesh, double inverseUnit)
        : tree_(tree), mesh_(mesh), inverseUnit_(inverseUnit) {}

    /// Rates one node, whose parent is rated, and hands its frame down.
    void rateOne(std::size_t node) {
        batch_.assign(1, node);
        if (tree_.nodes[node].area == kNotRated) rateBatch();
        handDown(tree_.nodes[node]);
    }

    /// Rates a node, whose parent is rated, and all below it.
    void rateAll(std::size_t root) {
        std::vector<std::size_t> pending{root};
        while (!pending.empty()) {
            // The nodes pending are never above each other, so that all have their parents' frames.
            batch_.clear();
            while (!pending.empty() && batch_.size() < kNodes) {
                const std::size_t node = pending.back();
                pending.pop_back();
                if (tree_.nodes[node].area == kNotRated) {
                    batch_.push_back(node);
                } else {
                    handDown(tree_.nodes[node], &pending);
                }
            }
            rateBatch();
            for (const std::size_t node : batch_) handDown(tree_.nodes[node], &pending);
        }
    }

  private:
    static constexpr std::size_t kNodes = kLaneBlock / 2;  ///< each has two covariances
    static constexpr std::size_t kMostInSample = 128;

    void rateBatch() {
        for (std::size_t i = 0; i < batch_.size(); ++i) {
            sample(tree_.nodes[batch_[i]], samples_[i]);
            SpreadSums sums;
            sums.add(samples_[i]);
            frames_.set(2 * i, sums.ofArea());
            frames_.set(2 * i + 1, sums.ofCorners());
        }
        frames_.solve();
        for (std::size_t i = 0; i < batch_.size(); ++i) {
            BinaryNode& node = tree_.nodes[batch_[i]];
            const FrameAxes frames[4] = {frames_.axes(2 * i), frames_.axes(2 * i + 1), kModelAxes, node.axes};
            const FrameChoice best = LeastAreaFrame(samples_[i].points(), frames, 4);
            node.area = best.area;
            node.axes = frames[best.frame];
        }
    }

    /// inner: gets the children that are no leaves.
    void handDown(const BinaryNode& node, std::vector<std::size_t>* inner = nullptr) {
        for (const std::int32_t index : {node.left, node.right}) {
            BinaryNode& child = tree_.nodes[std::size_t(index)];
            if (child.area == kNotRated) child.axes = node.axes;
            if (inner != nullptr && !child.isLeaf()) inner->push_back(std::size_t(index));
        }
    }

    void sample(const BinaryNode& node, CornerLanes& corners) const {
        // An odd stride, because many meshes are rows of pairs of triangles.
        const std::size_t count = node.triangleCount;
        const std::size_t stride = count <= kMostInSample ? 1 : (count / kMostInSample) | 1;
        const auto corner = [&](std::size_t i, int k) {
            return mesh_
                .vertices[mesh_.triangles[tree_.order[node.firstTriangle + i * stride]][std::size_t(k)]];
        };
        const Vector3 origin = corner(0, 0);
        corners.gatherExactly((count + stride - 1) / stride, [&](std::size_t i, int k) -> Vector3 {
            return (corner(i, k) - origin) * inverseUnit_;
        });
    }

    BinaryTree& tree_;
    const CleanMesh& mesh_;
    const double inverseUnit_;
    std::vector<std::size_t> batch_;
    std::array<CornerLanes, kNodes> samples_;
    PrincipalFrames frames_;
};

void RateSubtree(BinaryTree& tree, const CleanMesh& mesh, double inverseUnit, std::size_t root) {
    const BinaryNode& node = tree.nodes[root];
    if (node.isLeaf()) return;
    {
        NodeRating rating(tree, mesh, inverseUnit);
        if (node.triangleCount <= kTaskTriangles) {
            rating.rateAll(root);
            return;
        }
        rating.rateOne(root);
    }
    invokeBoth([&] { RateSubtree(tree, mesh, inverseUnit, std::size_t(node.left)); },
               [&] { RateSubtree(tree, mesh, inverseUnit, std::size_t(node.right)); });
}

void RateNodes(BinaryTree& tree, const CleanMesh& mesh) {
    RateSubtree(tree, mesh, normalisationOf(mesh.vertices).inverseUnit, 0);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(RateNodes);

void rateNodes(BinaryTree& tree, const CleanMesh& mesh) {
    const auto isRated = [](const BinaryNode& node) { return node.isLeaf() || node.area != kNotRated; };
    if (!std::all_of(tree.nodes.begin(), tree.nodes.end(), isRated))
        HWY_DYNAMIC_DISPATCH(RateNodes)(tree, mesh);
}

}  // namespace clearway

#endif  // HWY_ONCE
