#include "planning/objectives/closeness_weight.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace clearway::planning {
namespace {

/// The part of a motion between two samples, with bounds of the integral of `extra` over its time.
struct Part {
    MotionSample from, to;
    double displacement;  ///< how far the part moves
    double low, high;
    bool isCertified;
    bool isClosed;  ///< too short to be divided

    /// Parts that are not certified are divided first, the longest of them before others; then the parts
    /// whose bounds are farthest apart.
    bool isLessUrgentThan(const Part& other) const {
        if (isClosed != other.isClosed) return isClosed;
        if (isCertified != other.isCertified) return isCertified;
        return isCertified ? high - low < other.high - other.low : displacement < other.displacement;
    }
};

/// Upper bound of the integral of the weight's extra over clearances that fall from `far` > 0 to `near`.
double mostOverSide(const ClosenessWeight& weight, double far, double near) {
    const double inContact = std::max(0.0, -near);
    const double upper = std::min(far, weight.end), lower = std::clamp(near, 0.0, weight.end);
    const double between = std::max(0.0, upper - lower) * 0.5 * (weight.extra(upper) + weight.extra(lower));
    return inContact * weight.extra(0) + between;
}

/// Lower bound of that integral, for near > 0.
double leastOverSide(const ClosenessWeight& weight, double far, double near) {
    const double upper = std::min(far, weight.end);
    return std::max(0.0, upper - near) * weight.extra(0.5 * (upper + near));
}

Part makePart(const MotionSample& from, const MotionSample& to, double displacement,
              const ClosenessWeight& weight) {
    const double h = displacement, a = from.leeway.lower, b = to.leeway.lower;
    const double deepest = std::min({0.5 * (a + b - h), a, b});
    const double perLength = (to.time - from.time) / h;
    const double mostA = std::min(from.leeway.upper, to.leeway.upper + h),
                 mostB = std::min(to.leeway.upper, from.leeway.upper + h);
    const double highest = 0.5 * (mostA + mostB + h);
    const double high = perLength * (mostOverSide(weight, a, deepest) + mostOverSide(weight, b, deepest));
    const double low =
        std::isinf(highest)
            ? 0
            : perLength * (leastOverSide(weight, highest, mostA) + leastOverSide(weight, highest, mostB));
    return {from, to, h, std::min(low, high), high, deepest > 0, false};
}

/// A part so short that all of it counts as close as its closer end, but for its length.
Part makeShortPart(const MotionSample& from, const MotionSample& to, double displacement,
                   const ClosenessWeight& weight) {
    const double step = to.time - from.time;
    const double deepest = std::min(from.leeway.lower, to.leeway.lower) - displacement;
    const double highest = std::min({from.leeway.upper, to.leeway.upper, weight.end}) + displacement;
    return {from,
            to,
            displacement,
            step * weight.extra(highest),
            step * weight.extra(std::max(0.0, deepest)),
            deepest > 0,
            true};
}

class WeightSearch {
  public:
    WeightSearch(Motion& motion, const ClosenessWeight& weight, double leastInterval)
        : motion_(motion), weight_(weight), leastInterval_(std::max(leastInterval, 4 * motion.slack())) {}

    void add(const MotionSample& from, const MotionSample& to) {
        const double displacement = motion_.length() * (to.time - from.time) + motion_.slack();
        const Part part = displacement > leastInterval_ ? makePart(from, to, displacement, weight_)
                                                        : makeShortPart(from, to, displacement, weight_);
        low_ += part.low;
        high_ += part.high;
        parts_.push_back(part);
        std::push_heap(parts_.begin(), parts_.end(), isLessUrgent);
    }

    bool isSure(double resolution) const {
        const Part& first = parts_.front();
        return first.isClosed || (first.isCertified && 0.5 * (high_ - low_) <= resolution * (1 + low_));
    }

    /// Returns false when the pose in the middle is invalid. If that pose has the requested clearance, both
    /// halves are fully certified.
    bool divideFirst() {
        std::pop_heap(parts_.begin(), parts_.end(), isLessUrgent);
        const Part part = parts_.back();
        parts_.pop_back();
        low_ -= part.low;
        high_ -= part.high;
        const double middle = part.from.time + 0.5 * (part.to.time - part.from.time);
        const MotionSample sample =
            motion_.at(middle, weight_.end + 0.5 * part.displacement + motion_.slack());
        if (!sample.isValid()) return false;
        add(part.from, sample);
        add(sample, part.to);
        return true;
    }

    double mean() const { return 1 + std::max(0.0, 0.5 * (low_ + high_)); }  // the sums have been rounded

  private:
    static bool isLessUrgent(const Part& a, const Part& b) { return a.isLessUrgentThan(b); }

    Motion& motion_;
    const ClosenessWeight& weight_;
    double leastInterval_;
    std::vector<Part> parts_;  ///< a heap
    double low_ = 0, high_ = 0;
};

}  // namespace

std::optional<double> meanWeight(Motion& motion, const ClosenessWeight& weight, double resolution,
                                 double leastInterval) {
    motion.measure();
    const double wanted = weight.end + 0.5 * motion.length() + motion.slack();
    const MotionSample end = motion.atEnd(wanted);
    if (!end.isValid()) return std::nullopt;
    const MotionSample start = motion.atStart(wanted);
    if (!start.isValid()) return std::nullopt;
    WeightSearch search(motion, weight, leastInterval);
    search.add(start, end);
    while (!search.isSure(resolution)) {
        if (!search.divideFirst()) return std::nullopt;
    }
    return search.mean();
}

}  // namespace clearway::planning
