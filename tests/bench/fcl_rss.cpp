#include "bench/fcl_rss.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/distance.h>

#include <chrono>
#include <stdexcept>
#include <vector>

namespace clearway::testing {
namespace {

using Clock = std::chrono::steady_clock;
using RssModel = fcl::BVHModel<fcl::RSS<double>>;

void fill(RssModel& model, const Mesh& mesh) {
    std::vector<fcl::Triangle> triangles;
    for (const TriangleIndices& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
    model.addSubModel(mesh.vertices, triangles);
    if (model.endModel() != fcl::BVH_OK) throw std::runtime_error("FCL did not build its tree");
}

}  // namespace

struct FclRssPair::Data {
    RssModel part;
    RssModel environment;
    double buildSeconds = 0;
};

FclRssPair::FclRssPair(const Mesh& part, const Mesh& environment) : data_(std::make_unique<Data>()) {
    const auto start = Clock::now();
    fill(data_->part, part);
    fill(data_->environment, environment);
    data_->buildSeconds = std::chrono::duration<double>(Clock::now() - start).count();
}

FclRssPair::~FclRssPair() = default;

FclRssPair::Answer FclRssPair::distance(const Pose& X_environmentPart) const {
    fcl::Transform3d placed = fcl::Transform3d::Identity();
    placed.linear() = X_environmentPart.rotation;
    placed.translation() = X_environmentPart.translation;
    const fcl::Transform3d fixed = fcl::Transform3d::Identity();
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    const auto start = Clock::now();
    fcl::distance(&data_->part, placed, &data_->environment, fixed, request, result);
    const double nanoseconds = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    return {result.min_distance, nanoseconds};
}

double FclRssPair::buildSeconds() const {
    return data_->buildSeconds;
}

}  // namespace clearway::testing
