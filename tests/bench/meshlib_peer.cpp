#include <MRMesh/MRAABBTree.h>
#include <MRMesh/MRAffineXf3.h>
#include <MRMesh/MRMesh.h>
#include <MRMesh/MRMeshCollide.h>
#include <MRMesh/MRMeshMeshDistance.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "bench/peer.h"

namespace clearway::testing {
namespace {

struct Trees {
    MR::Mesh part;
    MR::Mesh environment;
    tbb::task_arena oneThread{1};  // MeshLib tests pairs of triangles in parallel; other peers use one thread
};

MR::Vector3f vectorOf(const Vector3& v) {
    return MR::Vector3f(MR::Vector3d(v[0], v[1], v[2]));
}

MR::Mesh meshOf(const Mesh& mesh) {
    MR::VertCoords corners;
    for (const Vector3& v : mesh.vertices) corners.push_back(vectorOf(v));
    MR::Triangulation triangles;
    for (const TriangleIndices& t : mesh.triangles) {
        triangles.push_back({MR::VertId(t[0]), MR::VertId(t[1]), MR::VertId(t[2])});
    }
    MR::Mesh made = MR::Mesh::fromTrianglesDuplicatingNonManifoldVertices(std::move(corners), triangles);
    if (made.topology.numValidFaces() != static_cast<int>(mesh.triangles.size())) {
        throw std::runtime_error("MeshLib left out triangles of a mesh that is not manifold");
    }
    made.getAABBTree();  // is built when it is first asked for
    return made;
}

MR::AffineXf3f placedAt(const Pose& X_environmentPart) {
    const Matrix3& R = X_environmentPart.rotation;
    return {MR::Matrix3f(vectorOf(R.row(0)), vectorOf(R.row(1)), vectorOf(R.row(2))),
            vectorOf(X_environmentPart.translation)};
}

}  // namespace

Peer makeMeshLib(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "MeshLib";
    const auto start = std::chrono::steady_clock::now();
    const auto trees = std::make_shared<Trees>();
    trees->part = meshOf(part);
    trees->environment = meshOf(environment);
    peer.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    peer.bytes = trees->part.heapBytes() + trees->environment.heapBytes();
    peer.distance = [trees](const Pose& X_environmentPart) {
        const MR::AffineXf3f placed = placedAt(X_environmentPart);
        return trees->oneThread.execute([&] {
            Answer answer;
            answer.value = std::sqrt(MR::findDistance(trees->environment, trees->part, &placed).distSq);
            return answer;
        });
    };
    peer.collides = [trees](const Pose& X_environmentPart) {
        const MR::AffineXf3f placed = placedAt(X_environmentPart);
        return trees->oneThread.execute([&] {
            Answer answer;
            answer.value = !MR::findCollidingTriangles(trees->environment, trees->part, &placed,
                                                       /*firstIntersectionOnly*/ true)
                                .empty();
            return answer;
        });
    };
    return peer;
}

}  // namespace clearway::testing
