// Answers about the plain numbers of OMPL's states, for python/clearway/ompl.py: no other extension can take
// the types of OMPL's Python bindings.
#include <pybind11/pybind11.h>

#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "python/bindings.h"
#include "python/released_gil.h"
#include "python/scenes.h"

namespace clearway::python {
namespace {

Pose poseAt(const Vector3& position, double qx, double qy, double qz, double qw) {
    return toPose(Eigen::Quaterniond(qw, qx, qy, qz), position);
}

const char* nameOf(SweepVerdict verdict) {
    switch (verdict) {
        case SweepVerdict::kCertified:
            return "certified";
        case SweepVerdict::kContact:
            return "contact";
        case SweepVerdict::kUndecided:
            break;
    }
    return "undecided";
}

/// An answer as Python gets it: the verdict's name, and the time until which the motion is free.
std::pair<const char*, double> followed(const MotionAnswer& answer) {
    return {nameOf(answer.verdict), answer.certifiedUntil};
}

}  // namespace

void bindStates(py::module_& module) {
    module.def(
        "is_free_at_state",
        [](const PyScene& scene, double x, double y, double z, double qx, double qy, double qz, double qw) {
            return scene.clearance.isFree(poseAt({x, y, z}, qx, qy, qz, qw));
        },
        WithoutGil(), R"(Scene.is_free at a position and a quaternion, which is normalised first.)");
    module.def(
        "clearance_at_state",
        [](const PyScene& scene, double x, double y, double z, double qx, double qy, double qz, double qw) {
            return scene.clearance.at(poseAt({x, y, z}, qx, qy, qz, qw)).lower;
        },
        WithoutGil(), R"(Scene.clearance at a position and a quaternion, which is normalised first.)");
    module.def(
        "certify_se3_motion",
        [](const PyScene& scene, double x1, double y1, double z1, double qx1, double qy1, double qz1,
           double qw1, double x2, double y2, double z2, double qx2, double qy2, double qz2, double qw2) {
            return nameOf(certifySe3Motion(scene.clearance, {{x1, y1, z1}, {qw1, qx1, qy1, qz1}},
                                           {{x2, y2, z2}, {qw2, qx2, qy2, qz2}}));
        },
        WithoutGil(),
        R"(Certifies both states and all poses that OMPL's SE(3) interpolates between them. Returns "certified", "contact" or
"undecided".)");
    module.def(
        "certify_se2_motion",
        [](const PyScene& scene, double x1, double y1, double yaw1, double x2, double y2, double yaw2) {
            return nameOf(certifySe2Motion(scene.clearance, {x1, y1, yaw1}, {x2, y2, yaw2}));
        },
        WithoutGil(),
        R"(Certifies both states and all poses that OMPL's SE(2) interpolates between them. Returns "certified", "contact" or
"undecided".)");
    module.def(
        "follow_se3_motion",
        [](const PyScene& scene, double x1, double y1, double z1, double qx1, double qy1, double qz1,
           double qw1, double x2, double y2, double z2, double qx2, double qy2, double qz2, double qw2) {
            return followed(followSe3Motion(scene.clearance, {{x1, y1, z1}, {qw1, qx1, qy1, qz1}},
                                            {{x2, y2, z2}, {qw2, qx2, qy2, qz2}}));
        },
        WithoutGil(), R"(certify_se3_motion, and the time until which the motion is free: 1 for all of it.)");
    module.def(
        "follow_se2_motion",
        [](const PyScene& scene, double x1, double y1, double yaw1, double x2, double y2, double yaw2) {
            return followed(followSe2Motion(scene.clearance, {x1, y1, yaw1}, {x2, y2, yaw2}));
        },
        WithoutGil(), R"(certify_se2_motion, and the time until which the motion is free: 1 for all of it.)");
}

}  // namespace clearway::python
