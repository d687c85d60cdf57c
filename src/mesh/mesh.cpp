#include "clearway/mesh.h"

#include <algorithm>
#include <sstream>

#include "clearway/errors.h"

namespace clearway {

Mesh boxMesh(const Box& box, const std::string& name) {
    const bool isFinite = box.min().allFinite() && box.max().allFinite();
    if (!isFinite || !(box.min().array() < box.max().array()).all()) {
        std::ostringstream message;
        message << "box '" << name << "' is from (" << box.min().transpose() << ") to ("
                << box.max().transpose() << "), expected finite corners, the first one below the other";
        throw ArgumentError(message.str());
    }
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {  // bit 0, 1, 2 of a corner: the far end along x, y, z
        mesh.vertices.push_back(box.corner(static_cast<Box::CornerType>(i)));
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    mesh.components = {{name, 0, 12}};
    return mesh;
}

Box boundingBox(const Mesh& mesh) {
    Box box;
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) box.extend(mesh.vertices[vertex]);
    }
    return box;
}

std::size_t componentOf(const std::vector<Component>& components, std::size_t triangle) {
    if (components.empty()) return 0;
    const auto after = std::upper_bound(
        components.begin(), components.end(), triangle,
        [](std::size_t id, const Component& component) { return id < component.firstTriangle; });
    return static_cast<std::size_t>(after - components.begin()) - 1;
}

std::size_t componentOf(const Mesh& mesh, std::size_t triangle) {
    return componentOf(mesh.components, triangle);
}

}  // namespace clearway
