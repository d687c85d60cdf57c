// Counts edges and finds shells in one pass over the triangles' sides, which a counting sort groups by their lower vertex.
#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace clearway {

namespace {

/// A triangle's side, listed at its lower vertex.
struct Side {
    std::uint32_t high;  ///< its other vertex
    std::uint32_t triangle;
    int direction;  ///< 1: from the lower vertex to the other, -1: back, 0: the triangle has collapsed
};

/// Counts the edge that all these sides share.
void count(const Side* first, const Side* last, EdgeReport& report) {
    std::size_t number = 0;
    int sum = 0;
    for (const Side* side = first; side != last; ++side) {
        number += side->direction != 0;
        sum += side->direction;
    }
    if (number == 0) return;
    if (sum == 0) {
        ++(number == 2 ? report.closedEdges : report.touchingEdges);
    } else if (number == 1) {
        ++report.openEdges;
    } else {
        ++(number == 2 ? report.twistedEdges : report.overfullEdges);
    }
}

/// The sides of all triangles, grouped by lower vertex.
struct SidesByVertex {
    explicit SidesByVertex(const std::vector<TriangleIndices>& triangles) : sides(3 * triangles.size()) {
        std::uint32_t vertices = 0;
        for (const TriangleIndices& t : triangles)
            vertices = std::max({vertices, t[0] + 1, t[1] + 1, t[2] + 1});
        end.assign(vertices + std::size_t(1), 0);
        const auto eachSide = [&](const auto& take) {
            for (std::uint32_t i = 0; i < triangles.size(); ++i) {
                for (int k = 0; k < 3; ++k) take(i, triangles[i][k], triangles[i][(k + 1) % 3]);
            }
        };
        eachSide([&](std::uint32_t, std::uint32_t from, std::uint32_t to) { ++end[std::min(from, to) + 1]; });
        std::partial_sum(end.begin(), end.end(), end.begin());
        eachSide([&](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
            const TriangleIndices& t = triangles[i];
            const bool isCollapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
            const int direction = isCollapsed ? 0 : from < to ? 1 : -1;
            sides[end[std::min(from, to)]++] = {std::max(from, to), i, direction};
        });
        end.pop_back();
    }

    std::vector<Side> sides;
    std::vector<std::size_t> end;  ///< of each vertex's group
};

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

Topology findTopology(const std::vector<TriangleIndices>& triangles) {
    SidesByVertex byVertex(triangles);
    Topology found;
    Groups groups(triangles.size());
    Side* first = byVertex.sides.data();
    for (const std::size_t end : byVertex.end) {
        Side* const last = byVertex.sides.data() + end;
        std::sort(first, last, [](const Side& a, const Side& b) { return a.high < b.high; });
        while (first != last) {
            const Side* const edge = first;
            while (++first != last && first->high == edge->high) groups.join(first->triangle, edge->triangle);
            count(edge, first, found.edges);
        }
    }
    Shells& shells = found.shells;
    shells.ofTriangle.resize(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const std::uint32_t least = groups.find(t);  // of its group
        shells.ofTriangle[t] = least == t ? shells.count++ : shells.ofTriangle[least];
    }
    return found;
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
