#include "planning/check/motion.h"

#include <algorithm>
#include <cmath>

#include <limits>
#include <stdexcept>
#include "planning/space/ompl_refusal.h"

namespace clearway::planning {
namespace {

/// How far a point of the part is, at the pose that was queried, from its place in the motion in exact
/// arithmetic: a share of the sum of the part's radius, the positions, the length and the margin, whose
/// subtraction rounds too. In units of 2^-53: in OMPL's slerp the sines, the factors and the sum are off by
/// at most 10 for each of four entries, which turns the part by at most 40; the matrix adds 18, the position
/// 4. Altogether less than 2^6.
constexpr double kPoseRounding = 0x1p-47;

/// How many errors of kPoseRounding can add up over one interval: two per end, three where s2 replaces the
/// interpolated end. The rest is allowance.
constexpr double kRoundingsOfAnInterval = 8;

/// A rough clearance is known to a tenth of itself, which may be all that it has above a floor.
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

/// Combines two samples: low chooses among their lower bounds, high among their upper bounds.
template <class Low, class High>
MotionSample combined(const MotionSample& a, const MotionSample& b, const Low& low, const High& high) {
    const auto both = [&](const Bounds& x, const Bounds& y) {
        return Bounds{low(x.lower, y.lower), high(x.upper, y.upper)};
    };
    MotionSample result = a;
    result.leeway = both(a.leeway, b.leeway);
    result.lower = low(a.lower, b.lower);
    result.upper = high(a.upper, b.upper);
    return result;
}

/// Holds wherever the part is moved by at most `jump`.
MotionSample lessened(const MotionSample& sample, double jump) {
    const auto less = [jump](double a, double) { return a - jump; };
    const auto more = [jump](double a, double) { return a + jump; };
    return combined(sample, sample, less, more);
}

}  // namespace

Motion::Motion(const PosedScene& posed, ClearanceDetail detail, double floor, const ob::State* s1,
               const ob::State* s2)
    : posed_(posed), detail_(detail), floor_(floor), s1_(s1), s2_(s2), scratch_(posed.si()) {}

bool Motion::isEndValid() {
    if (isEndKnown_) return true;
    if (!isEndWithinBounds()) return false;
    if (floor_ > 0) return true;  // asked for states of a path, which mostly keep the floor
    ++queries_;
    isOutside_ = isEndKnown_ = posed_.clearance().isFree(posed_.pose(s2_));
    return isOutside_;
}

bool Motion::isEndClear() {
    if (!hasSolids() || floor_ > 0) return isEndValid();
    if (isEndKnown_ || isEndClear_) return true;
    if (!isEndWithinBounds()) return false;
    ++queries_;
    isEndClear_ = posed_.clearance().isClearOfSurfaces(posed_.pose(s2_));
    return isEndClear_;
}

void Motion::followSide() {
    if (!hasSolids() || isEndKnown_ || jumpsAtEnd()) return;
    isEndKnown_ = posed_.clearance().isFreeBehind(posed_.pose(s1_), posed_.pose(s2_));
    isOutside_ = isOutside_ || isEndKnown_;
}

void Motion::measure() {
    motion_ = sweptMotion();
    // Checked before OMPL interpolates, because OMPL asserts unit quaternions.
    if (!(length() >= 0) || !std::isfinite(length())) {
        throw OmplRefusal("the motion between two states has no finite displacement bound");
    }
    if (!posed_.motion()) motion_.endJump = findEndJump();
    const Scene& scene = posed_.scene();
    const double position =
        std::max(posed_.pose(s1_).translation.norm(), posed_.pose(s2_).translation.norm());
    slack_ = kRoundingsOfAnInterval * kPoseRounding *
             (scene.part.radiusAboutOrigin() + position + length() + scene.largestMargin() + floor_);
    if (!std::isfinite(slack_)) {
        throw OmplRefusal("one of two states has no pose: an entry is not finite");
    }
    checksBoundsBetween_ = !posed_.areBoundsConvex() || !isStartWithinBounds() || !isEndWithinBounds();
}

bool Motion::isFreeAtStart() {
    ++queries_;
    return posed_.si().satisfiesBounds(s1_) && posed_.clearance().isFree(posed_.pose(s1_));
}

bool Motion::isFreeAt(double time) {
    posed_.space().interpolate(s1_, s2_, time, scratch_.get());
    ++queries_;
    return posed_.clearance().isFree(posed_.pose(scratch_.get()));
}

bool Motion::isClearAt(double time) {
    posed_.space().interpolate(s1_, s2_, time, scratch_.get());
    ++queries_;
    return posed_.clearance().isClearOfSurfaces(posed_.pose(scratch_.get()));
}

SceneSweep Motion::sweep(const SceneSweepOptions& options) {
    const SceneSweep found = posed_.clearance().sweep(motion_, options);
    queries_ += found.queries;
    return found;
}

/// A sweep that finds more clearance than none proves the ends valid, too, unless s2 is off the interpolation. Whole details
/// have the ends' distances anyway, and no sweep need look further than these.
std::optional<LeastClearance> Motion::leastClearance(LeastClearanceOptions options, bool isForReverse) {
    if (!isStartWithinBounds() || !isEndWithinBounds()) return std::nullopt;
    const double jump = isForReverse ? slack_ + motion_.endJump : 0;
    options.poseError = 0.5 * slack_ + jump;
    double cap = options.cap.value_or(std::numeric_limits<double>::infinity());
    std::vector<MotionSample> ends;
    if (detail_ == ClearanceDetail::kWhole) ends.push_back(atStart(cap));
    if (!ends.empty() || jumpsAtEnd()) ends.push_back(atEnd(cap));
    Bounds atEnds;
    for (const MotionSample& sample : ends) {
        if (!sample.isValid()) return std::nullopt;
        if (sample.upper < atEnds.upper) leastTime_ = sample.time;
        atEnds = {std::min(atEnds.lower, sample.lower), std::min(atEnds.upper, sample.upper)};
    }
    if (atEnds.upper < cap) cap = std::max(0.0, atEnds.upper - options.resolution.of(atEnds.upper));
    LeastClearance found;
    found.upper = cap;
    if (cap > 0) {
        options.cap = cap;
        found = posed_.clearance().leastClearance(motion_, options);
        queries_ += found.queries;
        if (found.time) leastTime_ = found.time;
    }
    found.lower = std::min(found.lower, atEnds.lower - jump);
    found.upper = std::min(found.upper, atEnds.upper);
    found.time = leastTime_;
    if (found.lower > 0) return hasSolids() && !isFreeAtStart() ? std::nullopt : std::optional(found);
    return leastWithoutClearance(found, options);
}

/// A pose has so little clearance that 0 is close enough a bound. Only contact is of interest then, which a search for the
/// least clearance would look for in pieces as short as the resolution.
std::optional<LeastClearance> Motion::leastWithoutClearance(LeastClearance found,
                                                            const LeastClearanceOptions& options) {
    SceneSweepOptions asked;
    asked.poseError = options.poseError;
    asked.leastInterval = options.resolution.least;
    asked.isStopped = options.isStopped;
    const SweepVerdict verdict = sweep(asked).verdict;
    const bool isValid = verdict != SweepVerdict::kContact && isFreeAtStart() && isEndValid() &&
                         (!leastTime_ || *leastTime_ == 1 || isFreeAt(*leastTime_));
    if (!isValid) return std::nullopt;
    found.lower = verdict == SweepVerdict::kCertified ? 0 : -posed_.scene().largestMargin();
    return found;
}

SolidsAlong Motion::stayOutsideSolids(double until, double leastInterval) const {
    return posed_.clearance().stayOutsideSolids(motion_, until, 0.5 * slack_, leastInterval);
}

/// Where the bounds are not convex, poses outside of them are forbidden.
PartMotion Motion::sweptMotion() {
    PartMotion motion = posed_.motion() ? posed_.motion()(s1_, s2_) : boundedMotion();
    if (posed_.areBoundsConvex()) return motion;
    motion.pieces = [this, pieces = std::move(motion.pieces)](double from, double to) {
        MotionPiece piece = pieces(from, to);
        piece.isForbidden = piece.isForbidden || !isWithinBoundsAt(from + 0.5 * (to - from));
        return piece;
    };
    return motion;
}

/// A space that only bounds displacements gives pieces that stand still at their middle pose and deviate by the bound.
PartMotion Motion::boundedMotion() {
    PartMotion motion;
    motion.length = travel();
    motion.pieces = [this, length = motion.length](double from, double to) {
        posed_.space().interpolate(s1_, s2_, from + 0.5 * (to - from), scratch_.get());
        MotionPiece piece;
        piece.middle = posed_.pose(scratch_.get());
        piece.velocity = piece.angularVelocity = Vector3::Zero();
        piece.deviation = 0.5 * (to - from) * length;
        return piece;
    };
    return motion;
}

bool Motion::isWithinBoundsAt(double time) {
    posed_.space().interpolate(s1_, s2_, time, scratch_.get());
    return posed_.si().satisfiesBounds(time == 1 ? s2_ : scratch_.get());
}

bool Motion::isEndLikeInterpolation() {
    if (isEndKnown_ && (floor_ == 0 || !jumpsAtEnd())) return true;
    if (!jumpsAtEnd() && !hasSolids()) return true;
    return isEndValid() && (floor_ == 0 || atEnd(std::numeric_limits<double>::denorm_min()).isValid());
}

bool Motion::isShort() const {
    constexpr double kShare = 0.02;  // of the part's diagonal
    return length() <= kShare * posed_.scene().part.box().diagonal().norm();
}

bool Motion::isWithinFloorBetween() {
    constexpr double kShare = 0.1;  // of the part's diagonal; shorter motions are swept as quickly
    if (floor_ == 0 || length() <= kShare * posed_.scene().part.box().diagonal().norm()) return false;
    ClearanceOptions options;
    options.cap = floor_;
    options.isRough = options.isOutside = true;
    for (const double time : {0.5, 0.25, 0.75}) {
        posed_.space().interpolate(s1_, s2_, time, scratch_.get());
        const PoseClearance found = posed_.clearance().at(posed_.pose(scratch_.get()), options);
        queries_ += found.queries;
        if (found.upper <= floor_) return true;
    }
    return false;
}

TimeSpan Motion::leavesBounds(double length) {
    if (isEndWithinBounds()) return {1, 1};
    return change({0, 1}, length,
                  [this](const ob::State* state) { return !posed_.si().satisfiesBounds(state); });
}

/// Halves the span, whose ends differ in `isTrue`, until it is shorter than a length.
template <class IsTrue>
TimeSpan Motion::change(TimeSpan span, double length, const IsTrue& isTrue) {
    while (motion_.length * (span.last - span.first) > length) {
        const double time = span.first + 0.5 * (span.last - span.first);
        if (!(time > span.first && time < span.last)) break;
        posed_.space().interpolate(s1_, s2_, time, scratch_.get());
        (isTrue(scratch_.get()) ? span.last : span.first) = time;
    }
    return span;
}

void Motion::lookAtReported(double certifiedTime, double blockedTime) {
    constexpr double kFully = std::numeric_limits<double>::infinity();
    forgetSide();
    atStart(kFully);
    if (certifiedTime == 1) {
        atEnd(kFully);
        if (leastTime_ && *leastTime_ < 1) at(*leastTime_, kFully);
        return;
    }
    forgetSide();
    if (certifiedTime > 0) at(certifiedTime, kFully);
    if (blockedTime > 0 && blockedTime < 1) at(blockedTime, kFully);
    if (blockedTime == 1) look(s2_, 1, kFully, true);
}

double Motion::longestProfiled(double clearance) const {
    constexpr double kShare = 0.02;  // of the part's diagonal: a curve through the points shows what happens
    constexpr double kClearanceShare = 0.1;  // of the clearance, which changes no faster than the pose
    const double least = kShare * posed_.scene().part.box().diagonal().norm();
    // Obstacles that count at neither end may count between them.
    if (std::isinf(clearance) && posed_.clearance().zoneCount() > 0) return least;
    return std::max(least, kClearanceShare * clearance);
}

double Motion::profileWidth() const {
    constexpr double kShare = 1e-3;
    return kShare * posed_.scene().part.box().diagonal().norm();
}

void Motion::findContactSpans(double length) {
    if (posed_.clearance().zoneCount() == 0) return;
    startContact_ = spanOf(length, [](const ContactsAt& at) { return at.isInStart; });
    goalContact_ = spanOf(length, [](const ContactsAt& at) { return at.isInGoal; });
}

template <class IsIn>
std::optional<TimeSpan> Motion::spanOf(double length, const IsIn& isIn) {
    constexpr int kPoses = 64;
    const auto isInAt = [&](const ob::State* state) {
        return isIn(posed_.clearance().contactsAt(posed_.pose(state)));
    };
    std::vector<double> within;
    for (int i = 0; i <= kPoses; ++i) {
        const double time = double(i) / kPoses;
        posed_.space().interpolate(s1_, s2_, time, scratch_.get());
        if (isInAt(i == kPoses ? s2_ : scratch_.get())) within.push_back(time);
    }
    if (within.empty()) return std::nullopt;
    TimeSpan span{within.front(), within.back()};
    const double step = 1.0 / kPoses;
    if (span.first > 0) span.first = change({span.first - step, span.first}, length, isInAt).last;
    if (span.last < 1) {
        span.last = change({span.last, span.last + step}, length, [&](const ob::State* s) {
                        return !isInAt(s);
                    }).first;
    }
    return span;
}

std::vector<MotionSample> Motion::lookAhead(double from, int poses) {
    constexpr double kFully = std::numeric_limits<double>::infinity();
    forgetSide();
    std::vector<MotionSample> samples;
    for (int i = 1; i < poses; ++i) {
        const double time = from + (1 - from) * i / poses;
        if (time > from && time < 1) samples.push_back(at(time, kFully));
    }
    samples.push_back(atEnd(kFully));
    if (samples.back().time < 1) samples.push_back(look(s2_, 1, kFully, true));  // only s2 itself is valid
    return samples;
}

MotionSample Motion::atStart(double wanted) {
    const MotionSample start = look(s1_, 0, wanted, true);
    isOutside_ = isOutside_ || start.isValid();
    return start;
}

MotionSample Motion::at(double time, double wanted) {
    posed_.space().interpolate(s1_, s2_, time, scratch_.get());
    return look(scratch_.get(), time, wanted, checksBoundsBetween_);
}

MotionSample Motion::atEnd(double wanted) {
    MotionSample end = look(s2_, 1, wanted, true);
    if (!end.isValid() || length() == 0) return end;
    isOutside_ = true;
    const double jump = findEndJump();
    const MotionSample certain = lessened(end, jump);
    const bool isCovered = certain.leeway.lower > end.leeway.lower / 2;
    if (isCovered && (detail_ != ClearanceDetail::kWhole || jump <= slack_)) return certain;
    if (!isCovered) {
        // The end's clearance does not cover the jump between the two poses: solids may lie between them.
        isOutside_ = false;
        end = look(s2_, 1, wanted, true);
    }
    const MotionSample interpolated = at(kJustBeforeEnd, wanted);
    if (!end.isValid() || !interpolated.isValid()) return end.isValid() ? interpolated : end;
    isOutside_ = true;
    return combined(certain, combined(end, interpolated, least, most), most, least);
}

double Motion::findEndJump() const {
    posed_.space().interpolate(s1_, s2_, 1, scratch_.get());
    const double jump = posed_.bound(scratch_.get(), s2_);
    if (std::isfinite(jump)) return jump;
    throw OmplRefusal("the jump at the end of the interpolation has no finite displacement bound");
}

MotionSample Motion::look(const ob::State* state, double time, double wanted, bool checksBounds) {
    if (checksBounds && !posed_.si().satisfiesBounds(state)) {
        MotionSample outside;
        outside.time = time;
        outside.isOutOfBounds = true;
        return outside;
    }
    ClearanceOptions options;
    options.isOutside = isOutside_;
    options.isRough = detail_ == ClearanceDetail::kRough;
    options.leastSlack = 2 * (length() + slack_);
    if (detail_ != ClearanceDetail::kWhole) {
        options.leastSlack = wanted;
        options.cap = wanted + floor_;
    }
    const bool isEnd = detail_ == ClearanceDetail::kWhole && (time == 0 || time == 1);
    if (isEnd && atEnds_[time == 1]) return sampleOf(time, *atEnds_[time == 1]);
    const Pose X_environmentPart = posed_.pose(state);
    PoseClearance found = posed_.clearance().at(X_environmentPart, options);
    queries_ += found.queries;
    if (options.isRough && isTooRough(found, floor_)) {
        options.isRough = false;
        found = posed_.clearance().at(X_environmentPart, options);
        queries_ += found.queries;
    }
    if (isEnd && (!options.isOutside || !hasSolids())) atEnds_[time == 1] = found;
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
    const auto aboveFloor = [this](const Bounds& clearance) {
        return Bounds{clearance.lower - floor_, clearance.upper - floor_};
    };
    constexpr double kUnbounded = std::numeric_limits<double>::infinity();
    MotionSample sample;
    sample.time = time;
    sample.lower = found.lower - floor_;
    sample.upper = found.upper - floor_;
    sample.leeway = aboveFloor(found.always);
    for (std::size_t i = 0; i < posed_.clearance().zoneCount(); ++i) {
        const Bounds& slack = found.zones[i].slack;
        const std::optional<Bounds>& known = found.zones[i].clearance;
        const Bounds clearance = known ? aboveFloor(*known) : Bounds{-kUnbounded, kUnbounded};
        sample.leeway.lower = std::min(sample.leeway.lower, std::max(clearance.lower, slack.lower));
        sample.leeway.upper = std::min(sample.leeway.upper, std::max(clearance.upper, slack.upper));
    }
    const bool isValid = sample.lower > 0;
    sample.leeway.lower = isValid ? std::max(sample.leeway.lower, std::numeric_limits<double>::denorm_min())
                                  : std::min(sample.leeway.lower, sample.lower);
    return sample;
}

}  // namespace clearway::planning
