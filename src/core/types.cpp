#include <fmt/format.h>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "clearway/errors.h"
#include "clearway/types.h"

namespace clearway {

double rotationDefect(const Pose& pose) {
    const Matrix3& R = pose.rotation;
    if (!R.allFinite() || !pose.translation.allFinite() || !(R.determinant() > 0)) {
        return std::numeric_limits<double>::infinity();
    }
    return (R.transpose() * R - Matrix3::Identity()).cwiseAbs().maxCoeff();
}

namespace {

[[noreturn]] void refuseRotation(const Pose& pose, double defect, double accepted) {
    if (!pose.rotation.allFinite() || !pose.translation.allFinite()) {
        throw ArgumentError("the pose's rotation or translation is not finite, expected finite numbers");
    }
    const std::string why =
        std::isinf(defect) ? fmt::format("its determinant is {:g}, expected 1", pose.rotation.determinant())
                           : fmt::format("max |R^T R - I| is {:g}, expected at most {:g}", defect, accepted);
    throw ArgumentError("the pose's matrix is no rotation: " + why);
}

}  // namespace

void requirePose(const Pose& pose) {
    const double defect = rotationDefect(pose);
    if (!(defect <= kPoseDefect)) refuseRotation(pose, defect, kPoseDefect);
}

Pose nearestPose(const Pose& pose) {
    const double defect = rotationDefect(pose);
    if (!(defect <= kProjectableDefect)) refuseRotation(pose, defect, kProjectableDefect);
    const Eigen::JacobiSVD<Matrix3> svd(pose.rotation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU() * svd.matrixV().transpose(), pose.translation};
}

}  // namespace clearway
