// Meshes to build trees over, cleaned by hand: welded vertices, ids that differ from positions.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/clean.h"
#include "support/random_meshes.h"

namespace clearway::testing {

using Corners = std::array<Vector3, 3>;

/// Welds equal corners. Ids are 7 more than the positions, so that the two cannot be mixed up.
inline CleanMesh cleanMeshOf(const std::vector<Corners>& triangles) {
    CleanMesh mesh;
    std::map<std::array<double, 3>, std::uint32_t> indices;
    for (const Corners& corners : triangles) {
        TriangleIndices triangle{};
        for (int i = 0; i < 3; ++i) {
            const Vector3& p = corners[i];
            const auto [entry, isNew] =
                indices.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (isNew) mesh.vertices.push_back(p);
            triangle[i] = entry->second;
        }
        mesh.triangleIds.push_back(static_cast<std::uint32_t>(mesh.triangles.size()) + 7);
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

/// Welds the vertices of a mesh in which vertices may repeat.
inline CleanMesh weldedMesh(const Mesh& mesh) {
    std::vector<Corners> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    return cleanMeshOf(triangles);
}

/// Small triangles anywhere in a cube, none touching another.
inline std::vector<Corners> soup(int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Corners> triangles;
    for (int i = 0; i < count; ++i) {
        const Vector3 at = random.inBox(1);
        const Vector3 a = at + random.inBox(0.1);
        const Vector3 b = at + random.inBox(0.1);
        triangles.push_back({a, b, at + random.inBox(0.1)});
    }
    return triangles;
}

/// A bent sheet of two triangles a cell. The cells are slivers, as in CAD tessellations.
inline std::vector<Corners> bentSheet(int columns, int rows) {
    const auto point = [&](int i, int j) {
        const double angle = 2.0 * i / columns;
        return Vector3(std::sin(angle), std::cos(angle), 20.0 * j / rows);
    };
    std::vector<Corners> triangles;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            triangles.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
            triangles.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
        }
    }
    return triangles;
}

inline std::vector<Corners> transformed(std::vector<Corners> triangles, double scale, const Vector3& shift) {
    for (Corners& corners : triangles) {
        for (Vector3& corner : corners) corner = scale * corner + shift;
    }
    return triangles;
}

struct SampleMesh {
    std::string name;
    CleanMesh mesh;
};

/// Hard inputs: no extent in some or all directions, coinciding centroids, any scale and offset.
inline std::vector<SampleMesh> degenerateMeshes() {
    const Vector3 o = Vector3::Zero();
    const Vector3 x = Vector3::UnitX();
    const Vector3 y = Vector3::UnitY();
    const Vector3 z = Vector3::UnitZ();
    std::vector<Corners> collinear;
    std::vector<Corners> points;
    std::vector<Corners> concentric;
    std::vector<Corners> doubling;
    for (int i = 0; i < 40; ++i) {
        collinear.push_back({i * x, (i + 1) * x, (i + 0.25) * x});
        points.push_back({i * y, i * y, i * y});
        const double angle = 0.1 * i;
        const Vector3 spoke = (1 + i) * Vector3(std::cos(angle), std::sin(angle), 0);
        concentric.push_back({spoke, -spoke, o});
        doubling.push_back(
            {std::ldexp(1.0, i) * x, std::ldexp(1.0, i) * (x + y), std::ldexp(1.0, i) * (x + z)});
    }
    std::vector<SampleMesh> meshes;
    meshes.push_back({"one triangle", cleanMeshOf({{x, y, z}})});
    meshes.push_back({"one point", cleanMeshOf({{z, z, z}})});
    meshes.push_back({"identical triangles", cleanMeshOf(std::vector<Corners>(50, {x, y, z}))});
    meshes.push_back({"identical points", cleanMeshOf(std::vector<Corners>(50, {x, x, x}))});
    meshes.push_back({"collinear", cleanMeshOf(collinear)});
    meshes.push_back({"point triangles", cleanMeshOf(points)});
    meshes.push_back({"coinciding centroids", cleanMeshOf(concentric)});
    meshes.push_back({"each twice as far", cleanMeshOf(doubling)});
    meshes.push_back({"needle", cleanMeshOf({{o, 1000 * x, 1000 * x + 1e-9 * y}, {o, 1000 * x, 1e-9 * z}})});
    meshes.push_back({"huge", cleanMeshOf(transformed(soup(60, 1), 0x1p200, o))});
    meshes.push_back({"tiny", cleanMeshOf(transformed(soup(60, 2), 0x1p-200, o))});
    meshes.push_back({"far away", cleanMeshOf(transformed(soup(60, 3), 1, {1e9, -1e9, 3e8}))});
    std::vector<Corners> clusters;  // far smaller than floats about the mesh's middle can show
    for (std::uint64_t i = 0; i < 12; ++i) {
        const Vector3 place = Random(i + 40).inBox(1);
        for (const Corners& triangle : transformed(soup(20, i + 4), 1e-9, place))
            clusters.push_back(triangle);
    }
    meshes.push_back({"tiny clusters", cleanMeshOf(clusters)});
    return meshes;
}

}  // namespace clearway::testing
