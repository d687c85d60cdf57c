// A volume is found in float and then made sure of: its rectangle is rounded to the stored floats, and its radius measured from the
// stored rectangle in double, over all points.
#include "build/fit_volumes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

#include "build/top_down.h"
#include "core/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/fit_volumes.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h

#include "build/frames-inl.h"
#include "build/weighted_spread-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kMostLanes = Collapse::kMostLanes;
static_assert(2 * kMostLanes <= kLaneBlock, "each lane of a wide node has two covariances");

/// The points of a lane: in double, and in float relative to one of them. All in tree units.
struct LanePoints {
    PointArrays exact;
    std::size_t count = 0;
    double reference[3];
    ScratchArray<float> relative[3];  ///< padded
    std::size_t padded = 0;

    PointLanes lanes() const { return {relative[0].data(), relative[1].data(), relative[2].data(), padded}; }
};

class VolumeFitting {
  public:
    VolumeFitting(const std::vector<WideLanes>& nodes, const BinaryTree& binary, const LeafOrder& mesh,
                  const FlatTree& tree, FitFrames frames, const PutVolume& put)
        : nodes_(nodes),
          binary_(binary),
          mesh_(mesh),
          frames_(frames),
          inverseUnit_(1 / tree.unit),
          scaledOrigin_(tree.origin * inverseUnit_),
          put_(put),
          spreads_(nodes.size()) {}

    void run() {
        sumSpreads();
        fitLarge({0, kModelAxes});
    }

  private:
    /// A wide node, and the frame of the volume above it.
    struct Pending {
        std::size_t node;
        FrameAxes axesAbove;
    };

    struct Scratch {
        LanePoints points[kMostLanes];
        PrincipalFrames frames;
        FrameAxes fitted[kMostLanes];
        std::vector<Pending> pending;
    };

