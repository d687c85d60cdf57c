#include "planning/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// How far a point of the part is, at the pose that was queried, from where the motion in exact arithmetic
/// has it: of the part's radius, the positions and the length, with the margin, whose subtraction rounds too.
/// OMPL's slerp: sines, the factors and the sum are off by at most 10 in 2^-53 for each of four entries,
/// which turns the part by at most 40; the matrix adds 18, the position 4. Altogether less than 2^6.
constexpr double kPoseRounding = 0x1p-47;

/// Where the interpolation ends; time 1 stands for s2.
constexpr double kJustBeforeEnd = 1 - 0x1p-53;

/// Of it: from each end of an interval two or, where s2 stands for the end, three roundings count.
constexpr double kRoundingsOfAnInterval = 8;

/// A rough clearance is so to within a tenth of itself, which may be all that it has above a floor.
bool isTooRough(const PoseClearance& found, double floor) {
    constexpr double kEnough = 0.9;
    if (floor == 0 || std::isinf(found.upper) || found.upper <= floor) return false;
    return found.lower - floor < kEnough * (found.upper - floor);
}

void widen(std::optional<TimeSpan>& span, double time) {
    if (!span) span = TimeSpan{time, time};
    span->first = std::min(span->first, time);
    span->last = std::max(span->last, time);
}

double least(double a, double b) {
    return std::min(a, b);
}
double most(double a, double b) {
    return std::max(a, b);
}

/// One of each two lower bounds and one of each two upper ones.
template <class Low, class High>
MotionSample combined(const MotionSample& a, const MotionSample& b, const Low& low, const High& high) {
    MotionSample result = a;
    result.clearance = low(a.clearance, b.clearance);
    result.upper = high(a.upper, b.upper);
    result.counting = low(a.counting, b.counting);
    result.countingUpper = high(a.countingUpper, b.countingUpper);
    result.always = low(a.always, b.always);
    for (std::size_t i = 0; i < kMostZones; ++i) {
        result.zones[i].clearance = low(a.zones[i].clearance, b.zones[i].clearance);
        result.zones[i].spare = low(a.zones[i].spare, b.zones[i].spare);
    }
    return result;
}

/// What is certain wherever the part is moved by so much.
MotionSample lessened(const MotionSample& sample, double jump) {
    const auto less = [jump](double a, double) { return a - jump; };
    const auto more = [jump](double a, double) { return a + jump; };
    return combined(sample, sample, less, more);
}

}  // namespace

Motion::Motion(const MotionTools& tools, const ob::State* s1, const ob::State* s2)
    : tools_(tools), s1_(s1), s2_(s2), scratch_(tools.si) {}

bool Motion::isEndValid() {
    if (!tools_.si.satisfiesBounds(s2_)) return false;
    if (tools_.floor > 0) return true;  // asked for states of a path, which keep it mostly
    ++queries_;
    isOutside_ = tools_.clearance.isFree(tools_.stateToPose(s2_));
    return isOutside_;
}

void Motion::measure() {
    length_ = tools_.bound(s1_, s2_);
    if (!(length_ >= 0) ||
        !std::isfinite(length_)) {  // before OMPL interpolates: it asserts unit quaternions
        throw std::runtime_error("the motion between two states has no finite displacement bound");
    }
    const Scene& scene = tools_.clearance.scene();
    const double position =
        std::max(tools_.stateToPose(s1_).translation.norm(), tools_.stateToPose(s2_).translation.norm());
    slack_ = kRoundingsOfAnInterval * kPoseRounding *
             (scene.part.radiusAboutOrigin() + position + length_ + scene.largestMargin() + tools_.floor);
    if (!std::isfinite(slack_)) {
        throw std::runtime_error("one of two states has no pose: an entry is not finite");
    }
    checksBoundsBetween_ = !tools_.areBoundsConvex || !tools_.si.satisfiesBounds(s2_);
}

