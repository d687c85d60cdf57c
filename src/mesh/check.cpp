#include "mesh/check.h"

#include <cstdint>
#include <sstream>
#include <stdexcept>

namespace clearway {

namespace {

std::string inFile(const Mesh& mesh) {
    return mesh.origin.file.empty() ? std::string() : " in '" + mesh.origin.file + "'";
}

void requireComponents(const Mesh& mesh) {
    if (mesh.components.empty()) return;
    std::uint64_t expectedFirst = 0;
    for (std::size_t i = 0; i < mesh.components.size(); ++i) {
        const Component& component = mesh.components[i];
        if (component.firstTriangle != expectedFirst) {
            std::ostringstream message;
            message << "component " << i << " ('" << component.name << "')" << inFile(mesh)
                    << " begins at triangle " << component.firstTriangle << ", expected " << expectedFirst
                    << ", the end of the one before";
            throw std::invalid_argument(message.str());
        }
        expectedFirst += component.triangleCount;
    }
    if (expectedFirst != mesh.triangles.size()) {
        std::ostringstream message;
        message << "the components" << inFile(mesh) << " hold " << expectedFirst << " triangles, expected "
                << mesh.triangles.size() << ", all of the mesh";
        throw std::invalid_argument(message.str());
    }
}

[[noreturn]] void refuseIndex(const Mesh& mesh, std::size_t triangle, std::uint32_t vertex) {
    std::ostringstream message;
    message << nameOfTriangle(mesh, triangle) << " refers to vertex " << vertex << ", expected one below "
            << mesh.vertices.size();
    throw std::invalid_argument(message.str());
}

[[noreturn]] void refuseVertex(const Mesh& mesh, std::size_t triangle, const Vector3& vertex) {
    std::ostringstream message;
    message << nameOfTriangle(mesh, triangle) << " has a vertex at (" << vertex.x() << ", " << vertex.y()
            << ", " << vertex.z() << "), expected finite coordinates";
    throw std::invalid_argument(message.str());
}

}  // namespace

std::string nameOfTriangle(const Mesh& mesh, std::size_t triangle) {
    std::string name = "triangle " + std::to_string(triangle);
    if (!mesh.components.empty()) {
        name += " of component '" + mesh.components[componentOf(mesh, triangle)].name + "'";
    }
    return name + inFile(mesh);
}

void requireSoundMesh(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("the mesh" + inFile(mesh) + " holds 0 triangles, expected at least 1");
    }
    requireComponents(mesh);
    for (std::size_t id = 0; id < mesh.triangles.size(); ++id) {
        for (const std::uint32_t vertex : mesh.triangles[id]) {
            if (vertex >= mesh.vertices.size()) refuseIndex(mesh, id, vertex);
            if (!mesh.vertices[vertex].allFinite()) refuseVertex(mesh, id, mesh.vertices[vertex]);
        }
    }
}

}  // namespace clearway
