#include "support/convex_hull.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace clearway::testing {

namespace {

struct Face {
    TriangleIndices corners;
    Vector3 normal;
    double offset;
};

struct Cloud {
    const std::vector<Vector3>& points;
    double tolerance;

    Face face(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Vector3 normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
        return {{a, b, c}, normal, normal.dot(points[a])};
    }
    bool sees(const Vector3& point, const Face& face) const {
        return face.normal.dot(point) - face.offset > tolerance;
    }
    /// The point with the largest measure.
    template <class Measure>
    std::uint32_t farthest(const Measure& measure) const {
        std::uint32_t best = 0;
        for (std::uint32_t i = 1; i < points.size(); ++i) {
            if (measure(points[i]) > measure(points[best])) best = i;
        }
        if (!(measure(points[best]) > tolerance)) throw std::invalid_argument("all points lie in a plane");
        return best;
    }
};

std::vector<Face> firstTetrahedron(const Cloud& cloud) {
    const std::vector<Vector3>& points = cloud.points;
    const std::uint32_t a = 0;
    const std::uint32_t b = cloud.farthest([&](const Vector3& p) { return (p - points[a]).norm(); });
    const Vector3 line = (points[b] - points[a]).normalized();
    const std::uint32_t c =
        cloud.farthest([&](const Vector3& p) { return (p - points[a]).cross(line).norm(); });
    const Vector3 normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
    const std::uint32_t d =
        cloud.farthest([&](const Vector3& p) { return std::abs(normal.dot(p - points[a])); });
    const bool above = normal.dot(points[d] - points[a]) > 0;
    const std::uint32_t b2 = above ? c : b, c2 = above ? b : c;  // a, b2, c2 then turn away from d
    return {cloud.face(a, b2, c2), cloud.face(b2, a, d), cloud.face(c2, b2, d), cloud.face(a, c2, d)};
}

}  // namespace

Mesh convexHull(const std::vector<Vector3>& points) {
    if (points.empty()) throw std::invalid_argument("no points");
    Box box;
    for (const Vector3& point : points) box.extend(point);
    const Cloud cloud{points, 1e-9 * box.diagonal().norm()};
    std::vector<Face> faces = firstTetrahedron(cloud);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const auto visible = std::partition(faces.begin(), faces.end(),
                                            [&](const Face& face) { return !cloud.sees(points[i], face); });
        std::set<std::pair<std::uint32_t, std::uint32_t>> rim;
        for (auto face = visible; face != faces.end(); ++face) {
            for (int k = 0; k < 3; ++k) rim.insert({face->corners[k], face->corners[(k + 1) % 3]});
        }
        faces.erase(visible, faces.end());
        for (const auto& [from, to] : rim) {
            if (rim.count({to, from}) == 0) faces.push_back(cloud.face(from, to, i));
        }
    }
    Mesh hull;
    hull.vertices = points;
    for (const Face& face : faces) hull.triangles.push_back(face.corners);
    return hull;
}

double signedVolume(const Mesh& mesh) {
    return signedVolume(mesh, {"", 0, static_cast<std::uint32_t>(mesh.triangles.size())});
}

double signedVolume(const Mesh& mesh, const Component& component) {
    double six = 0;
    const Vector3 origin = mesh.vertices[mesh.triangles[component.firstTriangle][0]];
    for (std::uint32_t i = component.firstTriangle; i < component.firstTriangle + component.triangleCount;
         ++i) {
        const TriangleIndices& t = mesh.triangles[i];
        six += (mesh.vertices[t[0]] - origin)
                   .dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
    }
    return six / 6;
}

}  // namespace clearway::testing
