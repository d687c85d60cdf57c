#include "bench/fcl_planning.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <stdexcept>

namespace clearway::testing {

namespace ob = ompl::base;

struct FclMeshes {
    fcl::BVHModel<fcl::OBBRSSd> part, environment;
};

namespace {

void fill(fcl::BVHModel<fcl::OBBRSSd>& model, const Mesh& mesh) {
    std::vector<fcl::Triangle> triangles;
    for (const TriangleIndices& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
    model.addSubModel(mesh.vertices, triangles);
    if (model.endModel() != fcl::BVH_OK) throw std::runtime_error("FCL did not build its tree");
    model.computeLocalAABB();
}

fcl::Transform3d fclPose(const Pose& X_environmentPart) {
    fcl::Transform3d placed = fcl::Transform3d::Identity();
    placed.linear() = X_environmentPart.rotation;
    placed.translation() = X_environmentPart.translation;
    return placed;
}

}  // namespace

std::shared_ptr<const FclMeshes> makeFclMeshes(const Mesh& part, const Mesh& environment) {
    auto meshes = std::make_shared<FclMeshes>();
    fill(meshes->part, part);
    fill(meshes->environment, environment);
    return meshes;
}

FclValidityChecker::FclValidityChecker(const ob::SpaceInformationPtr& si,
                                       std::shared_ptr<const FclMeshes> meshes)
    : ob::StateValidityChecker(si),
      meshes_(std::move(meshes)),
      stateToPose_(planning::stateToPose(*si->getStateSpace())) {}

bool FclValidityChecker::isValid(const ob::State* state) const {
    if (!si_->satisfiesBounds(state)) return false;
    const fcl::CollisionRequestd request;  // one contact, no details
    fcl::CollisionResultd result;
    return fcl::collide(&meshes_->part, fclPose(stateToPose_(state)), &meshes_->environment,
                        fcl::Transform3d::Identity(), request, result) == 0;
}

FclContinuousValidator::FclContinuousValidator(const ob::SpaceInformationPtr& si,
                                               std::shared_ptr<const FclMeshes> meshes)
    : ob::MotionValidator(si),
      meshes_(std::move(meshes)),
      stateToPose_(planning::stateToPose(*si->getStateSpace())) {}

bool FclContinuousValidator::checkMotion(const ob::State* s1, const ob::State* s2) const {
    if (!si_->isValid(s2)) return false;
    const fcl::ContinuousCollisionRequestd request(10, 1e-4, fcl::CCDM_SCREW, fcl::GST_LIBCCD,
                                                   fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResultd result;
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    fcl::continuousCollide(&meshes_->part, fclPose(stateToPose_(s1)), fclPose(stateToPose_(s2)),
                           &meshes_->environment, still, still, request, result);
    return !result.is_collide;
}

bool FclContinuousValidator::checkMotion(const ob::State* s1, const ob::State* s2,
                                         std::pair<ob::State*, double>& lastValid) const {
    if (checkMotion(s1, s2)) return true;
    lastValid.second = 0;
    if (lastValid.first != nullptr) si_->copyState(lastValid.first, s1);
    return false;
}

}  // namespace clearway::testing
