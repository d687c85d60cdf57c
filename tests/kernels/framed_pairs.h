// The hard triangle pairs as kernels meet them: near the origin, of size at most 1, rounded to the kernel's
// number type, with the exact distance of the rounded corners; also as rows for whole-vector loads.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/exact_distance.h"
#include "support/hard_triangles.h"
#include "support/triangle_distance.h"

namespace clearway::testing {

template <class T>
struct FramedPair {
    std::string family;
    LongTriangle a, b;  ///< exactly the T that the kernel reads
    TriangleDistance truth;
    long double size;  ///< largest |corner| of a plus that of b: what rounding is relative to
};

/// Number of pairs in rows: whole vectors of every instruction set.
constexpr std::size_t kVectorPairs = 16;

/// Coordinate c of corner k of pair i is at (3 k + c) * pairs + i.
template <class T>
struct TriangleRows {
    std::size_t pairs = 0;  ///< a multiple of kVectorPairs
    std::vector<T> a, b;
};

inline long double largestNorm(const LongTriangle& triangle) {
    return std::max({triangle[0].norm(), triangle[1].norm(), triangle[2].norm()});
}

/// Long double is off by 1e-17 of the size for the worst needles; what is nearer than 1e-14 is asked again.
template <class T>
TriangleDistance truthOf(const LongTriangle& a, const LongTriangle& b) {
    TriangleDistance truth = triangleDistance(a, b);
    if (truth.distance <= 1e-14L) {
        std::array<Vector3, 3> exactA, exactB;
        for (int k = 0; k < 3; ++k) {
            exactA[k] = a[k].cast<double>();
            exactB[k] = b[k].cast<double>();
        }
        truth.distance = exactDistance(exactA, exactB).rounded();
    }
    return truth;
}

template <class T>
FramedPair<T> framed(const std::string& family, const TrianglePair& pair) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.extend(pair.a[k]);
        box.extend(pair.b[k]);
    }
    const Vector3 centre = box.center();
    const double side = box.sizes().maxCoeff();
    const double unit = side > 0 ? std::ldexp(1.0, std::ilogb(side)) : 1;
    FramedPair<T> result;
    result.family = family;
    for (int k = 0; k < 3; ++k) {
        result.a[k] = ((pair.a[k] - centre) / unit).template cast<T>().template cast<long double>();
        result.b[k] = ((pair.b[k] - centre) / unit).template cast<T>().template cast<long double>();
    }
    result.truth = truthOf<T>(result.a, result.b);
    result.size = largestNorm(result.a) + largestNorm(result.b);
    return result;
}

/// `draws` of every family of hard triangles.
template <class T>
std::vector<FramedPair<T>> framedPairs(std::uint64_t seed, int draws) {
    std::vector<FramedPair<T>> pairs;
    Random random(seed);
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        for (int i = 0; i < draws; ++i) pairs.push_back(framed<T>(family.name, family.make(random)));
    }
    return pairs;
}

/// Filled up with copies of the first pair.
template <class T>
TriangleRows<T> rowsOf(const std::vector<FramedPair<T>>& pairs) {
    TriangleRows<T> rows;
    rows.pairs = (pairs.size() + kVectorPairs - 1) / kVectorPairs * kVectorPairs;
    rows.a.resize(9 * rows.pairs);
    rows.b.resize(9 * rows.pairs);
    for (std::size_t i = 0; i < rows.pairs; ++i) {
        const FramedPair<T>& pair = pairs[i < pairs.size() ? i : 0];
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                rows.a[(3 * k + c) * rows.pairs + i] = static_cast<T>(pair.a[k][Eigen::Index(c)]);
                rows.b[(3 * k + c) * rows.pairs + i] = static_cast<T>(pair.b[k][Eigen::Index(c)]);
            }
        }
    }
    return rows;
}

}  // namespace clearway::testing
