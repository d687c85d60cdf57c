// The two steps of fitRss in float, for four frames at a time: a lane of a vector stands for a frame, and the
// points follow each other. So small nodes, which are most, fill the vectors, too.
#include "build/frame_search.h"

#include <cassert>

#include "tree/normalisation.h"

namespace clearway {

namespace {

using Frames = Eigen::Array4f;  ///< a number for each of four frames

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr float kFloatPi = 3.14159265f;
constexpr float kFloatSqrtHalf = 0.70710678f;

Frames areaOf(const Frames& length, const Frames& width, const Frames& radius) {
    return 4 * kFloatPi * radius * radius + 2 * length * width + 2 * kFloatPi * radius * (length + width);
}

/// The area of the smallest RSS that can hold points of these extents.
Frames areaAtLeast(const Frames& extent0, const Frames& extent1, const Frames& depth) {
    return areaOf((extent0 - depth).max(0.0f), (extent1 - depth).max(0.0f), 0.5f * depth);
}

/// A side of the rectangle; flat and midway if the swept sphere covers the whole extent.
struct FrameSide {
    Frames low, high;
    FrameSide(const Frames& least, const Frames& greatest) {
        const Frames middle = 0.5f * (least + greatest);
        low = least.min(middle);
        high = greatest.max(middle);
    }
    Frames length() const { return high - low; }
};

/// The value where `sign` is positive, at most 0 elsewhere: as selecting, but compilers make vectors of it.
/// A positive sign is far above the smallest floats, being a difference of coordinates within +-2.
Frames wherePositive(const Frames& sign, const Frames& value) {
    return value.min(sign * 0x1p60f);
}

}  // namespace

void FrameSearch::begin(const std::vector<Vector3>& points) {
    assert(!points.empty());
    points_ = &points;
    leastArea_ = kFloatInfinity;
    waitingCount_ = 0;
    const Normalisation normalised = normalisationOf(points);
    normalised_.resize(points.size());
    projected_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) normalised_[i] = normalised(points[i]).cast<float>();
}

void FrameSearch::consider(const Matrix3& axes) {
    if (!axes.allFinite()) return;  // from a surface with hardly any area
    waiting_[waitingCount_++] = axes;
    if (waitingCount_ == kFrames) rateWaiting();
}

void FrameSearch::rateWaiting() {
    if (waitingCount_ == 0) return;
    for (int k = waitingCount_; k < kFrames; ++k) waiting_[k] = waiting_[0];
    waitingCount_ = 0;
    Frames axes[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < kFrames; ++k) axes[axis][i][k] = static_cast<float>(waiting_[k](i, axis));
        }
    }
    Extent extents[3];
    for (std::size_t i = 0; i < normalised_.size(); ++i) {
        const Eigen::Vector3f& point = normalised_[i];
        for (int axis = 0; axis < 3; ++axis) {
            const Frames coordinate =
                axes[axis][0] * point.x() + axes[axis][1] * point.y() + axes[axis][2] * point.z();
            projected_[i][axis] = coordinate;
            extents[axis].low = extents[axis].low.min(coordinate);
            extents[axis].high = extents[axis].high.max(coordinate);
        }
    }
    for (const int normal : {2, 1, 0}) {  // the last axis is the normal most often
        const int side0 = (normal + 1) % 3;
        const int side1 = (normal + 2) % 3;
        const Frames atLeast =
            areaAtLeast(extents[side0].length(), extents[side1].length(), extents[normal].length());
        if (atLeast.minCoeff() >= leastArea_) continue;
        const Frames candidates = areas(side0, side1, normal, extents[normal]);
        int best = 0;
        const float least = candidates.minCoeff(&best);
        if (!(least < leastArea_)) continue;
        leastArea_ = least;
        bestAxes_ << waiting_[best].col(side0), waiting_[best].col(side1), waiting_[best].col(normal);
    }
}

/// The areas in the frames, by the two steps of fitRss. Infinite when the first step alone rules all of them
/// out.
FrameSearch::Frames FrameSearch::areas(int side0, int side1, int normal, const Extent& depth) const {
    const Frames plane = 0.5f * (depth.low + depth.high);
    const Frames radius = 0.5f * depth.length();
    const Frames radiusSquared = radius * radius;
    Extent outer0, outer1;  // low and high change roles: where sides must begin at the latest
    for (const std::array<Frames, 3>& point : projected_) {
        const Frames reach = (radiusSquared - (point[normal] - plane).square()).max(0.0f).sqrt();
        outer0.low = outer0.low.min(point[side0] + reach);
        outer0.high = outer0.high.max(point[side0] - reach);
        outer1.low = outer1.low.min(point[side1] + reach);
        outer1.high = outer1.high.max(point[side1] - reach);
    }
    const FrameSide a(outer0.low, outer0.high);
    const FrameSide b(outer1.low, outer1.high);
    if (areaOf(a.length(), b.length(), radius).minCoeff() >= leastArea_)
        return Frames::Constant(kFloatInfinity);

    Frames pushLow0 = Frames::Zero(), pushHigh0 = pushLow0, pushLow1 = pushLow0, pushHigh1 = pushLow0;
    for (const std::array<Frames, 3>& point : projected_) {
        const Frames above0 = point[side0] - a.high, below0 = a.low - point[side0];
        const Frames above1 = point[side1] - b.high, below1 = b.low - point[side1];
        const Frames beyond0 = above0.max(below0), beyond1 = above1.max(below1);
        const Frames across = (beyond0 - beyond1) * kFloatSqrtHalf;
        const Frames reach =
            (radiusSquared - across.square() - (point[normal] - plane).square()).max(0.0f).sqrt();
        const Frames push = wherePositive(beyond0.min(beyond1),
                                          ((beyond0 + beyond1) * kFloatSqrtHalf - reach) * kFloatSqrtHalf);
        pushHigh0 = pushHigh0.max(wherePositive(above0, push));
        pushLow0 = pushLow0.max(wherePositive(below0, push));
        pushHigh1 = pushHigh1.max(wherePositive(above1, push));
        pushLow1 = pushLow1.max(wherePositive(below1, push));
    }
    return areaOf(a.length() + pushLow0 + pushHigh0, b.length() + pushLow1 + pushHigh1, radius);
}

Rss FrameSearch::leastArea() {
    rateWaiting();
    assert(leastArea_ < kFloatInfinity);
    return fitRss(*points_, bestAxes_);
}

}  // namespace clearway