    void sumSpreads() {
        constexpr std::size_t kNodesAtATime = 512;
        forEachRun(nodes_.size(), kNodesAtATime, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                for (int lane = 0; lane < nodes_[i].count; ++lane) {
                    if (nodes_[i].child[std::size_t(lane)] < 0)
                        spreads_[i].add(spreadOfLeaf(node(nodes_[i], lane)));
                }
            }
        });
        for (std::size_t i = nodes_.size(); i-- > 1;)  // the nodes below come after those above
            spreads_[nodes_[i].parent].add(spreads_[i]);
    }

    /// Spreads of leaves are computed twice, because keeping them would take more memory than all else here.
    Covariance covarianceOf(const WideLanes& lanes, int lane) const {
        const std::int32_t below = lanes.child[std::size_t(lane)];
        return (below < 0 ? spreadOfLeaf(node(lanes, lane)) : spreads_[std::size_t(below)]).covariance();
    }

    const BinaryNode& node(const WideLanes& lanes, int lane) const {
        return binary_.nodes[std::size_t(lanes.binaryNode[std::size_t(lane)])];
    }

    WeightedSpread spreadOfLeaf(const BinaryNode& leaf) const {
        WeightedSpread spread;
        for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) {
            double corners[3][3];
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vector3 at = mesh_.vertex(mesh_.triangles()[leaf.firstTriangle + i][corner]);
                for (int k = 0; k < 3; ++k) corners[corner][k] = at[k] * inverseUnit_ - scaledOrigin_[k];
            }
            spread.add(SpreadOfTriangle(corners, frames_ == FitFrames::leastOfSeveral));
        }
        return spread;
    }

    void fitLarge(const Pending& next) const {
        const WideLanes& lanes = nodes_[next.node];
        std::size_t triangles = 0;
        for (int lane = 0; lane < lanes.count; ++lane) triangles += node(lanes, lane).triangleCount;
        auto scratch = std::make_unique<Scratch>();
        if (triangles <= kTaskTriangles) {
            fitBelow(next, *scratch);
            return;
        }
        fitNode(next, *scratch);
        std::array<Pending, kMostLanes> below;
        for (int lane = 0; lane < lanes.count; ++lane)
            below[std::size_t(lane)] = pendingLane(next.node, lane, *scratch);
        scratch.reset();
        forEachInParallel(std::size_t(lanes.count), [&](std::size_t lane) {
            if (lanes.child[lane] >= 0) fitLarge(below[lane]);
        });
    }

    void fitBelow(const Pending& root, Scratch& scratch) const {
        scratch.pending.push_back(root);
        while (!scratch.pending.empty()) {
            const Pending next = scratch.pending.back();
            scratch.pending.pop_back();
            fitNode(next, scratch);
            const WideLanes& lanes = nodes_[next.node];
            for (int lane = lanes.count; lane-- > 0;) {
                if (lanes.child[std::size_t(lane)] >= 0)
                    scratch.pending.push_back(pendingLane(next.node, lane, scratch));
            }
        }
    }

    Pending pendingLane(std::size_t wide, int lane, const Scratch& scratch) const {
        const std::size_t place = std::size_t(lane);
        return {std::size_t(nodes_[wide].child[place]), scratch.fitted[place]};
    }

    void fitNode(const Pending& next, Scratch& scratch) const {
        const WideLanes& lanes = nodes_[next.node];
        for (int lane = 0; lane < lanes.count; ++lane) {
            const std::size_t place = std::size_t(lane);
            gather(node(lanes, lane), scratch.points[place]);
            scratch.frames.set(2 * place, covarianceOf(scratch.points[place]));
            scratch.frames.set(2 * place + 1, covarianceOf(lanes, lane));
        }
        scratch.frames.solve();
        for (int lane = 0; lane < lanes.count; ++lane) {
            put_(next.node, lane, fit(next, lane, scratch));
        }
    }

    void gather(const BinaryNode& from, LanePoints& points) const {
        points.count = mesh_.gatherVertices(from.firstTriangle, from.triangleCount, points.exact);
        points.padded = PaddedToBlocks(points.count);
        for (std::size_t k = 0; k < 3; ++k) {
            double* exact = points.exact[k].data();
            const double origin = scaledOrigin_[Eigen::Index(k)];
            for (std::size_t i = 0; i < points.count; ++i) exact[i] = exact[i] * inverseUnit_ - origin;
            const double reference = points.reference[k] = exact[0];
            float* relative = points.relative[k].withRoomFor(points.padded);
            for (std::size_t i = 0; i < points.count; ++i)
                relative[i] = static_cast<float>(exact[i] - reference);
            std::fill(relative + points.count, relative + points.padded, 0.0f);  // the reference again
        }
    }

    static Covariance covarianceOf(const LanePoints& points) {
        const FloatLanes d;
        float sums[9][kLaneBlock];
        for (std::size_t place = 0; place < kLaneBlock; place += hn::Lanes(d)) {
            FloatVector total[9];
            for (FloatVector& sum : total) sum = hn::Zero(d);
            for (std::size_t i = place; i < points.padded; i += kLaneBlock) {
                FloatVector at[3];
                for (int k = 0; k < 3; ++k) at[k] = hn::LoadU(d, points.relative[k].data() + i);
                for (int k = 0; k < 3; ++k) {
                    const int next = (k + 1) % 3;
                    total[k] = hn::Add(total[k], at[k]);
                    total[3 + k] = hn::Add(total[3 + k], hn::Mul(at[k], at[k]));
                    total[6 + k] = hn::Add(total[6 + k], hn::Mul(at[k], at[next]));
                }
            }
            for (int s = 0; s < 9; ++s) hn::StoreU(total[s], d, sums[s] + place);
        }
        float total[9];
        for (int s = 0; s < 9; ++s) total[s] = SumOfBlock(sums[s]);
        const float first[3] = {total[0], total[1], total[2]};
        const float second[6] = {total[3], total[4], total[5], total[6], total[7], total[8]};
        return CovarianceOf(static_cast<float>(points.count), first, second);
    }

    FloatRss fit(const Pending& next, int lane, Scratch& scratch) const {
        const std::size_t place = std::size_t(lane);
        const LanePoints& points = scratch.points[place];
        const BinaryNode& from = node(nodes_[next.node], lane);
        FrameAxes frames[kMostFrames];
        int count = 0, normal = 2;
        std::size_t chosen = 0;
        if (frames_ == FitFrames::ofCorners) {
            frames[0] = scratch.frames.axes(2 * place + 1);
            normal = axisOfLeastSpread(frames[0], covarianceOf(nodes_[next.node], lane));
        } else {
            frames[count++] = from.axes;
            frames[count++] = scratch.frames.axes(2 * place);
            frames[count++] = scratch.frames.axes(2 * place + 1);
            if (!from.isLeaf()) frames[count++] = next.axesAbove;
            const FrameChoice best = LeastAreaFrame(points.lanes(), frames, count);
            chosen = std::size_t(best.frame);
            normal = best.normal;
        }
        return store(points, frames[chosen], normal, scratch.fitted[place]);
    }

    static int axisOfLeastSpread(const FrameAxes& axes, const Covariance& covariance) {
        float spread[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const float x = axes[3 * k], y = axes[3 * k + 1], z = axes[3 * k + 2];
            const float* m = covariance.entries;
            spread[k] =
                x * x * m[0] + y * y * m[1] + z * z * m[2] + 2 * (x * y * m[3] + y * z * m[4] + z * x * m[5]);
        }
        return static_cast<int>(std::min_element(spread, spread + 3) - spread);
    }

    /// Fits the volume in a frame and rounds it outward. fitted: becomes the frame, orthonormal to float, its normal last.
    FloatRss store(const LanePoints& points, const FrameAxes& frame, int normal, FrameAxes& fitted) const {
        double u[3], v[3], w[3];
        for (std::size_t i = 0; i < 3; ++i) {
            u[i] = frame[std::size_t(3 * ((normal + 1) % 3)) + i];
            v[i] = frame[std::size_t(3 * ((normal + 2) % 3)) + i];
        }
        scaleToLength1(u);
        const double along = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        for (int i = 0; i < 3; ++i) v[i] -= along * u[i];
        scaleToLength1(v);
        for (int i = 0; i < 3; ++i) {
            const int p = (i + 1) % 3, q = (i + 2) % 3;
            w[i] = u[p] * v[q] - u[q] * v[p];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            fitted[i] = static_cast<float>(u[i]);
            fitted[3 + i] = static_cast<float>(v[i]);
            fitted[6 + i] = static_cast<float>(w[i]);
        }
        FittedRectangle fit;
        FitRectangle(points.lanes(), fitted, 2, ExtentsIn(fitted, points.lanes()), kInfinity, fit);

        const double middle[2] = {0.5 * (double(fit.low[0]) + fit.high[0]),
                                  0.5 * (double(fit.low[1]) + fit.high[1])};
        FloatRss stored;
        for (int i = 0; i < 3; ++i) {
            stored.centre[i] = storedLength(points.reference[i] + u[i] * middle[0] + v[i] * middle[1] +
                                            w[i] * double(fit.plane));
            stored.axis0[i] = storedAxisEntry(u[i]);
            stored.axis1[i] = storedAxisEntry(v[i]);
        }
        stored.halfLength0 = storedLength(0.5 * (double(fit.high[0]) - fit.low[0]));
        stored.halfLength1 = storedLength(0.5 * (double(fit.high[1]) - fit.low[1]));
        const auto [distanceSquared, normSquared] = farthest(points, stored);
        stored.radius = storedRadius(stored, distanceSquared, normSquared);
        assert(std::isfinite(stored.radius) &&
               std::isfinite(stored.centre[0] + stored.axis0[0] + stored.axis1[0]));
        return stored;
    }

    static void scaleToLength1(double (&v)[3]) {
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        for (double& x : v) x /= length;
    }

    /// The points' greatest squared distances from the stored rectangle, and from the origin, up to rounding.
    static std::pair<double, double> farthest(const LanePoints& points, const FloatRss& stored) {
        const hn::CappedTag<double, kLaneBlock> d;
        double distanceSquared = 0, normSquared = 0;
        const std::size_t whole = points.count / hn::Lanes(d) * hn::Lanes(d);
        farthest(d, points, 0, whole, stored, distanceSquared, normSquared);
        farthest(hn::CappedTag<double, 1>(), points, whole, points.count, stored, distanceSquared,
                 normSquared);
        return {distanceSquared, normSquared};
    }

    template <class D>
    static void farthest(D d, const LanePoints& points, std::size_t first, std::size_t last,
                         const FloatRss& stored, double& distanceSquared, double& normSquared) {
        using V = hn::Vec<D>;
        if (first == last) return;
        V centre[3], axis0[3], axis1[3];
        for (int k = 0; k < 3; ++k) {
            centre[k] = hn::Set(d, double(stored.centre[k]));
            axis0[k] = hn::Set(d, double(stored.axis0[k]));
            axis1[k] = hn::Set(d, double(stored.axis1[k]));
        }
        const V half0 = hn::Set(d, double(stored.halfLength0)),
                half1 = hn::Set(d, double(stored.halfLength1));
        V greatestDistance = hn::Zero(d), greatestNorm = hn::Zero(d);
        const auto lengthSquared = [](V x, V y, V z) HWY_ATTR {
            return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        };
        for (std::size_t i = first; i < last; i += hn::Lanes(d)) {
            V at[3], offset[3];
            for (int k = 0; k < 3; ++k) {
                at[k] = hn::LoadU(d, points.exact[std::size_t(k)].data() + i);
                offset[k] = hn::Sub(at[k], centre[k]);
            }
            // Any s and t within the half lengths give a point of the rectangle, so their rounding does not matter.
            const auto clamped = [&](const V* axis, V half) HWY_ATTR {
                const V along = hn::Add(hn::Add(hn::Mul(offset[0], axis[0]), hn::Mul(offset[1], axis[1])),
                                        hn::Mul(offset[2], axis[2]));
                return hn::Max(hn::Neg(half), hn::Min(half, along));
            };
            const V s = clamped(axis0, half0), t = clamped(axis1, half1);
            V rest[3];
            for (int k = 0; k < 3; ++k)
                rest[k] = hn::Sub(hn::Sub(offset[k], hn::Mul(s, axis0[k])), hn::Mul(t, axis1[k]));
            greatestDistance = hn::Max(greatestDistance, lengthSquared(rest[0], rest[1], rest[2]));
            greatestNorm = hn::Max(greatestNorm, lengthSquared(at[0], at[1], at[2]));
        }
        distanceSquared = std::max(distanceSquared, hn::GetLane(hn::MaxOfLanes(d, greatestDistance)));
        normSquared = std::max(normSquared, hn::GetLane(hn::MaxOfLanes(d, greatestNorm)));
    }

    const std::vector<WideLanes>& nodes_;
    const BinaryTree& binary_;
    const LeafOrder& mesh_;
    const FitFrames frames_;
    const double inverseUnit_;
    const Vector3 scaledOrigin_;
    const PutVolume& put_;
    std::vector<WeightedSpread> spreads_;  ///< of each wide node
};

void FitVolumes(const std::vector<WideLanes>& nodes, const BinaryTree& binary, const LeafOrder& mesh,
                const FlatTree& tree, FitFrames frames, const PutVolume& put) {
    VolumeFitting(nodes, binary, mesh, tree, frames, put).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(FitVolumes);

void fitVolumes(const std::vector<WideLanes>& nodes, const BinaryTree& binary, const LeafOrder& mesh,
                const FlatTree& tree, FitFrames frames, const PutVolume& put) {
    HWY_DYNAMIC_DISPATCH(FitVolumes)(nodes, binary, mesh, tree, frames, put);
}

}  // namespace clearway

#endif  // HWY_ONCE
