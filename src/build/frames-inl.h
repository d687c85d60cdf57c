// Frames along which triangles spread, and the areas of rectangle swept spheres in them. Every sum is taken in an order that does
// not depend on the number of lanes, and no multiply-add is fused: so all instruction sets build the same tree.
// Source of the fit: Larsen, Gottschalk, Lin, Manocha, Fast Proximity Queries with Swept Sphere Volumes, TR99-018, 1999.
#include <algorithm>
#include <cstddef>
#include <limits>

#include "hwy/highway.h"
#include "tree/binary_tree.h"

#if defined(CLEARWAY_BUILD_FRAMES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_BUILD_FRAMES_INL_H_
#undef CLEARWAY_BUILD_FRAMES_INL_H_
#else
#define CLEARWAY_BUILD_FRAMES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Arrays of points and triangles are padded to a multiple of this many.
constexpr std::size_t kLaneBlock = 16;

inline std::size_t PaddedToBlocks(std::size_t count) {
    return (count + kLaneBlock - 1) / kLaneBlock * kLaneBlock;
}

/// The sum of a block, in an order that vectors can follow.
inline float SumOfBlock(const float* values) {
    float half[kLaneBlock];
    std::copy(values, values + kLaneBlock, half);
    for (std::size_t width = kLaneBlock / 2; width > 0; width /= 2) {
        for (std::size_t i = 0; i < width; ++i) half[i] += half[i + width];
    }
    return half[0];
}

using FloatLanes = hn::CappedTag<float, kLaneBlock>;
using FloatVector = hn::Vec<FloatLanes>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A symmetric matrix, scaled so that its trace is 1; 0 if the spread is too small to have directions.
struct Covariance {
    float entries[6];  ///< xx, yy, zz, xy, yz, zx
};

/// The covariance of weighted points, given the sums over them of w, w x and w x x^T.
template <class Real>
Covariance CovarianceOf(Real weight, const Real (&first)[3], const Real (&second)[6]) {
    Covariance covariance{};
    constexpr Real kLeast = Real(1e-30);
    if (!(weight > kLeast)) return covariance;
    const Real x = first[0] / weight, y = first[1] / weight, z = first[2] / weight;
    const Real mean[6] = {x * x, y * y, z * z, x * y, y * z, z * x};
    Real centred[6];
    for (int i = 0; i < 6; ++i) centred[i] = second[i] / weight - mean[i];
    const Real trace = centred[0] + centred[1] + centred[2];
    if (!(trace > kLeast)) return covariance;
    for (int i = 0; i < 6; ++i) covariance.entries[i] = static_cast<float>(centred[i] / trace);
    return covariance;
}

/// The principal frames of kLaneBlock covariances at a time, by Jacobi's method: one covariance in each lane.
class PrincipalFrames {
  public:
    void set(std::size_t lane, const Covariance& covariance) {
        for (int i = 0; i < 6; ++i) entries_[i][lane] = covariance.entries[i];
    }

    void solve() {
        const FloatLanes d;
        for (std::size_t i = 0; i < kLaneBlock; i += hn::Lanes(d)) solveLanes(d, i);
    }

    FrameAxes axes(std::size_t lane) const {
        FrameAxes axes;
        for (std::size_t i = 0; i < 9; ++i) axes[i] = axes_[i][lane];
        return axes;
    }

