#include "program/render/surface.h"

#include <Eigen/Geometry>
#include <cmath>

#include "mesh/clean.h"

namespace clearway::render {

namespace {

constexpr float kRoundCosine = 0.82f;  // cosine of 35 degrees; flatter edges belong to round surfaces

/// The triangles at each vertex: entries [first[v], first[v + 1]) belong to vertex v.
struct Fans {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> triangles;
};

Fans fansOf(const Surface& surface) {
    Fans fans;
    fans.first.assign(surface.vertices.size() + 1, 0);
    for (const TriangleIndices& triangle : surface.triangles) {
        for (const std::uint32_t vertex : triangle) ++fans.first[vertex + 1];
    }
    for (std::size_t v = 1; v < fans.first.size(); ++v) fans.first[v] += fans.first[v - 1];
    fans.triangles.resize(3 * surface.triangles.size());
    std::vector<std::uint32_t> next(fans.first.begin(), fans.first.end() - 1);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        for (const std::uint32_t vertex : surface.triangles[t]) fans.triangles[next[vertex]++] = t;
    }
    return fans;
}

/// A normal whose length is twice the area of the triangle.
Vector3f areaNormal(const Surface& surface, const TriangleIndices& triangle) {
    const Vector3f& a = surface.vertices[triangle[0]];
    return (surface.vertices[triangle[1]] - a).cross(surface.vertices[triangle[2]] - a);
}

/// Averages, by area, the normals of the triangles around each corner that no crease separates from its own.
void addNormals(Surface& surface) {
    const Fans fans = fansOf(surface);
    std::vector<Vector3f> flat(surface.triangles.size()), unit(surface.triangles.size());
    for (std::size_t t = 0; t < flat.size(); ++t) {
        flat[t] = areaNormal(surface, surface.triangles[t]);
        unit[t] = flat[t].stableNormalized();
    }
    surface.normals.resize(flat.size());
    for (std::size_t t = 0; t < flat.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = surface.triangles[t][corner];
            Vector3f sum = flat[t];
            for (std::uint32_t i = fans.first[vertex]; i < fans.first[vertex + 1]; ++i) {
                const std::uint32_t other = fans.triangles[i];
                if (other != t && unit[t].dot(unit[other]) > kRoundCosine) sum += flat[other];
            }
            surface.normals[t][corner] = sum.stableNormalized();
        }
    }
}

struct Corner {
    Vector3f point;
    Vector3f normal;
};

/// Appends the convex polygon as a fan.
void append(const std::vector<Corner>& polygon, std::uint32_t component, Surface& surface) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const auto first = static_cast<std::uint32_t>(surface.vertices.size());
        for (const Corner& corner : {polygon[0], polygon[i - 1], polygon[i]})
            surface.vertices.push_back(corner.point);
        surface.triangles.push_back({first, first + 1, first + 2});
        surface.normals.push_back({polygon[0].normal, polygon[i - 1].normal, polygon[i].normal});
        surface.components.push_back(component);
    }
}

/// The polygon that remains of a triangle below the plane.
std::vector<Corner> clipped(const std::array<Corner, 3>& corners, const std::array<float, 3>& above) {
    std::vector<Corner> polygon;
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        if (above[i] <= 0) polygon.push_back(corners[i]);
        if ((above[i] <= 0) == (above[next] <= 0)) continue;
        const float t = above[i] / (above[i] - above[next]);
        polygon.push_back({corners[i].point + t * (corners[next].point - corners[i].point),
                           corners[i].normal + t * (corners[next].normal - corners[i].normal)});
    }
    return polygon;
}

}  // namespace

Surface surfaceOf(const Mesh& mesh, const Vector3& origin, double scale) {
    const CleanMesh welded = clean(mesh);
    Surface surface;
    surface.vertices.reserve(welded.vertices.size());
    for (const Vector3& vertex : welded.vertices)
        surface.vertices.push_back((scale * (vertex - origin)).cast<float>());
    surface.triangles = welded.triangles;
    surface.components.reserve(welded.triangles.size());
    for (const std::uint32_t id : welded.triangleIds)
        surface.components.push_back(static_cast<std::uint32_t>(componentOf(mesh, id)));
    addNormals(surface);
    return surface;
}

Surface cutBy(const CutPlane& plane, const Surface& surface) {
    const Vector3f normal = plane.normal.cast<float>();
    const auto offset = static_cast<float>(plane.offset);
    Surface left;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<Corner, 3> corners;
        std::array<float, 3> above;
        for (int i = 0; i < 3; ++i) {
            corners[i] = {surface.vertices[surface.triangles[t][i]], surface.normals[t][i]};
            above[i] = normal.dot(corners[i].point) - offset;
        }
        append(clipped(corners, above), surface.components[t], left);
    }
    return left;
}

Surface tubeAlong(const std::vector<Vector3f>& points, float radius) {
    constexpr int kSides = 12;
    Surface tube;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector3f along = (points[i + 1] - points[i]).stableNormalized();
        if (along.isZero()) continue;
        const Vector3f across = along.unitOrthogonal(), third = along.cross(across);
        const auto outward = [&](int side) -> Vector3f {
            const auto angle = static_cast<float>(2 * M_PI * side / kSides);
            return std::cos(angle) * across + std::sin(angle) * third;
        };
        for (int side = 0; side < kSides; ++side) {
            const Vector3f u = outward(side), v = outward(side + 1);
            append({{points[i] + radius * u, u},
                    {points[i] + radius * v, v},
                    {points[i + 1] + radius * v, v},
                    {points[i + 1] + radius * u, u}},
                   static_cast<std::uint32_t>(i), tube);
        }
    }
    return tube;
}

}  // namespace clearway::render
