// The corners of some triangles as structure of arrays, one triangle in each lane, and their moments.
#include <cmath>
#include <cstddef>

#include "build/frames-inl.h"
#include "build/scratch_array.h"
#include "build/triangle_corners.h"
#include "hwy/highway.h"

#if defined(CLEARWAY_BUILD_CORNER_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_BUILD_CORNER_LANES_INL_H_
#undef CLEARWAY_BUILD_CORNER_LANES_INL_H_
#else
#define CLEARWAY_BUILD_CORNER_LANES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Corners relative to a point, padded to a multiple of kLaneBlock triangles by repeating the first.
class CornerLanes {
  public:
    std::size_t count() const { return count_; }
    std::size_t paddedCount() const { return padded_; }
    const float* row(int axis, int corner) const {
        return rows_.data() + std::size_t(3 * axis + corner) * padded_;
    }

    /// All corners as points.
    PointLanes points() const { return {row(0, 0), row(1, 0), row(2, 0), 3 * padded_}; }

    /// Takes every stride-th of the triangles from `first` on.
    void gather(const TriangleCorners& triangles, std::size_t first, std::size_t count, std::size_t stride,
                const float* origin) {
        resize(count);
        for (int corner = 0; corner < 3; ++corner) {
            const Corner* source = triangles.corner[std::size_t(corner)].data() + first;
            const std::size_t done = stride == 1 ? gatherVectors(source, corner, origin) : 0;
            for (std::size_t i = done; i < count; ++i) put(corner, i, source[i * stride].at, origin);
        }
        pad();
    }

    /// Takes the triangles that corners(i) gives, relative to a point in double.
    template <class CornersOf>
    void gatherExactly(std::size_t count, const CornersOf& cornersOf) {
        resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                const Vector3 point = cornersOf(i, corner);
                for (int axis = 0; axis < 3; ++axis) at(axis, corner, i) = static_cast<float>(point[axis]);
            }
        }
        pad();
    }

  private:
    float& at(int axis, int corner, std::size_t i) {
        return rows_.data()[std::size_t(3 * axis + corner) * padded_ + i];
    }

    void resize(std::size_t count) {
        count_ = count;
        padded_ = PaddedToBlocks(count);
        rows_.withRoomFor(9 * padded_);
    }

    void put(int corner, std::size_t i, const float* point, const float* origin) {
        for (int axis = 0; axis < 3; ++axis) at(axis, corner, i) = point[axis] - origin[axis];
    }

    /// Takes as many corners as fill whole vectors, and returns their number.
    std::size_t gatherVectors(const Corner* source, int corner, const float* origin) {
        const FloatLanes d;
        const FloatVector x0 = hn::Set(d, origin[0]), y0 = hn::Set(d, origin[1]), z0 = hn::Set(d, origin[2]);
        std::size_t i = 0;
        for (; i + hn::Lanes(d) <= count_; i += hn::Lanes(d)) {
            FloatVector x, y, z, id;
            hn::LoadInterleaved4(d, source[i].at, x, y, z, id);
            hn::StoreU(hn::Sub(x, x0), d, &at(0, corner, i));
            hn::StoreU(hn::Sub(y, y0), d, &at(1, corner, i));
            hn::StoreU(hn::Sub(z, z0), d, &at(2, corner, i));
        }
        return i;
    }

    void pad() {
        for (int row = 0; row < 9; ++row) {
            float* values = rows_.data() + std::size_t(row) * padded_;
            std::fill(values + count_, values + padded_, values[0]);
        }
    }

    ScratchArray<float> rows_;  ///< x of the first, second and third corners, then y, then z
    std::size_t count_ = 0, padded_ = 0;
};

/// Sums over triangles for the covariances of their corners and of their area. Each part of the surface weighs as much as its
/// area, so that these do not depend on how finely the surface is triangulated.
class SpreadSums {
  public:
    void add(const CornerLanes& triangles) {
        triangles_ += triangles.count();
        const FloatLanes d;
        // Each of the kLaneBlock places sums its own triangles, whatever the number of lanes.
        for (std::size_t place = 0; place < kLaneBlock; place += hn::Lanes(d)) addPlaces(d, place, triangles);
    }

    Covariance ofCorners() const { return covariance(3 * float(triangles_), 0); }
    Covariance ofArea() const { return covariance(total(18), 9); }

