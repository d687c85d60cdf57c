// Small scenes to move a part in, with the OMPL objects they need and the oracle.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <memory>
#include <string>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "clearway/problem.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

namespace clearway::testing {

struct MotionScene {
    MotionScene(std::string name, Space kind, const Mesh& thePart, const Mesh& theEnvironment,
                const Box& bounds, double margin, std::vector<PartState> path, double spread = 5);

    ompl::base::ScopedState<> state(const PartState& state) const;
    PartState stateOf(const ompl::base::State* state) const;

    /// A state near a random place of the path, off it by up to `distance` and `angle`.
    PartState nearPath(Random& random, double distance, double angle) const;

    /// The clearance by the oracle: its distance less the margin.
    double trueClearance(const ompl::base::State* state) const;

    /// The clearance of a motion's state at a time: s2 for time 1, otherwise interpolated.
    double trueClearance(const ompl::base::State* s1, const ompl::base::State* s2, double time) const;

    /// The least clearance along the motion up to a time (1 is s2). It is judged at the `judged` poses where
    /// the library finds the least distance, among `poses` poses and those that a search between them adds.
    double leastTrueClearance(const ompl::base::State* s1, const ompl::base::State* s2, double until,
                              int poses, int judged) const;

    std::string name;
    Space kind;
    Mesh partMesh, environmentMesh;
    MeshOracle oracle;
    Scene scene;
    std::vector<PartState> path;
    double spread;  ///< so far off the path are states of random motions
    ompl::base::StateSpacePtr space;
    ompl::base::SpaceInformationPtr si;
    std::shared_ptr<planning::ValidityChecker> checker;
    std::shared_ptr<planning::MotionValidator> validator;  ///< both belong to si
    std::shared_ptr<planning::MotionValidator> close;      ///< has a hundredth of the other's least interval
};

/// The window in SE(3) and SE(2), the small tunnel-console, boxes and puzzle, with and without margins.
std::vector<std::shared_ptr<const MotionScene>> motionScenes();

/// A screw in its nut, whose path is along the thread.
std::shared_ptr<const MotionScene> screwMotionScene();

}  // namespace clearway::testing
