#include "mesh/save_parts.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "mesh/check.h"

namespace clearway {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::array<float, 3> rounded(const Mesh& mesh, std::size_t triangle, const Vector3& vertex) {
    if (vertex.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
        std::ostringstream message;
        message << nameOfTriangle(mesh, triangle) << " has a vertex at (" << vertex.x() << ", " << vertex.y()
                << ", " << vertex.z() << "), expected coordinates within a float's range to write";
        throw std::invalid_argument(message.str());
    }
    return {static_cast<float>(vertex.x()), static_cast<float>(vertex.y()), static_cast<float>(vertex.z())};
}

/// numbers: for each vertex of the mesh its number in the part; kNone for all, before and after.
SavePart partOf(const Mesh& mesh, const Component& component, std::vector<std::uint32_t>& numbers) {
    SavePart part;
    part.name = component.name;
    part.triangles.reserve(component.triangleCount);
    const std::size_t end = std::size_t(component.firstTriangle) + component.triangleCount;
    for (std::size_t id = component.firstTriangle; id < end; ++id) {
        TriangleIndices triangle;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t vertex = mesh.triangles[id][i];
            if (numbers[vertex] == kNone) {
                numbers[vertex] = static_cast<std::uint32_t>(part.vertices.size());
                part.vertices.push_back(rounded(mesh, id, mesh.vertices[vertex]));
            }
            triangle[i] = numbers[vertex];
        }
        part.triangles.push_back(triangle);
    }
    for (std::size_t id = component.firstTriangle; id < end; ++id) {
        for (const std::uint32_t vertex : mesh.triangles[id]) numbers[vertex] = kNone;
    }
    return part;
}

}  // namespace

std::vector<SavePart> savePartsOf(const Mesh& mesh, const std::string& namelessName) {
    requireSoundMesh(mesh);
    std::vector<Component> components = mesh.components;
    if (components.empty()) components.push_back({"", 0, static_cast<std::uint32_t>(mesh.triangles.size())});
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), kNone);
    std::vector<SavePart> parts;
    for (const Component& component : components) {
        if (component.triangleCount == 0) continue;
        parts.push_back(partOf(mesh, component, numbers));
        if (parts.back().name.empty()) parts.back().name = namelessName;
    }
    return parts;
}

}  // namespace clearway
