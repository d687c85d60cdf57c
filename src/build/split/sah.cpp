// The surface-area heuristic: each node is cut between two bins of triangles, along an axis of a frame in which its triangles lie
// well. Large nodes try three frames with a sample of their triangles; small ones, which are most, take the one of two frames in
// which a volume around them has the least area. That area is kept for the collapse, and the frame for the nodes below.
#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

#include "build/general_splits.h"
#include "build/scratch_array.h"
#include "build/top_down.h"
#include "build/triangle_corners.h"
#include "core/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/split/sah.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h

#include "build/split/bins-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// Nodes of up to this many triangles are small.
constexpr std::size_t kMostInSmall = 64;

/// A sample of a large node's triangles chooses the frame: this share of them, within these numbers. The stride is odd, because
/// many meshes are rows of pairs of triangles, so that an even stride would see half of each.
constexpr std::size_t kSampleShare = 8, kLeastSample = 128, kMostSample = 16384;
constexpr std::size_t kMostForMoments = 65536;
constexpr std::size_t kMostForArea = 256;

inline std::size_t OddStride(std::size_t count, std::size_t wanted) {
    return count <= wanted ? 1 : (count / wanted) | 1;
}

/// Above this many triangles, the triangles of one node are shared out among threads, in this many parts.
constexpr std::size_t kLeastToShare = 32768, kShares = 16;

/// Float corners blur nodes whose spread is below this share of their distance from the origin: their corners are taken from the
/// mesh, relative to one of them.
constexpr float kLeastSpread = 0x1p-12f;

/// Splits nodes for buildInTasks.
class SahSplit {
  public:
    SahSplit(const CleanMesh& mesh, const Normalisation& normalised, TriangleCorners& triangles,
             std::vector<std::uint32_t>& order, std::size_t largestGroup)
        : mesh_(mesh),
          normalised_(normalised),
          triangles_(triangles),
          order_(order),
          largestGroup_(largestGroup),
          small_(kLaneBlock),
          bins_(std::make_unique<Bins>()) {}

    std::size_t leftCountOf(BinaryNode& node, int depth) {
        const std::size_t left = cut(node);
        return checked(node, depth, left);
    }

    void splitAllBelow(LargeVector<BinaryNode>& nodes, int rootDepth) {
        nodes.reserve(nodes.front().triangleCount + std::size_t(1));
        push({0, rootDepth}, nodes);
        while (!waitingLarge_.empty() || !waitingSmall_.empty()) {
            if (waitingSmall_.size() >= kLaneBlock || waitingLarge_.empty()) {
                splitSmall(nodes);
            } else {
                const Pending next = waitingLarge_.back();
                waitingLarge_.pop_back();
                divide(nodes, next, cutLarge(nodes[next.node]));
            }
        }
        for (const BinaryNode& node : nodes) {
            if (node.isLeaf()) noteOrder(node);
        }
    }

  private:
    struct Pending {
        std::size_t node;
        int depth;
    };

    std::size_t cut(BinaryNode& node) {
        if (node.triangleCount > kMostInSmall) return cutLarge(node);
        frames_.set(0, gatherSmall(node, small_[0]));
        frames_.solve();
        return cutSmall(node, small_[0], frames_.axes(0));
    }

    void push(const Pending& next, const LargeVector<BinaryNode>& nodes) {
        const std::size_t count = nodes[next.node].triangleCount;
        if (count <= largestGroup_) return;
        (count <= kMostInSmall ? waitingSmall_ : waitingLarge_).push_back(next);
    }

    std::size_t checked(const BinaryNode& node, int depth, std::size_t left) {
        if (depth < kDeepestSplit && left > 0) return left;
        noteOrder(node);
        std::uint32_t* first = order_.data() + node.firstTriangle;
        left = splitInHalves(mesh_, {first, first + node.triangleCount});
        for (std::size_t i = 0; i < node.triangleCount; ++i)
            triangles_.set(node.firstTriangle + i, first[i], mesh_, normalised_);
        return left;
    }

    void noteOrder(const BinaryNode& node) {
        const std::size_t first = node.firstTriangle;
        for (std::size_t i = first; i < first + node.triangleCount; ++i) order_[i] = triangles_.triangle(i);
    }

    void divide(LargeVector<BinaryNode>& nodes, const Pending& parent, std::size_t left) {
        left = checked(nodes[parent.node], parent.depth, left);
        const std::size_t child = addChildren(nodes, parent.node, left);
        push({child + 1, parent.depth + 1}, nodes);
        push({child, parent.depth + 1}, nodes);
    }

    /// Splits as many small nodes as there are lanes for their covariances.
    void splitSmall(LargeVector<BinaryNode>& nodes) {
        const std::size_t count = std::min(waitingSmall_.size(), kLaneBlock);
        const std::size_t first = waitingSmall_.size() - count;
        batch_.assign(waitingSmall_.rbegin(), waitingSmall_.rbegin() + std::ptrdiff_t(count));
        waitingSmall_.resize(first);
        for (std::size_t i = 0; i < count; ++i) {
            frames_.set(i, gatherSmall(nodes[batch_[i].node], small_[i]));
        }
        frames_.solve();
        for (std::size_t i = 0; i < count; ++i)
            divide(nodes, batch_[i], cutSmall(nodes[batch_[i].node], small_[i], frames_.axes(i)));
    }

