#include "model/shells.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace clearway {
namespace {

/// Union-find.
class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) {
        i = find(i);
        j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

Shells findShells(const std::vector<TriangleIndices>& triangles) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>
        sides;  // low and high vertex, triangle
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            sides.emplace_back(low, high, t);
        }
    }
    std::sort(sides.begin(), sides.end());
    Groups groups(triangles.size());
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const auto& [low, high, triangle] = sides[i];
        const auto& [lowBefore, highBefore, triangleBefore] = sides[i - 1];
        if (low == lowBefore && high == highBefore) groups.join(triangle, triangleBefore);
    }
    Shells shells;
    std::vector<std::uint32_t> number(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const std::uint32_t first = groups.find(t);  // the least of its group
        if (first == t) number[t] = shells.count++;
        shells.ofTriangle.push_back(number[first]);
    }
    return shells;
}

std::vector<double> signedVolumes(const std::vector<Vector3>& vertices,
                                  const std::vector<TriangleIndices>& triangles, const Shells& shells) {
    std::vector<const Vector3*> base(shells.count, nullptr);
    std::vector<double> volumes(shells.count, 0.0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::uint32_t shell = shells.ofTriangle[t];
        const TriangleIndices& corner = triangles[t];
        if (!base[shell]) base[shell] = &vertices[corner[0]];
        const Vector3 a = vertices[corner[0]] - *base[shell], b = vertices[corner[1]] - *base[shell],
                      c = vertices[corner[2]] - *base[shell];
        volumes[shell] += a.dot(b.cross(c));
    }
    return volumes;
}

}  // namespace clearway
