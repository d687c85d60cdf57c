// Estimates what each part of a small group of triangles costs queries as a leaf, one group in each lane of a vector.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "build/frames-inl.h"
#include "build/leaf_splits.h"
#include "hwy/highway.h"

#if defined(CLEARWAY_BUILD_PART_COSTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_BUILD_PART_COSTS_INL_H_
#undef CLEARWAY_BUILD_PART_COSTS_INL_H_
#else
#define CLEARWAY_BUILD_PART_COSTS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A part of a group: bit i is set if the group's triangle i belongs to it.
using Part = unsigned;
constexpr Part kParts = 1u << kMostByCost;

inline bool isIn(Part part, std::size_t triangle) {
    return (part >> triangle & 1) != 0;
}
inline Part withoutFirst(Part part) {
    return part & (part - 1);
}

template <class V>
struct VectorLanes {
    V x, y, z;
};

template <class V>
HWY_INLINE VectorLanes<V> Difference(const VectorLanes<V>& a, const VectorLanes<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class V>
HWY_INLINE VectorLanes<V> Scaled(const VectorLanes<V>& a, V by) {
    return {hn::Mul(a.x, by), hn::Mul(a.y, by), hn::Mul(a.z, by)};
}
template <class V>
HWY_INLINE V Dot(const VectorLanes<V>& a, const VectorLanes<V>& b) {
    return hn::Add(hn::Mul(a.x, b.x), hn::Add(hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)));
}
template <class V>
HWY_INLINE VectorLanes<V> Cross(const VectorLanes<V>& a, const VectorLanes<V>& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
template <class Mask, class V>
HWY_INLINE VectorLanes<V> Choice(Mask mask, const VectorLanes<V>& yes, const VectorLanes<V>& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}

/// The directions of vectors, or the other directions where vectors are too short to have one.
template <class D, class V = hn::Vec<D>>
HWY_INLINE VectorLanes<V> Direction(D d, const VectorLanes<V>& of, const VectorLanes<V>& otherwise) {
    constexpr float kLeastSquared = 1e-20f;  // in units of the group's size
    const V one = hn::Set(d, 1.0f), lengthSquared = Dot(of, of);
    const auto isLong = hn::Gt(lengthSquared, hn::Set(d, kLeastSquared));
    const V inverse = hn::Div(one, hn::Sqrt(hn::IfThenElse(isLong, lengthSquared, one)));
    return Choice(isLong, Scaled(of, inverse), otherwise);
}

/// Any direction square to u.
template <class D, class V = hn::Vec<D>>
HWY_INLINE VectorLanes<V> SquareTo(D d, const VectorLanes<V>& u) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const VectorLanes<V> x = {one, zero, zero}, y = {zero, one, zero};
    return Direction(d, Cross(u, Choice(hn::Gt(hn::Abs(u.x), hn::Set(d, 0.6f)), y, x)), y);
}