  private:
    /// Turns the plane of two axes so that their covariance, pq, vanishes. rp, rq: their covariances with the third.
    template <class D, class V = hn::Vec<D>>
    static HWY_INLINE void Turn(D d, V& pp, V& qq, V& pq, V& rp, V& rq, V* axisP, V* axisQ) {
        const V twice = hn::Add(pq, pq), difference = hn::Sub(qq, pp);
        const V root = hn::Sqrt(hn::Add(hn::Mul(difference, difference), hn::Mul(twice, twice)));
        const V denominator = hn::Add(hn::Add(hn::Abs(difference), root), hn::Set(d, 1e-30f));
        const V isNegative = hn::IfThenElse(hn::Lt(difference, hn::Zero(d)), hn::Neg(twice), twice);
        const V tangent = hn::Div(isNegative, denominator);
        const V one = hn::Set(d, 1.0f);
        const V cosine = hn::Div(one, hn::Sqrt(hn::Add(hn::Mul(tangent, tangent), one)));
        const V sine = hn::Mul(tangent, cosine), shift = hn::Mul(tangent, pq);
        pp = hn::Sub(pp, shift);
        qq = hn::Add(qq, shift);
        pq = hn::Zero(d);
        const auto turn = [&](V& p, V& q) HWY_ATTR {
            const V turnedP = hn::Sub(hn::Mul(p, cosine), hn::Mul(q, sine));
            q = hn::Add(hn::Mul(p, sine), hn::Mul(q, cosine));
            p = turnedP;
        };
        turn(rp, rq);
        for (int i = 0; i < 3; ++i) turn(axisP[i], axisQ[i]);
    }

    template <class D>
    void solveLanes(D d, std::size_t lane) {
        using V = hn::Vec<D>;
        V m[6], axes[9];
        for (int i = 0; i < 6; ++i) m[i] = hn::LoadU(d, entries_[i] + lane);
        for (int i = 0; i < 9; ++i) axes[i] = hn::Set(d, i % 4 == 0 ? 1.0f : 0.0f);
        constexpr int kSweeps = 4;  // more change no digit that matters
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            Turn(d, m[0], m[1], m[3], m[5], m[4], axes, axes + 3);
            Turn(d, m[1], m[2], m[4], m[3], m[5], axes + 3, axes + 6);
            Turn(d, m[0], m[2], m[5], m[3], m[4], axes, axes + 6);
        }
        for (int i = 0; i < 9; ++i) hn::StoreU(axes[i], d, axes_[i] + lane);
    }

    float entries_[6][kLaneBlock] = {};
    float axes_[9][kLaneBlock];
};

/// Points as structure of arrays. A multiple of kLaneBlock; padding repeats one of them.
struct PointLanes {
    const float *x, *y, *z;
    std::size_t count;
};

