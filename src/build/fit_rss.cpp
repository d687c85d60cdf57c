// The fit of a rectangle swept sphere: the radius is half the extent along the normal, and the rectangle is
// only as large as the roundness of the swept sphere leaves necessary. The same two steps exist twice: in
// double for the result, and in float, several points at a time, to compare frames.
#include "build/fit_rss.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
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

/// Maps points to a frame: coordinates along the rectangle's sides, and z from its plane.
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

/// How far a sphere of the radius extends at height z above its centre's plane. Rounding may make the root's
/// argument negative.
double reach(double radius, double z) {
    return std::sqrt(std::max(radius * radius - z * z, 0.0));
}

/// The least rectangle whose sides cover the points: with s the sphere's reach at a point's height, a point
/// at q needs the side to extend only to q - s (from above, q + s). If no side is left, the rectangle is flat
/// midway.
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

/// Covers points beyond both sides of a corner that the corner's sphere does not reach: pushes the corner
/// outward along its diagonal. Each push starts from the corner's first place, so the order of the points
/// does not matter.
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

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr float kFloatPi = 3.14159265f;
constexpr float kFloatSqrtHalf = 0.70710678f;

float areaOf(float length, float width, float radius) {
    return 4 * kFloatPi * radius * radius + 2 * length * width + 2 * kFloatPi * radius * (length + width);
}

/// The area of the smallest RSS that can hold points of these extents.
float areaAtLeast(float extent0, float extent1, float depth) {
    return areaOf(std::max(extent0 - depth, 0.0f), std::max(extent1 - depth, 0.0f), 0.5f * depth);
}

/// A side of the rectangle; flat and midway if the swept sphere covers the whole extent.
struct Side {
    float low, high;
    Side(float least, float greatest) : low(least), high(greatest) {
        if (low > high) low = high = 0.5f * (low + high);
    }
    float length() const { return high - low; }
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

void FrameSearch::begin(const std::vector<Vector3>& points) {
    assert(!points.empty());
    points_ = &points;
    leastArea_ = kFloatInfinity;
    const Normalisation normalised = normalisationOf(points);
    const std::size_t blocks = (points.size() + kLanes - 1) / kLanes;
    for (std::vector<Lanes>* coordinates : {&x_, &y_, &z_, &projected_[0], &projected_[1], &projected_[2]})
        coordinates->resize(blocks);
    for (std::size_t i = 0; i < blocks * kLanes; ++i) {
        const Eigen::Vector3f point = normalised(points[std::min(i, points.size() - 1)]).cast<float>();
        x_[i / kLanes][i % kLanes] = point.x();
        y_[i / kLanes][i % kLanes] = point.y();
        z_[i / kLanes][i % kLanes] = point.z();
    }
}

FrameSearch::Extent FrameSearch::project(const Eigen::Vector3f& axis, std::vector<Lanes>& coordinates) const {
    Lanes low = Lanes::Constant(kFloatInfinity);
    Lanes high = Lanes::Constant(-kFloatInfinity);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Lanes coordinate = axis.x() * x_[i] + axis.y() * y_[i] + axis.z() * z_[i];
        coordinates[i] = coordinate;
        low = low.min(coordinate);
        high = high.max(coordinate);
    }
    return {low.minCoeff(), high.maxCoeff()};
}

void FrameSearch::consider(const Matrix3& axes) {
    Extent extents[3];
    float lengths[3];
    for (int k = 0; k < 3; ++k) {
        extents[k] = project(axes.col(k).cast<float>(), projected_[k]);
        lengths[k] = extents[k].high - extents[k].low;
    }
    for (int normal = 0; normal < 3; ++normal) {
        const int side0 = (normal + 1) % 3;
        const int side1 = (normal + 2) % 3;
        if (areaAtLeast(lengths[side0], lengths[side1], lengths[normal]) >= leastArea_) continue;
        const float candidate =
            area(projected_[side0], projected_[side1], projected_[normal], extents[normal]);
        if (!(candidate < leastArea_)) continue;  // also NaN, from a surface with hardly any area
        leastArea_ = candidate;
        bestAxes_ << axes.col(side0), axes.col(side1), axes.col(normal);
    }
}

/// The area by the two steps of fitRss. Infinite when the first step alone rules the frame out.
float FrameSearch::area(const std::vector<Lanes>& side0, const std::vector<Lanes>& side1,
                        const std::vector<Lanes>& normal, const Extent& depth) const {
    const float plane = 0.5f * (depth.low + depth.high);
    const float radius = 0.5f * (depth.high - depth.low);
    const float radiusSquared = radius * radius;
    Lanes low0 = Lanes::Constant(kFloatInfinity), low1 = low0;
    Lanes high0 = Lanes::Constant(-kFloatInfinity), high1 = high0;
    for (std::size_t i = 0; i < normal.size(); ++i) {
        const Lanes reach = (radiusSquared - (normal[i] - plane).square()).max(0.0f).sqrt();
        low0 = low0.min(side0[i] + reach);
        high0 = high0.max(side0[i] - reach);
        low1 = low1.min(side1[i] + reach);
        high1 = high1.max(side1[i] - reach);
    }
    const Side a(low0.minCoeff(), high0.maxCoeff());
    const Side b(low1.minCoeff(), high1.maxCoeff());
    if (areaOf(a.length(), b.length(), radius) >= leastArea_) return kFloatInfinity;

    Lanes pushLow0 = Lanes::Zero(), pushHigh0 = pushLow0, pushLow1 = pushLow0, pushHigh1 = pushLow0;
    for (std::size_t i = 0; i < normal.size(); ++i) {
        const Lanes beyond0 = (side0[i] - a.high).max(a.low - side0[i]);
        const Lanes beyond1 = (side1[i] - b.high).max(b.low - side1[i]);
        if ((beyond0.min(beyond1) <= 0).all()) continue;
        const Lanes across = (beyond0 - beyond1) * kFloatSqrtHalf;
        const Lanes reach = (radiusSquared - across.square() - (normal[i] - plane).square()).max(0.0f).sqrt();
        const Lanes push =
            (beyond0.min(beyond1) > 0)
                .select(((beyond0 + beyond1) * kFloatSqrtHalf - reach) * kFloatSqrtHalf, Lanes::Zero());
        pushHigh0 = (side0[i] > a.high).select(pushHigh0.max(push), pushHigh0);
        pushLow0 = (side0[i] > a.high).select(pushLow0, pushLow0.max(push));
        pushHigh1 = (side1[i] > b.high).select(pushHigh1.max(push), pushHigh1);
        pushLow1 = (side1[i] > b.high).select(pushLow1, pushLow1.max(push));
    }
    return areaOf(a.length() + pushLow0.maxCoeff() + pushHigh0.maxCoeff(),
                  b.length() + pushLow1.maxCoeff() + pushHigh1.maxCoeff(), radius);
}

Rss FrameSearch::leastArea() const {
    assert(leastArea_ < kFloatInfinity);
    return fitRss(*points_, bestAxes_);
}

}  // namespace clearway
