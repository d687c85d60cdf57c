#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <chrono>
#include <memory>

#include "bench/peer.h"

namespace clearway::testing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

SurfaceMesh surfaceOf(const Mesh& mesh) {
    SurfaceMesh surface;
    for (const Vector3& v : mesh.vertices) surface.add_vertex({v.x(), v.y(), v.z()});
    for (const TriangleIndices& t : mesh.triangles) {
        using Vertex = SurfaceMesh::Vertex_index;
        if (surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) != SurfaceMesh::null_face()) continue;
        // A triangle that would make the surface non-manifold has corners of its own.
        const auto corner = [&](int i) { return surface.add_vertex(surface.point(Vertex(t[i]))); };
        surface.add_face(corner(0), corner(1), corner(2));
    }
    return surface;
}

struct Trees {
    SurfaceMesh part;
    SurfaceMesh environment;
    CGAL::Rigid_triangle_mesh_collision_detection<SurfaceMesh> detection;
};

CGAL::Aff_transformation_3<Kernel> placedAt(const Pose& pose) {
    const Matrix3& R = pose.rotation;
    const Vector3& p = pose.translation;
    return {R(0, 0), R(0, 1), R(0, 2), p.x(),   R(1, 0), R(1, 1),
            R(1, 2), p.y(),   R(2, 0), R(2, 1), R(2, 2), p.z()};
}

}  // namespace

Peer makeCgal(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "CGAL";
    const auto start = std::chrono::steady_clock::now();
    const auto trees = std::make_shared<Trees>();
    trees->part = surfaceOf(part);
    trees->environment = surfaceOf(environment);
    const std::size_t partId = trees->detection.add_mesh(trees->part);
    const std::size_t environmentId = trees->detection.add_mesh(trees->environment);
    peer.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    peer.collides = [=](const Pose& X_environmentPart) {
        Answer answer;
        trees->detection.set_transformation(partId, placedAt(X_environmentPart));
        answer.value = !trees->detection.get_all_intersections(partId, std::array{environmentId}).empty();
        return answer;
    };
    return peer;
}

}  // namespace clearway::testing