/// kLaneBlock groups of triangles. A part is rated in frames along each edge of its triangles, in that triangle's plane; and if it has
/// several triangles, in a frame square to the mean of their normals.
class PartCosts {
  public:
    /// corners: of `count` triangles, at most kMostByCost, relative to one of them.
    void set(std::size_t lane, const double (*corners)[3][3], std::size_t count) {
        double size = 0;
        for (std::size_t t = 0; t < count; ++t) {
            for (const auto& corner : corners[t]) {
                for (const double x : corner) size = std::max(size, std::abs(x));
            }
        }
        const double scale = size > 0 ? 1 / size : 0;
        for (std::size_t t = 0; t < kMostByCost; ++t) {
            const auto& triangle = corners[t < count ? t : 0];
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t k = 0; k < 3; ++k)
                    corners_[t][c][k][lane] = static_cast<float>(triangle[c][k] * scale);
            }
        }
        unit_[lane] = static_cast<float>(size * size);
    }

    void rate() {
        const FloatLanes d;
        for (std::size_t i = 0; i < kLaneBlock; i += hn::Lanes(d)) rateLanes(d, i);
    }

    /// The cost of a leaf over the part: its area, with the rim's share of it weighted.
    float cost(Part part, std::size_t lane) const { return cost_[part][lane]; }
    /// The area of a volume around the part.
    float area(Part part, std::size_t lane) const { return area_[part][lane]; }
    /// Costs and areas times this are in the unit of the corners.
    float unit(std::size_t lane) const { return unit_[lane]; }

  private:
    /// In the rim, which is round, a volume is near to much that is not near to the triangles.
    static constexpr float kRimWeight = 4;

    /// Extents along an axis.
    template <class V>
    struct Extents {
        V low[kParts], high[kParts];
        V of(Part part) const { return hn::Sub(high[part], low[part]); }
    };

    template <class D, class V = hn::Vec<D>>
    HWY_INLINE VectorLanes<V> corner(D d, std::size_t triangle, std::size_t number, std::size_t lane) const {
        const auto& at = corners_[triangle][number];
        return {hn::LoadU(d, at[0] + lane), hn::LoadU(d, at[1] + lane), hn::LoadU(d, at[2] + lane)};
    }

    template <class D, class V = hn::Vec<D>>
    HWY_INLINE void measureTriangle(D d, std::size_t triangle, const VectorLanes<V>& axis, std::size_t lane,
                                    Extents<V>& extents) const {
        const V a = Dot(axis, corner(d, triangle, 0, lane)), b = Dot(axis, corner(d, triangle, 1, lane)),
                c = Dot(axis, corner(d, triangle, 2, lane));
        extents.low[1u << triangle] = hn::Min(hn::Min(a, b), c);
        extents.high[1u << triangle] = hn::Max(hn::Max(a, b), c);
    }

    template <class D, class V = hn::Vec<D>>
    void measureParts(D d, const VectorLanes<V>& axis, std::size_t lane, Extents<V>& extents) const {
        for (std::size_t t = 0; t < kMostByCost; ++t) measureTriangle(d, t, axis, lane, extents);
        for (Part part = 1; part < kParts; ++part) {
            const Part rest = withoutFirst(part), first = part ^ rest;
            if (rest == 0) continue;
            extents.low[part] = hn::Min(extents.low[first], extents.low[rest]);
            extents.high[part] = hn::Max(extents.high[first], extents.high[rest]);
        }
    }

    /// Rates a part by its extents in a frame, the depth square to the rectangle. Returns where it is the cheapest so far.
    template <class D, class V = hn::Vec<D>>
    HWY_INLINE hn::Mask<D> tryExtents(D d, Part part, V length, V width, V depth, std::size_t lane) {
        constexpr float kPi = 3.14159265f;
        const V two = hn::Set(d, 2.0f), pi = hn::Set(d, kPi), rim = hn::Set(d, kRimWeight);
        // The rectangle is taken to reach as far as the points, though the rim around it might reach them, too.
        const V flat = hn::Mul(hn::Mul(length, width), two);
        const V round = hn::Mul(hn::Mul(depth, pi), hn::Add(hn::Add(length, width), depth));
        const V cost = hn::Add(flat, hn::Mul(round, rim)), before = hn::LoadU(d, cost_[part] + lane);
        const auto isLess = hn::Lt(cost, before);
        const auto replace = [&](float* values, V by) HWY_ATTR {
            hn::StoreU(hn::IfThenElse(isLess, by, hn::LoadU(d, values + lane)), d, values + lane);
        };
        replace(cost_[part], cost);
        replace(area_[part], hn::Add(flat, round));
        return isLess;
    }

    template <class D>
    void rateLanes(D d, std::size_t lane) {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
        for (Part part = 1; part < kParts; ++part) {
            hn::StoreU(hn::Set(d, kInfinity), d, cost_[part] + lane);
            hn::StoreU(zero, d, area_[part] + lane);
        }
        VectorLanes<V> normals[kMostByCost];  // as long as the triangles are large
        VectorLanes<V> sides[kParts];         // the cheapest rectangle's
        for (VectorLanes<V>& side : sides) side = {one, zero, zero};
        for (std::size_t t = 0; t < kMostByCost; ++t) rateAlongEdges(d, t, lane, normals[t], sides);
        for (Part part = 1; part < kParts; ++part) {
            if (withoutFirst(part) != 0) rateAlongMeanNormal(d, part, lane, normals, sides[part]);
        }
    }

    template <class D, class V = hn::Vec<D>>
    void rateAlongEdges(D d, std::size_t triangle, std::size_t lane, VectorLanes<V>& normal,
                        VectorLanes<V>* sides) {
        const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
        const VectorLanes<V> a = corner(d, triangle, 0, lane), b = corner(d, triangle, 1, lane),
                             c = corner(d, triangle, 2, lane);
        const VectorLanes<V> edges[3] = {Difference(b, a), Difference(c, b), Difference(a, c)};
        normal = Cross(edges[0], edges[1]);
        // Triangles that are segments or points have frames along them, too.
        const VectorLanes<V> any =
            Direction(d, edges[1], Direction(d, edges[0], VectorLanes<V>{one, zero, zero}));
        const VectorLanes<V> across = Direction(d, normal, SquareTo(d, any));
        Extents<V> lengths, widths, depths;
        measureParts(d, across, lane, depths);
        for (const VectorLanes<V>& edge : edges) {
            const VectorLanes<V> side = Direction(d, edge, any);
            measureParts(d, side, lane, lengths);
            measureParts(d, Cross(across, side), lane, widths);
            for (Part part = 1; part < kParts; ++part) {
                if (!isIn(part, triangle)) continue;
                const auto isCheapest =
                    tryExtents(d, part, lengths.of(part), widths.of(part), depths.of(part), lane);
                sides[part] = Choice(isCheapest, side, sides[part]);
            }
        }
    }

    template <class D, class V = hn::Vec<D>>
    void rateAlongMeanNormal(D d, Part part, std::size_t lane, const VectorLanes<V>* normals,
                             const VectorLanes<V>& side) {
        const V zero = hn::Zero(d);
        VectorLanes<V> sum = {zero, zero, zero};
        for (std::size_t t = 0; t < kMostByCost; ++t) {
            if (!isIn(part, t)) continue;
            const VectorLanes<V>& n = normals[t];  // its sign does not matter
            const VectorLanes<V> opposite = {hn::Neg(n.x), hn::Neg(n.y), hn::Neg(n.z)};
            const VectorLanes<V> next = Choice(hn::Lt(Dot(n, sum), zero), opposite, n);
            sum = {hn::Add(sum.x, next.x), hn::Add(sum.y, next.y), hn::Add(sum.z, next.z)};
        }
        const VectorLanes<V> across = Direction(d, sum, SquareTo(d, side));
        const VectorLanes<V> within = Difference(side, Scaled(across, Dot(across, side)));
        const VectorLanes<V> along = Direction(d, within, SquareTo(d, across));
        tryExtents(d, part, extentOf(d, part, along, lane), extentOf(d, part, Cross(across, along), lane),
                   extentOf(d, part, across, lane), lane);
    }

    template <class D, class V = hn::Vec<D>>
    V extentOf(D d, Part part, const VectorLanes<V>& axis, std::size_t lane) const {
        Extents<V> extents;
        V low = hn::Set(d, kInfinity), high = hn::Set(d, -kInfinity);
        for (std::size_t t = 0; t < kMostByCost; ++t) {
            if (!isIn(part, t)) continue;
            measureTriangle(d, t, axis, lane, extents);
            low = hn::Min(low, extents.low[1u << t]);
            high = hn::Max(high, extents.high[1u << t]);
        }
        return hn::Sub(high, low);
    }

    float corners_[kMostByCost][3][3]
                  [kLaneBlock];  ///< by triangle, corner and axis, in units of the group's size
    float unit_[kLaneBlock];     ///< the size squared
    float cost_[kParts][kLaneBlock], area_[kParts][kLaneBlock];
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif  // CLEARWAY_BUILD_PART_COSTS_INL_H_
