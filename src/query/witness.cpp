#include "query/witness.h"

#include <cmath>

#include "exact/double_double.h"

namespace clearway {

Corners movedCorners(const PairQuery& query, std::uint32_t triangle) {
    const FlatTree& tree = *query.part;
    Corners corners;
    for (int k = 0; k < 3; ++k) {
        const Vector3& vertex = tree.vertices[tree.triangles[triangle][k]];
        for (int row = 0; row < 3; ++row) {
            corners.p[k][row] = affineRow(query.R + 3 * row, vertex.data(), query.t[row]) * query.perMeshUnit;
        }
    }
    return corners;
}

Corners fixedCorners(const PairQuery& query, std::uint32_t triangle) {
    const FlatTree& tree = *query.environment;
    Corners corners;
    for (int k = 0; k < 3; ++k) corners.p[k] = tree.vertices[tree.triangles[triangle][k]] * query.perMeshUnit;
    return corners;
}

// With twice the digits and rounded once: 1.8 u64, and as much again where fl(1 - s) made s + t exceed 1.
Vector3 pointAt(const PlaceInTriangle& place, const Corners& triangle) {
    const Vector3 &first = triangle.p[place.corner], &next = triangle.p[(place.corner + 1) % 3],
                  &last = triangle.p[(place.corner + 2) % 3];
    Vector3 x;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble u = twoSum(next[k], -first[k]), v = twoSum(last[k], -first[k]);
        const DoubleDouble su = twoProduct(place.s, u.high), tv = twoProduct(place.t, v.high);
        const DoubleDouble way = twoSum(su.high, tv.high), sum = twoSum(first[k], way.high);
        x[k] = sum.high + (sum.low + way.low + su.low + tv.low + place.s * u.low + place.t * v.low);
    }
    return x;
}

double lengthBetween(const Vector3& p, const Vector3& q) {
    DoubleDouble squared{0, 0};
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble difference = twoSum(p[k], -q[k]);
        const DoubleDouble square = twoProduct(difference.high, difference.high);
        const DoubleDouble sum = twoSum(squared.high, square.high);
        squared = {sum.high, squared.low + sum.low + square.low + 2 * difference.high * difference.low};
    }
    return std::sqrt(squared.high + squared.low);
}

}  // namespace clearway
