// Fits a rectangle swept sphere in a given frame: the radius is half the extent along the normal, the
// rectangle is only as large as the swept sphere's roundness leaves necessary. Source: Larsen, Gottschalk,
// Lin, Manocha, Fast Proximity Queries with Swept Sphere Volumes, TR99-018, 1999.
#include <algorithm>
#include <cmath>
#include <limits>

#include "build/fit/point_covariance.h"
#include "tree/normalisation.h"
#include "tree/rss.h"

namespace clearway {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSqrtHalf = 0.70710678118654752440;

/// The points as a frame sees them: coordinates along the rectangle's sides, and z from its plane.
struct Projection {
    Normalisation normalised;
    Matrix3 rows;           ///< the frame's axes
    double planeDepth = 0;  ///< of the rectangle's plane along the normal

    Vector3 operator()(const Vector3& point) const {
        Vector3 local = rows * normalised(point);
        local.z() -= planeDepth;
        return local;
    }
};

struct Rectangle {
    double low[2] = {kInfinity, kInfinity};
    double high[2] = {-kInfinity, -kInfinity};
};

/// How far a sphere of the radius reaches at height z above its centre's plane. At most 0 under the root by
/// rounding.
double reach(double radius, double z) {
    return std::sqrt(std::max(radius * radius - z * z, 0.0));
}

/// A point at q needs the side of the rectangle to reach only q - s (from above q + s). Where even that
/// leaves no side at all, the rectangle is flat in that direction, midway.
Rectangle coverSides(const std::vector<Vector3>& points, const Projection& project, double radius) {
    Rectangle rectangle;
    for (const Vector3& point : points) {
        const Vector3 q = project(point);
        const double s = reach(radius, q.z());
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

/// A point beyond both sides of a corner may still be out of the corner sphere's reach: the corner is pushed
/// outward along its diagonal until it is not. Each corner is pushed from where it was at first, so the
/// points' order does not matter.
void coverCorners(const std::vector<Vector3>& points, const Projection& project, double radius,
                  Rectangle& rectangle) {
    double pushes[2][2] = {};  // [is on the high side 0][is on the high side 1], along either side
    for (const Vector3& point : points) {
        const Vector3 q = project(point);
        const bool isHigh[2] = {q[0] > rectangle.high[0], q[1] > rectangle.high[1]};
        const double dx = isHigh[0] ? q[0] - rectangle.high[0] : rectangle.low[0] - q[0];
        const double dy = isHigh[1] ? q[1] - rectangle.high[1] : rectangle.low[1] - q[1];
        if (dx <= 0 || dy <= 0) continue;
        const double alongDiagonal = (dx + dy) * kSqrtHalf;
        const double fromDiagonal = std::hypot((dx - dy) * kSqrtHalf, q.z());
        double& push = pushes[isHigh[0]][isHigh[1]];
        push = std::max(push, (alongDiagonal - reach(radius, fromDiagonal)) * kSqrtHalf);
    }
    rectangle.low[0] -= std::max(pushes[0][0], pushes[0][1]);
    rectangle.high[0] += std::max(pushes[1][0], pushes[1][1]);
    rectangle.low[1] -= std::max(pushes[0][0], pushes[1][0]);
    rectangle.high[1] += std::max(pushes[0][1], pushes[1][1]);
}

}  // namespace

Rss fitRss(const std::vector<Vector3>& points, const Matrix3& axes) {
    Rss rss;
    rss.axes << axes.col(0), axes.col(1), axes.col(0).cross(axes.col(1));
    Projection project{normalisationOf(points), rss.axes.transpose()};

    double lowest = kInfinity;
    double highest = -kInfinity;
    for (const Vector3& point : points) {
        const double depth = project.rows.row(2).dot(project.normalised(point));
        lowest = std::min(lowest, depth);
        highest = std::max(highest, depth);
    }
    project.planeDepth = 0.5 * (lowest + highest);
    const double radius = 0.5 * (highest - lowest);

    Rectangle rectangle = coverSides(points, project, radius);
    coverCorners(points, project, radius, rectangle);

    const double unit = project.normalised.unit;
    const Vector3 centre(0.5 * (rectangle.low[0] + rectangle.high[0]),
                         0.5 * (rectangle.low[1] + rectangle.high[1]), project.planeDepth);
    rss.centre = project.normalised.middle + unit * (rss.axes * centre);
    rss.halfLength0 = unit * 0.5 * (rectangle.high[0] - rectangle.low[0]);
    rss.halfLength1 = unit * 0.5 * (rectangle.high[1] - rectangle.low[1]);
    rss.radius = unit * radius;
    return rss;
}

Rss fitRss(const std::vector<Vector3>& points) {
    return fitRss(points, principalFrame(points).axes);
}

}  // namespace clearway