    /// The variance of the corners, to be compared with their distance from the origin of coordinates.
    float cornerVariance() const {
        const float weight = 3 * float(triangles_);
        float variance = 0;
        for (int k = 0; k < 3; ++k) {
            const float mean = total(k) / weight;
            variance += total(3 + k) / weight - mean * mean;
        }
        return variance;
    }

  private:
    static constexpr int kSums = 19;

    template <class D>
    void addPlaces(D d, std::size_t place, const CornerLanes& triangles) {
        using V = hn::Vec<D>;
        V sums[kSums];
        for (int s = 0; s < kSums; ++s) sums[s] = hn::LoadU(d, sums_[s] + place);
        const V third = hn::Set(d, 1.0f / 3), twelfth = hn::Set(d, 1.0f / 12);
        for (std::size_t i = place; i < triangles.paddedCount(); i += kLaneBlock) {
            V a[3], b[3], c[3], sum[3], second[6];
            for (int k = 0; k < 3; ++k) {
                a[k] = hn::LoadU(d, triangles.row(k, 0) + i);
                b[k] = hn::LoadU(d, triangles.row(k, 1) + i);
                c[k] = hn::LoadU(d, triangles.row(k, 2) + i);
            }
            if (i + hn::Lanes(d) > triangles.count()) {
                const auto isThere = hn::FirstN(d, i < triangles.count() ? triangles.count() - i : 0);
                for (int k = 0; k < 3; ++k) {
                    a[k] = hn::IfThenElseZero(isThere, a[k]);
                    b[k] = hn::IfThenElseZero(isThere, b[k]);
                    c[k] = hn::IfThenElseZero(isThere, c[k]);
                }
            }
            for (int k = 0; k < 3; ++k) sum[k] = hn::Add(hn::Add(a[k], b[k]), c[k]);
            for (int k = 0; k < 6; ++k) {
                const int p = k % 3, q = k < 3 ? p : (p + 1) % 3;
                second[k] = hn::Add(hn::Add(hn::Mul(a[p], a[q]), hn::Mul(b[p], b[q])), hn::Mul(c[p], c[q]));
            }
            for (int k = 0; k < 3; ++k) sums[k] = hn::Add(sums[k], sum[k]);
            for (int k = 0; k < 6; ++k) sums[3 + k] = hn::Add(sums[3 + k], second[k]);

            // The integral of x x^T over a triangle is area / 12 (aa^T + bb^T + cc^T + s s^T) with s = a + b + c.
            V lengthSquared = hn::Zero(d);
            for (int k = 0; k < 3; ++k) {
                const int p = k, q = (k + 1) % 3;
                const V normal = hn::Sub(hn::Mul(hn::Sub(b[p], a[p]), hn::Sub(c[q], a[q])),
                                         hn::Mul(hn::Sub(b[q], a[q]), hn::Sub(c[p], a[p])));
                lengthSquared = hn::Add(lengthSquared, hn::Mul(normal, normal));
            }
            const V weight = hn::Sqrt(lengthSquared);
            const V ofFirst = hn::Mul(weight, third), ofSecond = hn::Mul(weight, twelfth);
            for (int k = 0; k < 3; ++k) sums[9 + k] = hn::Add(sums[9 + k], hn::Mul(ofFirst, sum[k]));
            for (int k = 0; k < 6; ++k) {
                const int p = k % 3, q = k < 3 ? p : (p + 1) % 3;
                const V products = hn::Add(second[k], hn::Mul(sum[p], sum[q]));
                sums[12 + k] = hn::Add(sums[12 + k], hn::Mul(ofSecond, products));
            }
            sums[18] = hn::Add(sums[18], weight);
        }
        for (int s = 0; s < kSums; ++s) hn::StoreU(sums[s], d, sums_[s] + place);
    }

    float total(int s) const { return SumOfBlock(sums_[s]); }

    Covariance covariance(float weight, int from) const {
        const float first[3] = {total(from), total(from + 1), total(from + 2)};
        float second[6];
        for (int k = 0; k < 6; ++k) second[k] = total(from + 3 + k);
        return CovarianceOf(weight, first, second);
    }

    float sums_[kSums][kLaneBlock] = {};  ///< corners: x, xx^T; area: x, xx^T, weight
    std::size_t triangles_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif  // CLEARWAY_BUILD_CORNER_LANES_INL_H_
