#include "model/principal_axes.h"

#include <Eigen/Eigenvalues>

#include "model/triangles_of.h"

namespace clearway {

Matrix3 principalAxesOf(const Model& model) {
    Vector3 sum = Vector3::Zero();
    Matrix3 squares = Matrix3::Zero();
    double count = 0;
    eachTriangleOf(model, [&](std::size_t, const TriangleCorners& corners) {
        for (const Vector3& corner : corners) {
            const Vector3 from = corner - model.box().center();
            sum += from;
            squares += from * from.transpose();
            ++count;
        }
    });
    const Matrix3 covariance = squares / count - sum * sum.transpose() / (count * count);
    return Eigen::SelfAdjointEigenSolver<Matrix3>(covariance).eigenvectors();
}

}  // namespace clearway