    /// Gathers all corners of a node and returns the covariance of its area.
    Covariance gatherSmall(const BinaryNode& node, CornerLanes& corners) const {
        gather(node, 0, node.triangleCount, 1, corners);
        SpreadSums sums;
        sums.add(corners);
        if (!isBlurred(node, sums)) return sums.ofArea();
        gatherFromMesh(node, corners);
        SpreadSums exact;
        exact.add(corners);
        return exact.ofArea();
    }

    const float* originOf(const BinaryNode& node) const {
        return triangles_.corner[0][node.firstTriangle].at;
    }

    void gather(const BinaryNode& node, std::size_t from, std::size_t count, std::size_t stride,
                CornerLanes& corners) const {
        corners.gather(triangles_, node.firstTriangle + from, count, stride, originOf(node));
    }

    void gatherFromMesh(const BinaryNode& node, CornerLanes& corners) const {
        const auto corner = [&](std::size_t i, int k) {
            const TriangleIndices& triangle = mesh_.triangles[triangles_.triangle(node.firstTriangle + i)];
            return mesh_.vertices[triangle[std::size_t(k)]];
        };
        const Vector3 origin = corner(0, 0);
        corners.gatherExactly(node.triangleCount, [&](std::size_t i, int k) -> Vector3 {
            return (corner(i, k) - origin) * normalised_.inverseUnit;
        });
    }

    bool isBlurred(const BinaryNode& node, const SpreadSums& sums) const {
        const float* at = originOf(node);
        const float distanceSquared = at[0] * at[0] + at[1] * at[1] + at[2] * at[2];
        return !(sums.cornerVariance() > kLeastSpread * kLeastSpread * distanceSquared);
    }

    std::size_t cutSmall(BinaryNode& node, const CornerLanes& corners, const FrameAxes& ownFrame) {
        const FrameAxes frames[2] = {ownFrame, node.axes};
        const FrameChoice best = LeastAreaFrame(corners.points(), frames, 2);
        node.area = best.area;
        node.axes = frames[best.frame];
        const std::size_t count = node.triangleCount;
        binsOf_.withRoomFor(count);
        bins_->clear(binsFor(count), boxes_.project(corners, node.axes));
        bins_->add(boxes_, count, binsOf_.data());
        return partition(node, bins_->cheapestPlane());
    }

    /// Small nodes need few bins; clearing and sweeping empty bins would be most of the work.
    static int binsFor(std::size_t triangles) {
        return static_cast<int>(std::min<std::size_t>(Bins::kMost, triangles + 4));
    }

    std::size_t cutLarge(BinaryNode& node) {
        const std::size_t count = node.triangleCount;
        SpreadSums sums;
        const std::size_t stride = OddStride(count, kMostForMoments);
        for (std::size_t first = 0; first < count; first += kBlock * stride) {
            gather(node, first, std::min(kBlock, (count - first + stride - 1) / stride), stride, sample_);
            sums.add(sample_);
        }
        frames_.set(0, sums.ofArea());
        frames_.set(1, sums.ofCorners());
        frames_.solve();
        const FrameAxes frames[4] = {frames_.axes(0), kModelAxes, frames_.axes(1), node.axes};

        const std::size_t areaStride = OddStride(count, kMostForArea);
        gather(node, 0, (count + areaStride - 1) / areaStride, areaStride, sample_);
        const FrameChoice best = LeastAreaFrame(sample_.points(), frames, 4);
        node.area = best.area;
        node.axes = frames[best.frame];

        const std::size_t sampleStride =
            OddStride(count, std::clamp(count / kSampleShare, kLeastSample, kMostSample));
        gather(node, 0, (count + sampleStride - 1) / sampleStride, sampleStride, sample_);
        binsOf_.withRoomFor(count);
        BinnedPlane cheapest;
        CentreRange range;
        int frame = 0;
        for (int f = 0; f < 3; ++f) {
            const CentreRange rangeInFrame = boxes_.project(sample_, frames[f]);
            bins_->clear(binsFor(sample_.count()), rangeInFrame);
            bins_->add(boxes_, sample_.count(), binsOf_.data());
            const BinnedPlane plane = bins_->cheapestPlane();
            if (!(plane.cost < cheapest.cost)) continue;
            cheapest = plane;
            range = rangeInFrame;
            frame = f;
        }
        if (cheapest.axis < 0) return 0;
        binAll(node, frames[frame], range);
        return partition(node, bins_->cheapestPlane());
    }

    /// Calls work(first, last) for up to kShares parts of a large node, in parallel.
    template <class Work>
    static void share(std::size_t count, const Work& work) {
        forEachRun(count, (count + kShares - 1) / kShares, work);
    }

