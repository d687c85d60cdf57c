#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/distance.h>

#include <memory>
#include <stdexcept>

#include "bench/peer.h"
#include "core/clock.h"

namespace clearway::testing {
namespace {

using CoalModel = coal::BVHModel<coal::OBBRSS>;

struct Trees {
    CoalModel part;
    CoalModel environment;
};

void fill(CoalModel& model, const Mesh& mesh) {
    std::vector<coal::Vec3s> vertices(mesh.vertices.begin(), mesh.vertices.end());
    std::vector<coal::Triangle> triangles;
    for (const TriangleIndices& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    model.beginModel(static_cast<unsigned>(triangles.size()), static_cast<unsigned>(vertices.size()));
    model.addSubModel(vertices, triangles);
    if (model.endModel() != coal::BVH_OK) throw std::runtime_error("Coal did not build its tree");
}

/// The bytes that Coal's own memUsage counts: volumes, triangles and vertices. It returns an int, too small for large meshes.
std::size_t bytesOf(const CoalModel& model) {
    return sizeof model + static_cast<std::size_t>(model.getNumBVs()) * sizeof(coal::OBBRSS) +
           static_cast<std::size_t>(model.num_tris) * sizeof(coal::Triangle) +
           static_cast<std::size_t>(model.num_vertices) * sizeof(coal::Vec3s);
}

coal::Transform3s placedAt(const Pose& X_environmentPart) {
    return {X_environmentPart.rotation, X_environmentPart.translation};
}

}  // namespace

Peer makeCoal(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "Coal OBBRSS";
    const auto start = Clock::now();
    const auto trees = std::make_shared<Trees>();
    fill(trees->part, part);
    fill(trees->environment, environment);
    peer.buildSeconds = secondsSince(start);
    peer.bytes = bytesOf(trees->part) + bytesOf(trees->environment);
    peer.distance = [trees](const Pose& X_environmentPart) {
        const coal::DistanceRequest request(/*enable_nearest_points*/ false,
                                            /*enable_signed_distance*/ false);
        coal::DistanceResult result;
        coal::distance(&trees->part, placedAt(X_environmentPart), &trees->environment, coal::Transform3s(),
                       request, result);
        Answer answer;
        answer.value = result.min_distance;
        return answer;
    };
    peer.collides = [trees](const Pose& X_environmentPart) {
        const coal::CollisionRequest request(coal::NO_REQUEST, /*num_max_contacts*/ 1);
        coal::CollisionResult result;
        coal::collide(&trees->part, placedAt(X_environmentPart), &trees->environment, coal::Transform3s(),
                      request, result);
        Answer answer;
        answer.value = result.isCollision();
        return answer;
    };
    return peer;
}

}  // namespace clearway::testing
