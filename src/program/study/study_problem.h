// A problem of the study: its meshes, from which scenes of other trees are built again and again.
#pragma once

#include <memory>
#include <string>

#include "clearway/build_options.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/study/engine.h"

namespace clearway::study {

struct StudyProblem {
    std::string name;  ///< names its rows and files: letters, digits, - . and _
    Problem problem;
    Mesh part;
    ObstacleGroups obstacles;
    std::shared_ptr<const Solids> partSolids;  ///< null unless an obstacle is solid
    std::vector<Pose> replayPoses;             ///< to ask about in the tables; empty: those of recorded calls

    std::size_t environmentTriangles() const;

    /// Tells whether it is the same problem again: of its meshes, ends, bounds and margins, and what it says
    /// to planners.
    std::string fingerprint() const;
};

/// As far as planning can need the environment, also with an objective of clearance. cache: folder for built
/// trees; empty: none.
Scene buildScene(const StudyProblem& problem, const Engine& engine, const std::string& cache);

}  // namespace clearway::study
