#include "build/fit/frame_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kPi = 3.14159265f;
constexpr float kSqrtHalf = 0.70710678f;

float areaOf(float length, float width, float radius) {
    return 4 * kPi * radius * radius + 2 * length * width + 2 * kPi * radius * (length + width);
}

/// Of the smallest RSS that can hold points of these extents.
float areaAtLeast(float extent0, float extent1, float depth) {
    return areaOf(std::max(extent0 - depth, 0.0f), std::max(extent1 - depth, 0.0f), 0.5f * depth);
}

/// A side of the rectangle; flat, midway, where the swept sphere reaches all by itself.
struct Side {
    float low, high;
    Side(float least, float greatest) : low(least), high(greatest) {
        if (low > high) low = high = 0.5f * (low + high);
    }
    float length() const { return high - low; }
};

}  // namespace

void FrameSearch::begin(const std::vector<Vector3>& points) {
    assert(!points.empty());
    points_ = &points;
    leastArea_ = kInfinity;
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
    Lanes low = Lanes::Constant(kInfinity);
    Lanes high = Lanes::Constant(-kInfinity);
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
        if (!(candidate < leastArea_)) continue;  // NaN, too: axes of a surface that hardly has an area
        leastArea_ = candidate;
        bestAxes_ << axes.col(side0), axes.col(side1), axes.col(normal);
    }
}

/// As fitRss does it: see there for the two steps. Infinite when the first alone rules the frame out.
float FrameSearch::area(const std::vector<Lanes>& side0, const std::vector<Lanes>& side1,
                        const std::vector<Lanes>& normal, const Extent& depth) const {
    const float plane = 0.5f * (depth.low + depth.high);
    const float radius = 0.5f * (depth.high - depth.low);
    const float radiusSquared = radius * radius;
    Lanes low0 = Lanes::Constant(kInfinity), low1 = low0;
    Lanes high0 = Lanes::Constant(-kInfinity), high1 = high0;
    for (std::size_t i = 0; i < normal.size(); ++i) {
        const Lanes reach = (radiusSquared - (normal[i] - plane).square()).max(0.0f).sqrt();
        low0 = low0.min(side0[i] + reach);
        high0 = high0.max(side0[i] - reach);
        low1 = low1.min(side1[i] + reach);
        high1 = high1.max(side1[i] - reach);
    }
    const Side a(low0.minCoeff(), high0.maxCoeff());
    const Side b(low1.minCoeff(), high1.maxCoeff());
    if (areaOf(a.length(), b.length(), radius) >= leastArea_) return kInfinity;

    Lanes pushLow0 = Lanes::Zero(), pushHigh0 = pushLow0, pushLow1 = pushLow0, pushHigh1 = pushLow0;
    for (std::size_t i = 0; i < normal.size(); ++i) {
        const Lanes beyond0 = (side0[i] - a.high).max(a.low - side0[i]);
        const Lanes beyond1 = (side1[i] - b.high).max(b.low - side1[i]);
        if ((beyond0.min(beyond1) <= 0).all()) continue;
        const Lanes across = (beyond0 - beyond1) * kSqrtHalf;
        const Lanes reach = (radiusSquared - across.square() - (normal[i] - plane).square()).max(0.0f).sqrt();
        const Lanes push = (beyond0.min(beyond1) > 0)
                               .select(((beyond0 + beyond1) * kSqrtHalf - reach) * kSqrtHalf, Lanes::Zero());
        pushHigh0 = (side0[i] > a.high).select(pushHigh0.max(push), pushHigh0);
        pushLow0 = (side0[i] > a.high).select(pushLow0, pushLow0.max(push));
        pushHigh1 = (side1[i] > b.high).select(pushHigh1.max(push), pushHigh1);
        pushLow1 = (side1[i] > b.high).select(pushLow1, pushLow1.max(push));
    }
    return areaOf(a.length() + pushLow0.maxCoeff() + pushHigh0.maxCoeff(),
                  b.length() + pushLow1.maxCoeff() + pushHigh1.maxCoeff(), radius);
}

Rss FrameSearch::leastArea() const {
    assert(leastArea_ < kInfinity);
    return fitRss(*points_, bestAxes_);
}

}  // namespace clearway
