#include "program/report/page_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "mesh/clean.h"
#include "mesh/renumber.h"

namespace clearway::report {

namespace {

constexpr double kSteps = 65535;  ///< steps of a coordinate along the box

/// The representative of each vertex: the first vertex in its cell.
std::vector<std::uint32_t> representatives(const std::vector<Vector3>& vertices, const Box& box,
                                           double cell) {
    std::unordered_map<std::uint64_t, std::uint32_t> first;
    std::vector<std::uint32_t> result;
    result.reserve(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        std::uint64_t key = 0;  // 21 bits for each axis; no grid is finer
        for (int axis = 0; axis < 3; ++axis)
            key = key << 21 | static_cast<std::uint64_t>((vertices[i][axis] - box.min()[axis]) / cell);
        result.push_back(first.try_emplace(key, i).first->second);
    }
    return result;
}

/// The triangles between three different representatives, without duplicates, in no particular order.
std::vector<TriangleIndices> thinned(const CleanMesh& mesh, const Box& box, double cell) {
    const std::vector<std::uint32_t> standIns = representatives(mesh.vertices, box, cell);
    std::vector<TriangleIndices> triangles;
    for (const TriangleIndices& triangle : mesh.triangles) {
        TriangleIndices made{standIns[triangle[0]], standIns[triangle[1]], standIns[triangle[2]]};
        if (made[0] == made[1] || made[1] == made[2] || made[2] == made[0]) continue;
        std::sort(made.begin(), made.end());
        triangles.push_back(made);
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

/// The size of a cell. Bisects the number of cells along the diagonal to 5 %.
double cellFor(const CleanMesh& mesh, const Box& box, std::size_t mostTriangles) {
    const double diagonal = box.diagonal().norm();
    double coarse = 8, fine = 65536;
    while (fine / coarse > 1.05) {
        const double cells = std::sqrt(coarse * fine);
        (thinned(mesh, box, diagonal / cells).size() > mostTriangles ? fine : coarse) = cells;
    }
    return diagonal / coarse;
}

}  // namespace

PageMesh pageMeshOf(const Mesh& mesh, std::size_t mostTriangles) {
    const CleanMesh welded = clean(mesh);
    PageMesh page;
    for (const Vector3& vertex : welded.vertices) page.box.extend(vertex);
    std::vector<TriangleIndices> triangles = welded.triangles;
    if (triangles.size() > mostTriangles) {
        const double cell = cellFor(welded, page.box, mostTriangles);
        triangles = thinned(welded, page.box, cell);
        page.error = cell * std::sqrt(3.0);
    }
    const Vector3 extent = page.box.diagonal();
    page.error += 0.5 / kSteps * extent.norm();
    const auto addPosition = [&](std::uint32_t vertex) {
        std::array<std::uint16_t, 3> position{};
        for (int axis = 0; axis < 3; ++axis) {
            const double share = (welded.vertices[vertex][axis] - page.box.min()[axis]) / extent[axis];
            if (extent[axis] > 0) position[axis] = static_cast<std::uint16_t>(std::lround(kSteps * share));
        }
        page.positions.push_back(position);
    };
    FirstUseOrder numberOf(welded.vertices.size());
    for (TriangleIndices triangle : triangles) {
        for (std::uint32_t& vertex : triangle) vertex = numberOf(vertex, addPosition);
        page.triangles.push_back(triangle);
    }
    return page;
}

}  // namespace clearway::report
