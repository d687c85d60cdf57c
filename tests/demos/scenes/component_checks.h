// Checks of a mesh's components for the tests of the scenes: which of them touch.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"

namespace clearway::testing {

/// One component as a mesh of its own, with only its own vertices.
inline Mesh only(const Mesh& mesh, const Component& component) {
    Mesh alone;
    std::map<std::uint32_t, std::uint32_t> moved;
    for (std::uint32_t i = 0; i < component.triangleCount; ++i) {
        TriangleIndices triangle = mesh.triangles[component.firstTriangle + i];
        for (std::uint32_t& corner : triangle) {
            const auto [at, isNew] = moved.emplace(corner, static_cast<std::uint32_t>(alone.vertices.size()));
            if (isNew) alone.vertices.push_back(mesh.vertices[corner]);
            corner = at->second;
        }
        alone.triangles.push_back(triangle);
    }
    return alone;
}

/// The pairs of components that touch, each as "a x b".
inline std::vector<std::string> touchingComponents(const Mesh& mesh) {
    std::vector<Model> models;
    for (const Component& component : mesh.components) {
        models.push_back(Model::build(only(mesh, component)));
    }
    Workspace workspace;
    std::vector<std::string> touching;
    for (std::size_t i = 0; i < models.size(); ++i) {
        for (std::size_t k = i + 1; k < models.size(); ++k) {
            if (!models[i].box().intersects(models[k].box())) continue;
            if (!collides(models[i], models[k], {}, workspace)) continue;
            touching.push_back(mesh.components[i].name + " x " + mesh.components[k].name);
        }
    }
    return touching;
}

}  // namespace clearway::testing
