#include "clearway/planning/motion_validator.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "clearway/errors.h"
#include "core/number.h"
#include "planning/check/motion.h"
#include "planning/check/motion_resolution.h"
#include "planning/check/motion_sweep.h"
#include "planning/check/posed_scene.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// How near to a pose in collision the last valid pose is looked for, in least intervals. A planner has no
/// use for a closer pose, and each halving is a query.
constexpr double kContactIntervals = 100;

constexpr double kProfiledShare =
    0.8;                         ///< of the clearance at a profile's points that is certain between them
constexpr int kPosesAhead = 32;  ///< in a profile, after the certified part of the motion

double chooseLeastInterval(const Scene& scene, const MotionOptions& options) {
    if (!options.leastInterval) return defaultLeastInterval(scene);
    if (*options.leastInterval > 0 && std::isfinite(*options.leastInterval)) return *options.leastInterval;
    throw ArgumentError("leastInterval is " + shortNumber(*options.leastInterval) +
                        ", expected a finite length above 0");
}

/// True when one of the two returns true; each may be empty.
std::function<bool()> either(const std::function<bool()>& a, const std::function<bool()>& b) {
    if (!a || !b) return a ? a : b;
    return [a, b] { return a() || b(); };
}

/// The points of the certified part of a motion, and some poses of the rest.
std::vector<ProfilePoint> pointsOf(MotionSweep& sweep, Motion& motion, const MotionReport& report) {
    std::vector<ProfilePoint> points;
    const double least = report.lowerClearance;
    for (const MotionInterval& known : sweep.profile(kProfiledShare)) {
        points.push_back({known.from.time, known.from.lower, std::max(known.lower, least)});
    }
    const MotionSample reached = sweep.reached();
    points.push_back({reached.time, reached.lower, least});
    if (report.verdict == MotionVerdict::kValid) {
        points.back().lowerToNext = points.back().clearance;
        return points;
    }
    for (const MotionSample& sample : motion.lookAhead(reached.time, kPosesAhead)) {
        points.push_back({sample.time, sample.lower, least});
    }
    return points;
}

}  // namespace

struct MotionValidator::Outcome {
    MotionVerdict verdict = MotionVerdict::kInvalid;
    double certifiedTime = 0;
    bool isStartInvalid = false;
    bool isUnusable = false;
    std::uint64_t queries = 0;
};

MotionValidator::MotionValidator(const ob::SpaceInformationPtr& si, SharedScene shared,
                                 const MotionOptions& options)
    : ob::MotionValidator(si),
      posed_(std::make_shared<const PosedScene>(si, std::move(shared), PosedScene::For::kMotions)),
      leastInterval_(chooseLeastInterval(scene(), options)),
      isStopped_(options.isStopped) {
    const double most = posed_->clearance().mostClearance();
    if (most < leastInterval_) {
        const double margin = scene().largestMargin();
        throw ArgumentError(
            "the environment was built with a range whose cap is " + shortNumber(most + margin) +
            ", expected at least the margin and the least interval, " + shortNumber(margin + leastInterval_));
    }
}

MotionValidator::~MotionValidator() = default;

const Scene& MotionValidator::scene() const {
    return posed_->scene();
}

const SharedScene& MotionValidator::shared() const {
    return posed_->shared();
}

Pose MotionValidator::pose(const ob::State* state) const {
    return posed_->pose(state);
}

bool MotionValidator::checkMotion(const ob::State* s1, const ob::State* s2) const {
    return count(judge(s1, s2, {}));
}

bool MotionValidator::checkMotion(const ob::State* s1, const ob::State* s2,
                                  std::pair<ob::State*, double>& lastValid) const {
    const Outcome outcome = judge(s1, s2, {true, 0, {}});
    if (outcome.verdict != MotionVerdict::kValid) {
        setLastValid(*si_, s1, s2, timeWithinBounds(s1, s2, outcome.certifiedTime), lastValid);
    }
    return count(outcome);
}

double MotionValidator::validUntil(const ob::State* s1, const ob::State* s2,
                                   const ForwardOptions& options) const {
    const Outcome outcome = judge(s1, s2, {true, options.more, {}, options.within});
    return count(outcome) ? 1 : timeWithinBounds(s1, s2, outcome.certifiedTime);
}

WhyInvalid MotionValidator::whyInvalid(const ob::State* state) const {
    return posed_->whyInvalid(state);
}

/// A motion that is not valid although no pose is known to be invalid is undecided.
WhyInvalid MotionValidator::whyBlocked(const ob::State* s1, const ob::State* s2, double time) const {
    const ScratchState scratch(*si_);
    if (time > 0 && time < 1) si_->getStateSpace()->interpolate(s1, s2, time, scratch.get());
    WhyInvalid why = whyInvalid(time == 0 ? s1 : time == 1 ? s2 : scratch.get());
    if (why.isValid()) why.kind = WhyInvalid::Kind::kUndecided;
    return why;
}

