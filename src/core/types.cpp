#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <sstream>

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
    std::ostringstream message;
    message << "the pose's ";
    if (!pose.rotation.allFinite() || !pose.translation.allFinite()) {
        message << "rotation or translation is not finite, expected finite numbers";
    } else if (std::isinf(defect)) {
        message << "matrix is no rotation: its determinant is " << pose.rotation.determinant()
                << ", expected 1";
    } else {
        message << "matrix is no rotation: max |R^T R - I| is " << defect << ", expected at most "
                << accepted;
    }
    throw ArgumentError(message.str());
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
