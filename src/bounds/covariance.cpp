#include "bounds/covariance.h"

#include <Eigen/Eigenvalues>

#include "bounds/normalisation.h"

namespace clearway {

PrincipalFrame principalFrame(const std::vector<Vector3>& points) {
    const Normalisation normalised = normalisationOf(points);
    Vector3 sum = Vector3::Zero();
    Matrix3 products = Matrix3::Zero();
    for (const Vector3& point : points) {
        const Vector3 x = normalised(point);
        sum += x;
        products += x * x.transpose();
    }
    const Vector3 mean = sum / static_cast<double>(points.size());
    const Matrix3 covariance = products / static_cast<double>(points.size()) - mean * mean.transpose();

    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance);  // eigenvalues in rising order
    PrincipalFrame frame;
    frame.mean = normalised.middle + normalised.unit * mean;
    frame.axes.col(0) = solver.eigenvectors().col(2);
    frame.axes.col(1) = solver.eigenvectors().col(1);
    frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));
    return frame;
}

}  // namespace clearway
