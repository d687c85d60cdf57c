// The fit of a rectangle swept sphere: the radius is half the extent along the normal, and the rectangle is
// only as large as the roundness of the swept sphere leaves necessary.
#include "build/fit_rss.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tree/normalisation.h"

namespace clearway {

namespace {

/// Sums over points. They are scalars, because the entries of a matrix do not stay in registers.
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

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSqrtHalf = 0.70710678118654752440;

/// Points in a frame: coordinates along the rectangle's sides, and z from its plane.
struct FramePoints {
    Normalisation normalised;
    std::vector<Vector3> points;
    double planeDepth = 0;  ///< of the rectangle's plane along the normal
    double radius = 0;      ///< half the extent along the normal

    FramePoints(const std::vector<Vector3>& given, const Matrix3& axes) : normalised(normalisationOf(given)) {
        const Matrix3 rows = axes.transpose();
        points.reserve(given.size());
        double lowest = kInfinity;
        double highest = -kInfinity;
        for (const Vector3& point : given) {
            points.push_back(rows * normalised(point));
            lowest = std::min(lowest, points.back().z());
            highest = std::max(highest, points.back().z());
        }
        planeDepth = 0.5 * (lowest + highest);
        radius = 0.5 * (highest - lowest);
        for (Vector3& point : points) point.z() -= planeDepth;
    }

    /// How far a sphere of the radius extends at a height, given squared, above its centre's plane. Rounding
    /// may make the root's argument negative.
    double reach(double heightSquared) const {
        return std::sqrt(std::max(radius * radius - heightSquared, 0.0));
    }
};

struct Rectangle {
    double low[2] = {kInfinity, kInfinity};
    double high[2] = {-kInfinity, -kInfinity};
};

/// The least rectangle whose sides cover the points: with s the sphere's reach at a point's height, a point
/// at q needs the side to extend only to q - s (from above, q + s). If no side is left, the rectangle is flat
/// midway.
Rectangle coverSides(const FramePoints& frame) {
    Rectangle rectangle;
    for (const Vector3& q : frame.points) {
        const double s = frame.reach(q.z() * q.z());
        for (int side = 0; side < 2; ++side) {
            rectangle.low[side] = std::min(rectangle.low[side], q[side] + s);
            rectangle.high[side] = std::max(rectangle.high[side], q[side] - s);
        }
    }
    for (int side = 0; side < 2; ++side) {
        if (rectangle.low[side] > rectangle.high[side]) {
            rectangle.low[side] = rectangle.high[side] = 0.5 * (rectangle.low[side] + rectangle.high[side]);
        }
    }
    return rectangle;
}

/// Covers points beyond both sides of a corner that the corner's sphere does not reach: pushes the corner
/// outward along its diagonal. Each push starts from the corner's first place, so the order of the points
/// does not matter.
void coverCorners(const FramePoints& frame, Rectangle& rectangle) {
    double pushes[2][2] = {};  // [is on the high side 0][is on the high side 1], along either side
    for (const Vector3& q : frame.points) {
        const bool isHigh[2] = {q[0] > rectangle.high[0], q[1] > rectangle.high[1]};
        const double dx = isHigh[0] ? q[0] - rectangle.high[0] : rectangle.low[0] - q[0];
        const double dy = isHigh[1] ? q[1] - rectangle.high[1] : rectangle.low[1] - q[1];
        if (dx <= 0 || dy <= 0) continue;
        const double alongDiagonal = (dx + dy) * kSqrtHalf;
        const double fromDiagonalSquared = 0.5 * (dx - dy) * (dx - dy) + q.z() * q.z();
        double& push = pushes[isHigh[0]][isHigh[1]];
        push = std::max(push, (alongDiagonal - frame.reach(fromDiagonalSquared)) * kSqrtHalf);
    }
    rectangle.low[0] -= std::max(pushes[0][0], pushes[0][1]);
    rectangle.high[0] += std::max(pushes[1][0], pushes[1][1]);
    rectangle.low[1] -= std::max(pushes[0][0], pushes[1][0]);
    rectangle.high[1] += std::max(pushes[0][1], pushes[1][1]);
}

}  // namespace

Matrix3 spreadAxes(const Matrix3& covariance) {
    Eigen::SelfAdjointEigenSolver<Matrix3> solver;
    Matrix3 axes = solver.computeDirect(covariance).eigenvectors();
    // The direct solver is several times faster, but its vectors are only nearly orthogonal.
    axes.col(0) -= axes.col(0).dot(axes.col(2)) * axes.col(2);
    axes.col(0).normalize();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    const bool isOrthonormal = (axes.transpose() * axes - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-14;
    return isOrthonormal ? axes : solver.compute(covariance).eigenvectors();
}

PrincipalFrame principalFrame(const std::vector<Vector3>& points) {
    const Normalisation normalised = normalisationOf(points);
    Moments moments;
    for (const Vector3& point : points) moments.add(normalised(point));
    const double count = static_cast<double>(points.size());
    const Vector3 mean = moments.sum() / count;
    const Matrix3 covariance = moments.products() / count - mean * mean.transpose();

    const Matrix3 rising = spreadAxes(covariance);
    PrincipalFrame frame;
    frame.mean = normalised.middle + normalised.unit * mean;
    frame.axes.col(0) = rising.col(2);
    frame.axes.col(1) = rising.col(1);
    frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));
    return frame;
}

Rss fitRss(const std::vector<Vector3>& points, const Matrix3& axes) {
    Rss rss;
    rss.axes << axes.col(0), axes.col(1), axes.col(0).cross(axes.col(1));
    const FramePoints frame(points, rss.axes);
    Rectangle rectangle = coverSides(frame);
    coverCorners(frame, rectangle);

    const double unit = frame.normalised.unit;
    const Vector3 centre(0.5 * (rectangle.low[0] + rectangle.high[0]),
                         0.5 * (rectangle.low[1] + rectangle.high[1]), frame.planeDepth);
    rss.centre = frame.normalised.middle + unit * (rss.axes * centre);
    rss.halfLength0 = unit * 0.5 * (rectangle.high[0] - rectangle.low[0]);
    rss.halfLength1 = unit * 0.5 * (rectangle.high[1] - rectangle.low[1]);
    rss.radius = unit * frame.radius;
    return rss;
}

Rss fitRss(const std::vector<Vector3>& points) {
    return fitRss(points, principalFrame(points).axes);
}

}  // namespace clearway
