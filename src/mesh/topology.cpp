// Counts edges and finds shells by sorting the triangles' sides.
#include "mesh/topology.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace clearway {

namespace {

/// A triangle's side. Both directions along an edge differ only in `isReversed`.
struct Side {
    std::uint32_t low;
    std::uint32_t high;
    bool isReversed;
};

bool isSameEdge(const Side& a, const Side& b) {
    return a.low == b.low && a.high == b.high;
}

std::vector<Side> triangleSides(const std::vector<TriangleIndices>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (const TriangleIndices& t : triangles) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
            sides.push_back({low, high, t[i] != low});
        }
    }
    return sides;
}

void count(const Side* sides, std::size_t number, EdgeReport& report) {
    const auto reversed =
        std::size_t(std::count_if(sides, sides + number, [](const Side& side) { return side.isReversed; }));
    if (2 * reversed == number) {
        ++(number == 2 ? report.closedEdges : report.touchingEdges);
    } else if (number == 1) {
        ++report.openEdges;
    } else {
        ++(number == 2 ? report.twistedEdges : report.overfullEdges);
    }
}

/// Disjoint sets of numbers (union-find), each named by its least member.
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

EdgeReport checkEdges(const std::vector<TriangleIndices>& triangles) {
    std::vector<Side> sides = triangleSides(triangles);
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    EdgeReport report;
    for (std::size_t first = 0, last; first < sides.size(); first = last) {
        for (last = first + 1; last < sides.size() && isSameEdge(sides[first], sides[last]);) ++last;
        count(&sides[first], last - first, report);
    }
    return report;
}

Shells findShells(const std::vector<TriangleIndices>& triangles) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> sides;  // low, high vertex, triangle
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
