// Nodes are rated in batches, so that the principal frames of several are found at once. Parents come before their children, which
// try their frames.
#include "build/rate_nodes.h"

#include <algorithm>
#include <vector>

#include "tree/normalisation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/rate_nodes.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h

#include "build/corner_lanes-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

class NodeRating {
  public:
    NodeRating(BinaryTree& tree, const CleanMesh& mesh)
        : tree_(tree),
          mesh_(mesh),
          inverseUnit_(normalisationOf(mesh.vertices).inverseUnit),
          samples_(kNodes) {}

    void rateAll() {
        std::vector<std::size_t> batch;
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            const BinaryNode& node = tree_.nodes[i];
            if (node.isLeaf()) continue;
            if (node.area != kNotRated) {
                handDown(node);
                continue;
            }
            batch.push_back(i);
            if (batch.size() == kNodes) rate(batch);
        }
        rate(batch);
    }

  private:
    static constexpr std::size_t kNodes = kLaneBlock / 2;  ///< each has two covariances
    static constexpr std::size_t kMostInSample = 128;

    void rate(std::vector<std::size_t>& batch) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            sample(tree_.nodes[batch[i]], samples_[i]);
            SpreadSums sums;
            sums.add(samples_[i]);
            frames_.set(2 * i, sums.ofArea());
            frames_.set(2 * i + 1, sums.ofCorners());
        }
        frames_.solve();
        for (std::size_t i = 0; i < batch.size(); ++i) {
            BinaryNode& node = tree_.nodes[batch[i]];
            const FrameAxes frames[4] = {frames_.axes(2 * i), frames_.axes(2 * i + 1), kModelAxes, node.axes};
            const FrameChoice best = LeastAreaFrame(samples_[i].points(), frames, 4);
            node.area = best.area;
            node.axes = frames[best.frame];
            handDown(node);
        }
        batch.clear();
    }

    void handDown(const BinaryNode& node) {
        for (const std::int32_t child : {node.left, node.right}) {
            if (tree_.nodes[child].area == kNotRated) tree_.nodes[child].axes = node.axes;
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
    std::vector<CornerLanes> samples_;
    PrincipalFrames frames_;
};

void RateNodes(BinaryTree& tree, const CleanMesh& mesh) {
    NodeRating(tree, mesh).rateAll();
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
