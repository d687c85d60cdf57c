#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>
#include <stdexcept>

#include "bench/peer.h"
#include "core/clock.h"

namespace clearway::testing {
namespace {

template <typename Volume>
struct Trees {
    fcl::BVHModel<Volume> part;
    fcl::BVHModel<Volume> environment;
};

template <typename Volume>
void fill(fcl::BVHModel<Volume>& model, const Mesh& mesh) {
    std::vector<fcl::Triangle> triangles;
    for (const TriangleIndices& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
    model.addSubModel(mesh.vertices, triangles);
    if (model.endModel() != fcl::BVH_OK) throw std::runtime_error("FCL did not build its tree");
}

/// The bytes that FCL's own memUsage counts: nodes, triangles, vertices and the order of the triangles.
template <typename Volume>
std::size_t bytesOf(const fcl::BVHModel<Volume>& model) {
    const auto triangles = static_cast<std::size_t>(model.num_tris);
    return sizeof model + static_cast<std::size_t>(model.getNumBVs()) * sizeof(fcl::BVNode<Volume>) +
           triangles * (sizeof(fcl::Triangle) + sizeof(unsigned)) +
           static_cast<std::size_t>(model.num_vertices) * sizeof(fcl::Vector3d);
}

template <typename Volume>
std::shared_ptr<Trees<Volume>> build(const Mesh& part, const Mesh& environment, Peer& peer) {
    const auto start = Clock::now();
    auto trees = std::make_shared<Trees<Volume>>();
    fill(trees->part, part);
    fill(trees->environment, environment);
    peer.buildSeconds = secondsSince(start);
    peer.bytes = bytesOf(trees->part) + bytesOf(trees->environment);
    return trees;
}

fcl::Transform3d placedAt(const Pose& X_environmentPart) {
    fcl::Transform3d placed = fcl::Transform3d::Identity();
    placed.linear() = X_environmentPart.rotation;
    placed.translation() = X_environmentPart.translation;
    return placed;
}

}  // namespace

Peer makeFclRss(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "FCL RSS";
    const auto trees = build<fcl::RSS<double>>(part, environment, peer);
    peer.distance = [trees](const Pose& X_environmentPart) {
        const fcl::DistanceRequestd request;
        fcl::DistanceResultd result;
        fcl::distance(&trees->part, placedAt(X_environmentPart), &trees->environment,
                      fcl::Transform3d::Identity(), request, result);
        Answer answer;
        answer.value = result.min_distance;
        return answer;
    };
    return peer;
}

Peer makeFclObbRss(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "FCL OBBRSS";
    const auto trees = build<fcl::OBBRSS<double>>(part, environment, peer);
    peer.collides = [trees](const Pose& X_environmentPart) {
        const fcl::CollisionRequestd request;  // one contact, no details
        fcl::CollisionResultd result;
        fcl::collide(&trees->part, placedAt(X_environmentPart), &trees->environment,
                     fcl::Transform3d::Identity(), request, result);
        Answer answer;
        answer.value = result.isCollision();
        return answer;
    };
    return peer;
}

}  // namespace clearway::testing
