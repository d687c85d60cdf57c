#include "program/report/page_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/renumber.h"
#include "program/report/page_edges.h"

namespace clearway::report {

namespace {

constexpr double kSteps = 65535;  ///< steps of a coordinate along the box

/// So many times as many triangles as may stay are too many, although some of them become one.
constexpr std::size_t kSurelyTooMany = 2;

/// The cell of each vertex, as a number.
std::vector<std::uint64_t> cellsOf(const std::vector<Vector3>& vertices, const Box& box, double cell) {
    std::vector<std::uint64_t> cells;
    cells.reserve(vertices.size());
    for (const Vector3& vertex : vertices) {
        std::uint64_t key = 0;  // 21 bits for each axis; no grid is finer
        for (int axis = 0; axis < 3; ++axis)
            key = key << 21 | static_cast<std::uint64_t>((vertex[axis] - box.min()[axis]) / cell);
        cells.push_back(key);
    }
    return cells;
}

/// The representative of each vertex: the first vertex in its cell.
std::vector<std::uint32_t> representatives(const std::vector<std::uint64_t>& cells) {
    std::unordered_map<std::uint64_t, std::uint32_t> first;
    std::vector<std::uint32_t> result;
    result.reserve(cells.size());
    for (std::uint32_t i = 0; i < cells.size(); ++i)
        result.push_back(first.try_emplace(cells[i], i).first->second);
    return result;
}

/// The triangles whose corners are in three different cells: as many as thinning leaves, or more.
std::size_t countSpread(const std::vector<OwnedTriangle>& all, const std::vector<std::uint64_t>& cells) {
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const OwnedTriangle& owned) {
        const TriangleIndices& triangle = owned.second;
        const std::uint64_t a = cells[triangle[0]], b = cells[triangle[1]], c = cells[triangle[2]];
        return a != b && b != c && c != a;
    }));
}

/// The triangles between three different representatives, without duplicates in a component, in the order of the
/// components.
std::vector<OwnedTriangle> thinned(const std::vector<OwnedTriangle>& all,
                                   const std::vector<std::uint32_t>& standIns) {
    std::vector<OwnedTriangle> triangles;
    for (const auto& [owner, triangle] : all) {
        TriangleIndices made{standIns[triangle[0]], standIns[triangle[1]], standIns[triangle[2]]};
        if (made[0] == made[1] || made[1] == made[2] || made[2] == made[0]) continue;
        std::sort(made.begin(), made.end());
        triangles.emplace_back(owner, made);
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

/// The edges between two different representatives, without duplicates in a component.
std::vector<OwnedEdge> thinned(const std::vector<OwnedEdge>& all,
                               const std::vector<std::uint32_t>& standIns) {
    std::vector<OwnedEdge> edges;
    for (const OwnedEdge& edge : all) {
        const auto [low, high] = std::minmax(standIns[edge.ends[0]], standIns[edge.ends[1]]);
        if (low != high) edges.push_back({edge.owner, {low, high}});
    }
    const auto key = [](const OwnedEdge& edge) { return std::tie(edge.owner, edge.ends); };
    std::sort(edges.begin(), edges.end(),
              [&](const OwnedEdge& a, const OwnedEdge& b) { return key(a) < key(b); });
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [&](const OwnedEdge& a, const OwnedEdge& b) { return key(a) == key(b); }),
                edges.end());
    return edges;
}

/// The size of a cell. Bisects the number of cells along the diagonal to 5 %.
double cellFor(const std::vector<Vector3>& vertices, const std::vector<OwnedTriangle>& all, const Box& box,
               std::size_t mostTriangles) {
    const double diagonal = box.diagonal().norm();
    double coarse = 8, fine = 65536;
    while (fine / coarse > 1.05) {
        const double along = std::sqrt(coarse * fine);
        const std::vector<std::uint64_t> cells = cellsOf(vertices, box, diagonal / along);
        const std::size_t spread = countSpread(all, cells);
        const bool isTooMany =
            spread > kSurelyTooMany * mostTriangles ||
            (spread > mostTriangles && thinned(all, representatives(cells)).size() > mostTriangles);
        (isTooMany ? fine : coarse) = along;
    }
    return diagonal / coarse;
}

/// Each triangle with the component that it comes from.
std::vector<OwnedTriangle> ownedTriangles(const CleanMesh& welded, const std::vector<Component>& components) {
    std::vector<OwnedTriangle> triangles;
    std::uint32_t owner = 0;
    for (std::size_t i = 0; i < welded.triangles.size(); ++i) {
        const auto isPast = [&](const Component& c) {
            return welded.triangleIds[i] >= c.firstTriangle + c.triangleCount;
        };
        while (isPast(components[owner])) ++owner;  // ids rise
        triangles.emplace_back(owner, welded.triangles[i]);
    }
    return triangles;
}

/// How many of the items each component owns.
template <class Item, class OwnerOf>
std::vector<std::uint32_t> countsOf(const std::vector<Item>& items, std::size_t components,
                                    const OwnerOf& ownerOf) {
    std::vector<std::uint32_t> counts(components, 0);
    for (const Item& item : items) ++counts[ownerOf(item)];
    return counts;
}

std::array<std::uint16_t, 3> storedPosition(const Vector3& vertex, const Box& box) {
    std::array<std::uint16_t, 3> position{};
    const Vector3 extent = box.diagonal();
    for (int axis = 0; axis < 3; ++axis) {
        const double share = (vertex[axis] - box.min()[axis]) / extent[axis];
        if (extent[axis] > 0) position[axis] = static_cast<std::uint16_t>(std::lround(kSteps * share));
    }
    return position;
}

}  // namespace

PageMesh pageMeshOf(const Mesh& mesh, const PageMeshLimits& most) {
    const CleanMesh welded = clean(mesh);
    const std::vector<Component> components = componentsOf(mesh);
    PageMesh page;
    for (const Vector3& vertex : welded.vertices) page.box.extend(vertex);
    std::vector<OwnedTriangle> triangles = ownedTriangles(welded, components);
    // Edges of the whole mesh: a simplified smooth surface has sharp edges that the surface itself lacks.
    std::vector<OwnedEdge> edges = featureEdges(welded.vertices, triangles);
    if (triangles.size() > most.triangles) {
        const double cell = cellFor(welded.vertices, triangles, page.box, most.triangles);
        const std::vector<std::uint32_t> standIns = representatives(cellsOf(welded.vertices, page.box, cell));
        triangles = thinned(triangles, standIns);
        edges = thinned(edges, standIns);
        page.error = cell * std::sqrt(3.0);
    }
    page.error += 0.5 / kSteps * page.box.diagonal().norm();
    page.allEdges = edges.size();
    keepLongest(edges, welded.vertices, most.edges);
    page.triangleCounts =
        countsOf(triangles, components.size(), [](const OwnedTriangle& t) { return t.first; });
    page.edgeCounts = countsOf(edges, components.size(), [](const OwnedEdge& e) { return e.owner; });

    FirstUseOrder numberOf(welded.vertices.size());
    const auto addPosition = [&](std::uint32_t vertex) {
        page.positions.push_back(storedPosition(welded.vertices[vertex], page.box));
    };
    for (auto& [owner, triangle] : triangles) {
        for (std::uint32_t& vertex : triangle) vertex = numberOf(vertex, addPosition);
        page.triangles.push_back(triangle);
    }
    for (OwnedEdge& edge : edges) {
        for (std::uint32_t& vertex : edge.ends) vertex = numberOf(vertex, addPosition);
        page.edges.push_back(edge.ends);
    }
    return page;
}

}  // namespace clearway::report
