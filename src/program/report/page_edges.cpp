#include "program/report/page_edges.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace clearway::report {

namespace {

/// Cosine of 30 degrees. Facets of a cylinder with 16 sides meet at 22.5 degrees and show no edge, chamfers do.
constexpr double kCreaseAngleCosine = 0.866;

/// An edge of one triangle.
struct TriangleSide {
    std::uint32_t owner, low, high, opposite;
    auto edge() const { return std::tie(owner, low, high); }
};

std::vector<TriangleSide> sortedSides(const std::vector<OwnedTriangle>& triangles) {
    std::vector<TriangleSide> sides;
    sides.reserve(3 * triangles.size());
    for (const auto& [owner, t] : triangles) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
            sides.push_back({owner, low, high, t[(i + 2) % 3]});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const TriangleSide& a, const TriangleSide& b) { return a.edge() < b.edge(); });
    return sides;
}

/// Whether the planes of the two triangles at an edge differ enough. Compares the directions from the edge into the
/// triangles, which are opposite in a plane, so that the order of the corners does not matter.
bool isSharp(const std::vector<Vector3>& vertices, const TriangleSide& a, const TriangleSide& b) {
    const Vector3& from = vertices[a.low];
    const Vector3 along = (vertices[a.high] - from).normalized();
    const auto inward = [&](std::uint32_t opposite) {
        const Vector3 way = vertices[opposite] - from;
        return Vector3(way - way.dot(along) * along);
    };
    const Vector3 u = inward(a.opposite), v = inward(b.opposite);
    return u.dot(v) > -kCreaseAngleCosine * u.norm() * v.norm();
}

}  // namespace

std::vector<OwnedEdge> featureEdges(const std::vector<Vector3>& vertices,
                                    const std::vector<OwnedTriangle>& triangles) {
    const std::vector<TriangleSide> sides = sortedSides(triangles);
    std::vector<OwnedEdge> edges;
    for (std::size_t i = 0, next; i < sides.size(); i = next) {
        for (next = i + 1; next < sides.size() && sides[next].edge() == sides[i].edge();) ++next;
        if (next - i != 2 || isSharp(vertices, sides[i], sides[i + 1]))
            edges.push_back({sides[i].owner, {sides[i].low, sides[i].high}});
    }
    return edges;
}

void keepLongest(std::vector<OwnedEdge>& edges, const std::vector<Vector3>& vertices, std::size_t most) {
    if (edges.size() <= most) return;
    const auto length = [&](const OwnedEdge& edge) {
        return (vertices[edge.ends[1]] - vertices[edge.ends[0]]).squaredNorm();
    };
    std::vector<double> lengths;
    for (const OwnedEdge& edge : edges) lengths.push_back(length(edge));
    const auto border = lengths.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(lengths.begin(), border, lengths.end(), std::greater<>());
    const auto isShort = [&, least = *border](const OwnedEdge& edge) { return length(edge) <= least; };
    edges.erase(std::remove_if(edges.begin(), edges.end(), isShort), edges.end());
}

}  // namespace clearway::report
