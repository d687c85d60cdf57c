#include "planning/motion.h"

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

}  // namespace

Motion::Motion(const MotionTools& tools, const ob::State* s1, const ob::State* s2)
    : tools_(tools), s1_(s1), s2_(s2), scratch_(tools.si) {}

bool Motion::isEndValid() {
    if (!tools_.si.satisfiesBounds(s2_)) return false;
    if (tools_.floor > 0) return true;  // asked for states of a path, which keep it mostly
    ++queries_;
    return tools_.clearance.isFree(tools_.stateToPose(s2_));
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
    return look(s1_, 0, wanted, true);
}

MotionSample Motion::at(double time, double wanted) {
    tools_.si.getStateSpace()->interpolate(s1_, s2_, time, scratch_.get());
    return look(scratch_.get(), time, wanted, checksBoundsBetween_);
}

MotionSample Motion::atEnd(double wanted) {
    MotionSample end = look(s2_, 1, wanted, true);
    if (!end.isValid() || length_ == 0) return end;
    endJump_ = findEndJump();
    end.upper += endJump_;
    const double certain = end.clearance - endJump_;
    if (certain > end.clearance / 2) {
        end.clearance = certain;
        return end;
    }
    const MotionSample interpolated = at(kJustBeforeEnd, wanted);
    if (!interpolated.isValid()) return interpolated;
    end.clearance = std::max(certain, std::min(end.clearance, interpolated.clearance));
    return end;
}

double Motion::findEndJump() const {
    tools_.si.getStateSpace()->interpolate(s1_, s2_, 1, scratch_.get());
    const double jump = tools_.bound(scratch_.get(), s2_);
    if (std::isfinite(jump)) return jump;
    throw std::runtime_error("the jump at the end of the interpolation has no finite displacement bound");
}

MotionSample Motion::look(const ob::State* state, double time, double wanted, bool checksBounds) {
    MotionSample sample{time, 0, checksBounds && !tools_.si.satisfiesBounds(state)};
    if (sample.isOutOfBounds) return sample;
    ClearanceOptions options;
    if (tools_.detail != ClearanceDetail::kWhole) options.cap = wanted + tools_.floor;
    options.isRough = tools_.detail == ClearanceDetail::kRough;
    const Pose X_environmentPart = tools_.stateToPose(state);
    PoseClearance found = tools_.clearance.at(X_environmentPart, options);
    queries_ += found.queries;
    if (options.isRough && isTooRough(found, tools_.floor)) {
        options.isRough = false;
        found = tools_.clearance.at(X_environmentPart, options);
        queries_ += found.queries;
    }
    sample.clearance = found.lower - tools_.floor;
    sample.upper = found.upper - tools_.floor;
    if (closest_.queries == 0 || found.lower < closest_.lower) {
        closest_ = found;
        closestTime_ = time;
    }
    leastUpper_ = std::min(leastUpper_, found.upper);
    return sample;
}

}  // namespace clearway::planning
