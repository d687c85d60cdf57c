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
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// A triangle that would make the surface non-manifold gets corners of its own.
Surface surfaceOf(const Mesh& mesh) {
    using Vertex = Surface::Vertex_index;
    Surface surface;
    for (const Vector3& v : mesh.vertices) surface.add_vertex({v[0], v[1], v[2]});
    for (const TriangleIndices& t : mesh.triangles) {
        if (surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) != Surface::null_face()) continue;
        std::array<Vertex, 3> own;
        for (int i = 0; i < 3; ++i) {
            const Kernel::Point_3 corner = surface.point(Vertex(t[i]));  // a new vertex may move all points
            own[i] = surface.add_vertex(corner);
        }
        surface.add_face(own[0], own[1], own[2]);
    }
    return surface;
}

/// The detection keeps pointers to the surfaces.
struct CgalTrees {
    Surface part;
    Surface environment;
    CGAL::Rigid_triangle_mesh_collision_detection<Surface> detection;
};

CGAL::Aff_transformation_3<Kernel> placedAt(const Pose& pose) {
    const Matrix3& R = pose.rotation;
    const Vector3& p = pose.translation;
    return {R(0, 0), R(0, 1), R(0, 2), p[0],    R(1, 0), R(1, 1),
            R(1, 2), p[1],    R(2, 0), R(2, 1), R(2, 2), p[2]};
}

}  // namespace

Peer makeCgal(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "CGAL";
    const auto start = std::chrono::steady_clock::now();
    const auto trees = std::make_shared<CgalTrees>();
    trees->part = surfaceOf(part);
    trees->environment = surfaceOf(environment);
    const std::size_t partId = trees->detection.add_mesh(trees->part);
    const std::size_t environmentId = trees->detection.add_mesh(trees->environment);
    peer.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    peer.collides = [trees, partId, environmentId](const Pose& X_environmentPart) {
        trees->detection.set_transformation(partId, placedAt(X_environmentPart));
        Answer answer;
        // Asked for the environment, CGAL turns the part's boxes alone, which takes half the time.
        answer.value = !trees->detection.get_all_intersections(environmentId, std::array{partId}).empty();
        return answer;
    };
    return peer;
}

}  // namespace clearway::testing
