#include "mesh/component_mesh.h"

#include <algorithm>

namespace clearway {

std::vector<Component> componentsOf(const Mesh& mesh) {
    if (!mesh.components.empty()) return mesh.components;
    return {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
}

Mesh meshOfComponents(const Mesh& mesh, const std::vector<std::size_t>& components) {
    const std::vector<Component> all = componentsOf(mesh);
    Mesh result;
    result.origin = mesh.origin;
    std::vector<std::uint32_t> used;
    for (const std::size_t index : components) {
        const Component& component = all[index];
        result.components.push_back(
            {component.name, static_cast<std::uint32_t>(result.triangles.size()), component.triangleCount});
        const auto first = mesh.triangles.begin() + component.firstTriangle;
        result.triangles.insert(result.triangles.end(), first, first + component.triangleCount);
    }
    for (const TriangleIndices& triangle : result.triangles) {
        used.insert(used.end(), triangle.begin(), triangle.end());
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t vertex : used) result.vertices.push_back(mesh.vertices[vertex]);
    for (TriangleIndices& triangle : result.triangles) {
        for (std::uint32_t& vertex : triangle) {
            const auto place = std::lower_bound(used.begin(), used.end(), vertex);
            vertex = static_cast<std::uint32_t>(place - used.begin());
        }
    }
    return result;
}

}  // namespace clearway