MotionSample Motion::atStart(double wanted) {
    const MotionSample start = look(s1_, 0, wanted, true);
    isOutside_ = isOutside_ || start.isValid();
    return start;
}

MotionSample Motion::at(double time, double wanted) {
    tools_.si.getStateSpace()->interpolate(s1_, s2_, time, scratch_.get());
    return look(scratch_.get(), time, wanted, checksBoundsBetween_);
}

MotionSample Motion::atEnd(double wanted) {
    MotionSample end = look(s2_, 1, wanted, true);
    if (!end.isValid() || length_ == 0) return end;
    isOutside_ = true;
    endJump_ = findEndJump();
    const MotionSample certain = lessened(end, endJump_);
    if (certain.clearance > end.clearance / 2) return certain;
    // Two poses with more between them than can be told: solids may lie there.
    isOutside_ = false;
    end = look(s2_, 1, wanted, true);
    const MotionSample interpolated = at(kJustBeforeEnd, wanted);
    if (!end.isValid() || !interpolated.isValid()) return end.isValid() ? interpolated : end;
    isOutside_ = true;
    return combined(certain, combined(end, interpolated, least, most), most, least);
}

double Motion::findEndJump() const {
    tools_.si.getStateSpace()->interpolate(s1_, s2_, 1, scratch_.get());
    const double jump = tools_.bound(scratch_.get(), s2_);
    if (std::isfinite(jump)) return jump;
    throw std::runtime_error("the jump at the end of the interpolation has no finite displacement bound");
}

MotionSample Motion::look(const ob::State* state, double time, double wanted, bool checksBounds) {
    if (checksBounds && !tools_.si.satisfiesBounds(state)) {
        MotionSample outside;
        outside.time = time;
        outside.isOutOfBounds = true;
        return outside;
    }
    ClearanceOptions options;
    options.isOutside = isOutside_;
    options.isRough = tools_.detail == ClearanceDetail::kRough;
    options.leastSpare = 2 * (length_ + slack_);
    if (tools_.detail != ClearanceDetail::kWhole) {
        options.leastSpare = wanted;
        options.cap = wanted + tools_.floor;
    }
    const Pose X_environmentPart = tools_.stateToPose(state);
    PoseClearance found = tools_.clearance.at(X_environmentPart, options);
    queries_ += found.queries;
    if (options.isRough && isTooRough(found, tools_.floor)) {
        options.isRough = false;
        found = tools_.clearance.at(X_environmentPart, options);
        queries_ += found.queries;
    }
    if (found.isInStartContact) widen(startContact_, time);
    if (found.isInGoalContact) widen(goalContact_, time);
    if (closest_.queries == 0 || found.lower < closest_.lower) {
        closest_ = found;
        closestTime_ = time;
    }
    leastUpper_ = std::min(leastUpper_, found.upper);
    return sampleOf(time, found);
}

MotionSample Motion::sampleOf(double time, const PoseClearance& found) const {
    const double floor = tools_.floor;
    MotionSample sample;
    sample.time = time;
    sample.counting = found.lower - floor;
    sample.countingUpper = found.upper - floor;
    sample.always = sample.clearance = found.lowerAlways - floor;
    sample.upper = found.upperAlways - floor;
    for (std::size_t i = 0; i < zoneCount(); ++i) {
        const ZoneClearance& zone = found.zones[i];
        sample.zones[i] = {zone.clearance - floor, zone.spare};
        sample.clearance = std::min(sample.clearance, std::max(zone.clearance - floor, zone.spare));
        sample.upper = std::min(sample.upper, std::max(zone.upper - floor, zone.mostSpare));
    }
    const bool isValid = sample.counting > 0;
    sample.clearance = isValid ? std::max(sample.clearance, std::numeric_limits<double>::denorm_min())
                               : std::min(sample.clearance, sample.counting);
    return sample;
}

}  // namespace clearway::planning