/// The lowest and highest place of points along the axes of a frame.
struct FrameExtents {
    float low[3], high[3];
    float length(int axis) const { return high[axis] - low[axis]; }
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE V Along(V axisX, V axisY, V axisZ, V x, V y, V z) {
    return hn::Add(hn::Mul(axisX, x), hn::Add(hn::Mul(axisY, y), hn::Mul(axisZ, z)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE float LeastOf(D d, V v) {
    return hn::GetLane(hn::MinOfLanes(d, v));
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE float GreatestOf(D d, V v) {
    return hn::GetLane(hn::MaxOfLanes(d, v));
}

inline FrameExtents ExtentsIn(const FrameAxes& frame, const PointLanes& points) {
    using D = FloatLanes;
    using V = FloatVector;
    const D d;
    V axes[9], low[3], high[3];
    for (std::size_t i = 0; i < 9; ++i) axes[i] = hn::Set(d, frame[i]);
    for (int k = 0; k < 3; ++k) {
        low[k] = hn::Set(d, kInfinity);
        high[k] = hn::Set(d, -kInfinity);
    }
    for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
        const V x = hn::LoadU(d, points.x + i), y = hn::LoadU(d, points.y + i),
                z = hn::LoadU(d, points.z + i);
        for (int k = 0; k < 3; ++k) {
            const V place = Along<D>(axes[3 * k], axes[3 * k + 1], axes[3 * k + 2], x, y, z);
            low[k] = hn::Min(low[k], place);
            high[k] = hn::Max(high[k], place);
        }
    }
    FrameExtents extents;
    for (int k = 0; k < 3; ++k) {
        extents.low[k] = LeastOf(d, low[k]);
        extents.high[k] = GreatestOf(d, high[k]);
    }
    return extents;
}

inline float SweptArea(float length, float width, float radius) {
    constexpr float kPi = 3.14159265f;
    return 4 * kPi * radius * radius + 2 * length * width + 2 * kPi * radius * (length + width);
}

/// The least area that a volume around points of these extents can have, with its normal along one of the axes.
inline float LeastSweptArea(const FrameExtents& extents, int normal) {
    const float depth = extents.length(normal);
    const float length = extents.length((normal + 1) % 3), width = extents.length((normal + 2) % 3);
    return SweptArea(std::max(length - depth, 0.0f), std::max(width - depth, 0.0f), 0.5f * depth);
}

/// A rectangle swept sphere in a frame: the rectangle's sides lie along the two axes after the normal.
struct FittedRectangle {
    float low[2], high[2];
    float plane;  ///< of the rectangle along the normal
    float radius;
    float area() const { return SweptArea(high[0] - low[0], high[1] - low[1], radius); }
};

/// Larsen's fit in a frame. The radius is half the extent along the normal; the sides need only come as near to each point as the
/// swept sphere reaches at its height; then each corner is pushed outward, along its diagonal, for the points beyond it. Each push
/// starts from the corner's first place, so the order of the points does not matter. Returns infinity in place of the area, and no
/// rectangle, as soon as the area cannot be below `least`.
inline float FitRectangle(const PointLanes& points, const FrameAxes& frame, int normal,
                          const FrameExtents& extents, float least, FittedRectangle& fitted) {
    using D = FloatLanes;
    using V = FloatVector;
    const D d;
    V u[3], v[3], w[3];
    for (std::size_t i = 0; i < 3; ++i) {
        u[i] = hn::Set(d, frame[std::size_t(3 * ((normal + 1) % 3)) + i]);
        v[i] = hn::Set(d, frame[std::size_t(3 * ((normal + 2) % 3)) + i]);
        w[i] = hn::Set(d, frame[std::size_t(3 * normal) + i]);
    }
    fitted.plane = 0.5f * (extents.low[normal] + extents.high[normal]);
    fitted.radius = 0.5f * extents.length(normal);
    const V zero = hn::Zero(d), plane = hn::Set(d, fitted.plane);
    const V radiusSquared = hn::Set(d, fitted.radius * fitted.radius);

    V low0 = hn::Set(d, kInfinity), low1 = low0, high0 = hn::Set(d, -kInfinity), high1 = high0;
    for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
        const V x = hn::LoadU(d, points.x + i), y = hn::LoadU(d, points.y + i),
                z = hn::LoadU(d, points.z + i);
        const V a = Along<D>(u[0], u[1], u[2], x, y, z), b = Along<D>(v[0], v[1], v[2], x, y, z);
        const V height = hn::Sub(Along<D>(w[0], w[1], w[2], x, y, z), plane);
        const V reach = hn::Sqrt(hn::Max(hn::Sub(radiusSquared, hn::Mul(height, height)), zero));
        low0 = hn::Min(low0, hn::Add(a, reach));
        high0 = hn::Max(high0, hn::Sub(a, reach));
        low1 = hn::Min(low1, hn::Add(b, reach));
        high1 = hn::Max(high1, hn::Sub(b, reach));
    }
    fitted.low[0] = LeastOf(d, low0);
    fitted.high[0] = GreatestOf(d, high0);
    fitted.low[1] = LeastOf(d, low1);
    fitted.high[1] = GreatestOf(d, high1);
    for (int side = 0; side < 2; ++side) {  // flat and midway if the sphere covers the whole extent
        if (fitted.low[side] > fitted.high[side])
            fitted.low[side] = fitted.high[side] = 0.5f * (fitted.low[side] + fitted.high[side]);
    }
    if (!(fitted.area() < least)) return kInfinity;

    const V sideLow0 = hn::Set(d, fitted.low[0]), sideHigh0 = hn::Set(d, fitted.high[0]);
    const V sideLow1 = hn::Set(d, fitted.low[1]), sideHigh1 = hn::Set(d, fitted.high[1]);
    const V sqrtHalf = hn::Set(d, 0.70710678f);
    V pushLow0 = zero, pushHigh0 = zero, pushLow1 = zero, pushHigh1 = zero;
    for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
        const V x = hn::LoadU(d, points.x + i), y = hn::LoadU(d, points.y + i),
                z = hn::LoadU(d, points.z + i);
        const V a = Along<D>(u[0], u[1], u[2], x, y, z), b = Along<D>(v[0], v[1], v[2], x, y, z);
        const V height = hn::Sub(Along<D>(w[0], w[1], w[2], x, y, z), plane);
        const V above0 = hn::Sub(a, sideHigh0), below0 = hn::Sub(sideLow0, a);
        const V above1 = hn::Sub(b, sideHigh1), below1 = hn::Sub(sideLow1, b);
        const V beyond0 = hn::Max(above0, below0), beyond1 = hn::Max(above1, below1);
        const V across = hn::Mul(hn::Sub(beyond0, beyond1), sqrtHalf);
        const V reachSquared =
            hn::Sub(hn::Sub(radiusSquared, hn::Mul(across, across)), hn::Mul(height, height));
        const V reach = hn::Sqrt(hn::Max(reachSquared, zero));
        const V needed = hn::Mul(hn::Sub(hn::Mul(hn::Add(beyond0, beyond1), sqrtHalf), reach), sqrtHalf);
        const V push = hn::IfThenElseZero(hn::Gt(hn::Min(beyond0, beyond1), zero), needed);
        const auto raise = [&](V& side, V beyond) HWY_ATTR {
            side = hn::Max(side, hn::IfThenElseZero(hn::Gt(beyond, zero), push));
        };
        raise(pushHigh0, above0);
        raise(pushLow0, below0);
        raise(pushHigh1, above1);
        raise(pushLow1, below1);
    }
    fitted.low[0] -= GreatestOf(d, pushLow0);
    fitted.high[0] += GreatestOf(d, pushHigh0);
    fitted.low[1] -= GreatestOf(d, pushLow1);
    fitted.high[1] += GreatestOf(d, pushHigh1);
    const float area = fitted.area();
    return area < least ? area : kInfinity;
}

/// The choice of a frame and of the axis in it that is the rectangle's normal.
struct FrameChoice {
    float area = kInfinity;
    int frame = 0;
    int normal = 2;
};

/// The position of the least of kLaneBlock values.
inline int PositionOfLeast(const float* values) {
    const FloatLanes d;
    FloatVector least = hn::LoadU(d, values);
    for (std::size_t i = hn::Lanes(d); i < kLaneBlock; i += hn::Lanes(d))
        least = hn::Min(least, hn::LoadU(d, values + i));
    least = hn::MinOfLanes(d, least);
    for (std::size_t i = 0;; i += hn::Lanes(d)) {
        const auto lane = hn::FindFirstTrue(d, hn::Eq(hn::LoadU(d, values + i), least));
        if (lane >= 0) return static_cast<int>(i) + static_cast<int>(lane);
        if (i + hn::Lanes(d) >= kLaneBlock) return 0;  // for NaN
    }
}

/// The choice of least area among `count` frames, at most kMostFrames, with three normals each.
constexpr int kMostFrames = 4;
static_assert(3 * kMostFrames <= kLaneBlock);
inline FrameChoice LeastAreaFrame(const PointLanes& points, const FrameAxes* frames, int count) {
    FrameExtents extents[kMostFrames];
    float atLeast[kLaneBlock];  // infinite where it was tried
    std::fill(atLeast, atLeast + kLaneBlock, kInfinity);
    for (int f = 0; f < count; ++f) {
        extents[f] = ExtentsIn(frames[f], points);
        for (int normal = 0; normal < 3; ++normal)
            atLeast[3 * f + normal] = LeastSweptArea(extents[f], normal);
    }
    FrameChoice best;
    for (;;) {  // the most promising one first, until none can be better
        const int next = PositionOfLeast(atLeast);
        if (!(atLeast[next] < best.area)) return best;
        atLeast[next] = kInfinity;
        FittedRectangle fitted;
        const int frame = next / 3, normal = next % 3;
        const float area = FitRectangle(points, frames[frame], normal, extents[frame], best.area, fitted);
        if (area < best.area) best = {area, frame, normal};
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif  // CLEARWAY_BUILD_FRAMES_INL_H_
