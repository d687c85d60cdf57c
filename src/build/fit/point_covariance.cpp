#include "build/fit/point_covariance.h"

#include <Eigen/Eigenvalues>

#include "tree/normalisation.h"

namespace clearway {

namespace {

/// Sums over points, in scalars: they stay in registers, as the entries of a matrix do not.
struct Moments {
    double x = 0, y = 0, z = 0;
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    void add(const Vector3& point) {
        const double px = point.x(), py = point.y(), pz = point.z();
        x += px;
        y += py;
        z += pz;
        xx += px * px;
        xy += px * py;
        xz += px * pz;
        yy += py * py;
        yz += py * pz;
        zz += pz * pz;
    }

    Vector3 sum() const { return {x, y, z}; }

    Matrix3 products() const {
        Matrix3 matrix;
        matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        return matrix;
    }
};

}  // namespace

PrincipalFrame principalFrame(const std::vector<Vector3>& points) {
    const Normalisation normalised = normalisationOf(points);
    Moments moments;
    for (const Vector3& point : points) moments.add(normalised(point));
    const double count = static_cast<double>(points.size());
    const Vector3 mean = moments.sum() / count;
    const Matrix3 covariance = moments.products() / count - mean * mean.transpose();

    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(covariance);  // eigenvalues in rising order
    PrincipalFrame frame;
    frame.mean = normalised.middle + normalised.unit * mean;
    frame.axes.col(0) = solver.eigenvectors().col(2);
    frame.axes.col(1) = solver.eigenvectors().col(1);
    frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));
    return frame;
}

}  // namespace clearway
