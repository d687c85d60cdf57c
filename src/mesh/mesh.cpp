#include "clearway/mesh.h"

#include <algorithm>

namespace clearway {

Box boundingBox(const Mesh& mesh) {
    Box box;
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) box.extend(mesh.vertices[vertex]);
    }
    return box;
}

std::size_t componentOf(const Mesh& mesh, std::size_t triangle) {
    if (mesh.components.empty()) return 0;
    const auto after = std::upper_bound(
        mesh.components.begin(), mesh.components.end(), triangle,
        [](std::size_t id, const Component& component) { return id < component.firstTriangle; });
    return static_cast<std::size_t>(after - mesh.components.begin()) - 1;
}

}  // namespace clearway
