// FCL as OMPL users plug it in: behind a state validity checker, and behind the continuous motion validator
// that OMPL.app sets up.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include <memory>

#include "clearway/mesh.h"
#include "clearway/planning/state_to_pose.h"

namespace clearway::testing {

struct FclMeshes;

/// OBBRSS trees, as OMPL.app builds them.
std::shared_ptr<const FclMeshes> makeFclMeshes(const Mesh& part, const Mesh& environment);

/// A state is valid if it is within the bounds and FCL's collide finds no contact; collide ends at the first
/// contact.
class FclValidityChecker : public ompl::base::StateValidityChecker {
  public:
    FclValidityChecker(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const FclMeshes> meshes);
    bool isValid(const ompl::base::State* state) const override;

  private:
    std::shared_ptr<const FclMeshes> meshes_;
    planning::StateToPose stateToPose_;
};

/// Checks the end state, then asks FCL's continuousCollide with OMPL.app's settings: conservative advancement
/// of a screw motion, 10 iterations, contact times to 1e-4.
class FclContinuousValidator : public ompl::base::MotionValidator {
  public:
    FclContinuousValidator(const ompl::base::SpaceInformationPtr& si,
                           std::shared_ptr<const FclMeshes> meshes);
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;
    /// Unlike OMPL.app's validator, this one sets lastValid to s1 for every invalid motion.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override;

  private:
    std::shared_ptr<const FclMeshes> meshes_;
    planning::StateToPose stateToPose_;
};

}  // namespace clearway::testing