/// A state that cannot be judged is the reason, if there is one.
WhyInvalid MotionValidator::whyUnusable(const ob::State* s1, const ob::State* s2, const char* reason) const {
    WhyInvalid why;
    why.kind = WhyInvalid::Kind::kUnusable;
    for (const ob::State* state : {s2, s1}) {
        const WhyInvalid ofState = whyInvalid(state);
        if (ofState.isUnusable()) why.kind = ofState.kind;
    }
    why.reason = reason;
    return why;
}

bool MotionValidator::keepsClearance(const ob::State* s1, const ob::State* s2, double more,
                                     const std::function<bool()>& isStopped) const {
    requireNotNegative("the clearance to keep", more);
    return count(judge(s1, s2, {false, more, isStopped}));
}

/// A state interpolated between two states on the border of the bounds may be outside by rounding.
double MotionValidator::timeWithinBounds(const ob::State* s1, const ob::State* s2, double time) const {
    if (time == 0) return time;
    const ScratchState scratch(*si_);
    si_->getStateSpace()->interpolate(s1, s2, time, scratch.get());
    return si_->satisfiesBounds(scratch.get()) ? time : 0;
}

MotionValidator::Outcome MotionValidator::judge(const ob::State* s1, const ob::State* s2,
                                                const Judging& judging) const {
    Outcome outcome;
    try {
        Motion looked(*posed_, ClearanceDetail::kRough, judging.floor, s1, s2);
        const auto isStopped = either(judging.isStopped, isStopped_);
        const double contactInterval = std::max(judging.within, kContactIntervals * leastInterval_);
        // To judge the end is by far the cheapest test of a motion whose length is not cheap.
        if (posed_->motion() || judging.forward || looked.isEndValid()) {
            looked.measure();
            MotionSweep sweep(looked, leastInterval_, contactInterval, isStopped);
            outcome.verdict = judging.forward ? sweep.goForward() : sweep.certify();
            outcome.certifiedTime = sweep.certifiedTime();
            outcome.isStartInvalid = sweep.isStartInvalid();
        }
        outcome.queries = looked.queries();
    } catch (const std::exception& error) {
        outcome = {};
        outcome.isUnusable = true;
        posed_->warnOnce("a motion was answered invalid", error.what());
    }
    return outcome;
}

MotionReport MotionValidator::report(const ob::State* s1, const ob::State* s2) const {
    return report(s1, s2, nullptr);
}

MotionProfile MotionValidator::profile(const ob::State* s1, const ob::State* s2) const {
    MotionProfile profile;
    profile.report = report(s1, s2, &profile.points);
    return profile;
}

MotionReport MotionValidator::report(const ob::State* s1, const ob::State* s2,
                                     std::vector<ProfilePoint>* profile) const {
    MotionReport report;
    report.lowerClearance = -scene().largestMargin();  // because a distance is at least 0
    report.upperClearance = std::numeric_limits<double>::infinity();
    try {
        Motion looked(*posed_, ClearanceDetail::kWhole, 0, s1, s2);
        looked.measure();
        MotionSweep sweep(looked, leastInterval_, leastInterval_, isStopped_);
        report.verdict = sweep.goForwardToReport(usualResolution(scene(), leastInterval_));
        report.certifiedTime = sweep.certifiedTime();
        if (report.verdict == MotionVerdict::kValid) {
            report.lowerClearance = sweep.refineLower(usualResolution(scene(), leastInterval_));
        } else {
            report.blockedTime = sweep.blockedTime();
        }
        if (profile) *profile = pointsOf(sweep, looked, report);
        looked.lookAtReported(report.certifiedTime, report.blockedTime);
        looked.findContactSpans(leastInterval_);
        report.travel = looked.travel();
        report.upperClearance = looked.leastUpper();
        report.closestTime = looked.closestTime();
        report.closest = looked.closest().nearest;
        report.startContact = looked.startContact();
        report.goalContact = looked.goalContact();
        report.queries = looked.queries();
        if (report.verdict != MotionVerdict::kValid)
            report.whyInvalid = whyBlocked(s1, s2, report.blockedTime);
    } catch (const std::exception& error) {
        report.verdict = MotionVerdict::kInvalid;
        report.certifiedTime = 0;
        report.whyInvalid = whyUnusable(s1, s2, error.what());
    }
    return report;
}

bool MotionValidator::count(const Outcome& outcome) const {
    const bool valid = outcome.verdict == MotionVerdict::kValid;
    countAtomically(valid ? valid_ : invalid_);
    posed_->count(valid ? Count::kValid : Count::kInvalid);
    posed_->count(Count::kUndecided, outcome.verdict == MotionVerdict::kUndecided);
    posed_->count(Count::kInvalidStarts, outcome.isStartInvalid);
    posed_->count(Count::kUnusable, outcome.isUnusable);
    posed_->count(Count::kQueries, outcome.queries);
    return valid;
}

MotionCounters MotionValidator::counters() const {
    MotionCounters counters;
    counters.valid = posed_->counted(Count::kValid);
    counters.invalid = posed_->counted(Count::kInvalid);
    counters.undecided = posed_->counted(Count::kUndecided);
    counters.invalidStarts = posed_->counted(Count::kInvalidStarts);
    counters.unusable = posed_->counted(Count::kUnusable);
    counters.queries = posed_->counted(Count::kQueries);
    return counters;
}

}  // namespace clearway::planning
