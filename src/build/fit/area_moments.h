// Mean and spread of a surface, each part weighing as much as its area: unlike the vertices', they do not
// depend on how finely the surface is cut.
#pragma once

#include <Eigen/Eigenvalues>

#include "clearway/types.h"

namespace clearway {

/// Of a set of triangles; the sum of two sets' is that of their union.
struct AreaMoments {
    double area = 0;
    Vector3 mean = Vector3::Zero();
    Matrix3 scatter = Matrix3::Zero();  ///< integral of (x - mean) (x - mean)^T

    static AreaMoments ofTriangle(const Vector3& a, const Vector3& b, const Vector3& c) {
        AreaMoments moments;
        moments.area = 0.5 * (b - a).cross(c - a).norm();
        moments.mean = (a + b + c) / 3;
        const Vector3 u = a - moments.mean, v = b - moments.mean, w = c - moments.mean;
        moments.scatter = (moments.area / 12) * (u * u.transpose() + v * v.transpose() + w * w.transpose());
        return moments;
    }

    AreaMoments& operator+=(const AreaMoments& other) {
        if (other.area == 0) return *this;
        const double share = other.area / (area + other.area);
        const Vector3 offset = other.mean - mean;
        scatter += other.scatter + (area * share) * offset * offset.transpose();
        mean += share * offset;
        area += other.area;
        return *this;
    }

    /// Orthonormal; area > 0.
    Matrix3 axes() const { return Eigen::SelfAdjointEigenSolver<Matrix3>(scatter / area).eigenvectors(); }
};

}  // namespace clearway