    /// Bins all triangles of a node in the frame that the sample chose.
    void binAll(const BinaryNode& node, const FrameAxes& frame, const CentreRange& range) {
        bins_->clear(Bins::kMost, range);
        if (node.triangleCount <= kLeastToShare) {
            bin(node, 0, node.triangleCount, frame, sample_, boxes_, *bins_);
            return;
        }
        std::mutex adding;
        share(node.triangleCount, [&](std::size_t first, std::size_t last) {
            CornerLanes corners;
            FrameBoxes boxes;
            const auto bins = std::make_unique<Bins>();
            bins->clear(Bins::kMost, range);
            bin(node, first, last, frame, corners, boxes, *bins);
            const std::lock_guard<std::mutex> lock(adding);
            bins_->add(*bins);  // minima and counts: any order gives the same
        });
    }

    /// Adds triangles of a node to bins. corners, boxes: scratch.
    void bin(const BinaryNode& node, std::size_t first, std::size_t last, const FrameAxes& frame,
             CornerLanes& corners, FrameBoxes& boxes, Bins& bins) {
        for (; first < last; first += kBlock) {
            const std::size_t count = std::min(kBlock, last - first);
            gather(node, first, count, 1, corners);
            boxes.project(corners, frame);
            bins.add(boxes, count, binsOf_.data() + first);
        }
    }

    /// Keeps the order of the triangles on both sides. Returns 0 if all are on one side.
    std::size_t partition(const BinaryNode& node, const BinnedPlane& plane) {
        if (plane.axis < 0) return 0;
        const std::size_t count = node.triangleCount;
        const BinsOfTriangle* binsOf = binsOf_.data();
        const auto isLeft = [&](std::size_t i) -> std::size_t {
            return binsOf[i][std::size_t(plane.axis)] <= plane.lastLeft;
        };
        if (count > kLeastToShare) return partitionInParts(node, isLeft);
        std::size_t left = 0;
        Corner* right = right_.withRoomFor(count);
        for (ScratchArray<Corner>& corners : triangles_.corner) {
            Corner* run = corners.data() + node.firstTriangle;
            left = 0;
            for (std::size_t i = 0; i < count; ++i) {
                // Without branches: each corner is copied to both sides.
                const Corner corner = run[i];
                run[left] = corner;
                right[i - left] = corner;
                left += isLeft(i);
            }
            std::copy(right, right + (count - left), run + left);
        }
        return left == count ? 0 : left;
    }

    /// The parts count their triangles to the left first, so that each knows where its triangles go.
    template <class IsLeft>
    std::size_t partitionInParts(const BinaryNode& node, const IsLeft& isLeft) {
        const std::size_t count = node.triangleCount, size = (count + kShares - 1) / kShares;
        std::array<std::size_t, kShares + 1> leftBefore{};
        share(count, [&](std::size_t first, std::size_t last) {
            std::size_t left = 0;
            for (std::size_t i = first; i < last; ++i) left += isLeft(i);
            leftBefore[first / size + 1] = left;
        });
        std::partial_sum(leftBefore.begin(), leftBefore.end(), leftBefore.begin());
        const std::size_t total = leftBefore.back();
        Corner* sorted = right_.withRoomFor(count);
        for (ScratchArray<Corner>& corners : triangles_.corner) {
            Corner* run = corners.data() + node.firstTriangle;
            share(count, [&](std::size_t first, std::size_t last) {
                std::size_t left = leftBefore[first / size], right = total + first - left;
                for (std::size_t i = first; i < last; ++i) sorted[isLeft(i) ? left++ : right++] = run[i];
            });
            share(count, [&](std::size_t first, std::size_t last) {
                std::copy(sorted + first, sorted + last, run + first);
            });
        }
        return total == count ? 0 : total;
    }

    static constexpr std::size_t kBlock = 1024;

    const CleanMesh& mesh_;
    const Normalisation& normalised_;
    TriangleCorners& triangles_;
    std::vector<std::uint32_t>& order_;
    const std::size_t largestGroup_;

    std::vector<Pending> waitingLarge_, waitingSmall_, batch_;
    std::vector<CornerLanes> small_;  ///< of the batch
    PrincipalFrames frames_;
    CornerLanes sample_;
    FrameBoxes boxes_;
    std::unique_ptr<Bins> bins_;
    ScratchArray<BinsOfTriangle> binsOf_;  ///< by triangle of the node
    ScratchArray<Corner> right_;
};

BinaryTree SplitBySah(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup) {
    const Normalisation normalised = normalisationOf(mesh.vertices);
    TriangleCorners corners(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) corners.set(i, triangles[i], mesh, normalised);
    BinaryTree tree;
    tree.order = std::move(triangles);
    buildInTasks(tree, largestGroup,
                 [&] { return SahSplit(mesh, normalised, corners, tree.order, largestGroup); });
    return tree;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(SplitBySah);

BinaryTree buildBySah(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup) {
    return HWY_DYNAMIC_DISPATCH(SplitBySah)(mesh, std::move(triangles), largestGroup);
}

}  // namespace clearway

#endif  // HWY_ONCE
