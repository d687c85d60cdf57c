#include "clearway/planning/motion_validator.h"

#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include "core/number.h"
#include "planning/motion/motion.h"
#include "planning/motion/motion_callbacks.h"
#include "planning/motion/motion_search.h"
#include "planning/validity/scene_clearance.h"
#include "planning/validity/space_of.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// In least intervals: how near to a pose in collision the last valid one is looked for. A planner has no use
/// for more, and each halving is a query.
constexpr double kContactIntervals = 100;

constexpr double kProfiledShare = 0.8;  ///< of the clearance at a profile's points: certain between them
constexpr int kPosesAhead = 32;         ///< of a profile, beyond what is certified

double chooseLeastInterval(const Scene& scene, const MotionOptions& options) {
    if (!options.leastInterval) return defaultLeastInterval(scene);
    if (*options.leastInterval > 0 && std::isfinite(*options.leastInterval)) return *options.leastInterval;
    throw std::invalid_argument("leastInterval is " + shortNumber(*options.leastInterval) +
                                ", expected a finite length above 0");
}

/// Whether one of the two says so; each may be empty.
std::function<bool()> either(const std::function<bool()>& a, const std::function<bool()>& b) {
    if (!a || !b) return a ? a : b;
    return [a, b] { return a() || b(); };
}

/// What is certified, and a look at the rest.
std::vector<ProfilePoint> pointsOf(MotionSearch& search, const MotionReport& report) {
    std::vector<ProfilePoint> points;
    const double least = report.lowerClearance;
    for (const MotionInterval& known : search.profile(kProfiledShare)) {
        points.push_back({known.from.time, known.from.counting, std::max(known.lower, least)});
    }
    points.push_back({search.reached().time, search.reached().counting, least});
    if (report.verdict == MotionVerdict::kValid) {
        points.back().lowerToNext = points.back().clearance;
        return points;
    }
    for (const MotionSample& sample : search.lookAhead(kPosesAhead)) {
        points.push_back({sample.time, sample.counting, least});
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

MotionValidator::MotionValidator(const ob::SpaceInformationPtr& si, Scene scene, const MotionOptions& options)
    : MotionValidator(si, scene, planning::stateToPose(spaceOf(si)),
                      displacementBound(spaceOf(si), scene.part), options) {
    areBoundsConvex_ = true;
}

MotionValidator::MotionValidator(const ob::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                                 DisplacementBound bound, const MotionOptions& options)
    : ob::MotionValidator(si),
      clearance_(std::make_shared<const SceneClearance>(std::move(scene))),
      stateToPose_(std::move(stateToPose)),
      bound_(std::move(bound)),
      leastInterval_(chooseLeastInterval(clearance_->scene(), options)),
      isStopped_(options.isStopped) {
    if (!stateToPose_) throw std::invalid_argument("stateToPose is empty, expected a function");
    if (!bound_) throw std::invalid_argument("the displacement bound is empty, expected a function");
    if (clearance_->mostClearance() < leastInterval_) {
        const double margin = clearance_->scene().largestMargin();
        throw std::invalid_argument("the environment was built with a reach whose cap is " +
                                    shortNumber(clearance_->mostClearance() + margin) +
                                    ", expected at least the margin and the least interval, " +
                                    shortNumber(margin + leastInterval_));
    }
}

MotionValidator::~MotionValidator() = default;

const Scene& MotionValidator::scene() const {
    return clearance_->scene();
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

std::string MotionValidator::whyInvalid(const ob::State* state) const {
    if (!si_->satisfiesBounds(state)) return "outside of the bounds of the state space";
    return clearance_->whyInvalid(pose(state));
}

bool MotionValidator::keepsClearance(const ob::State* s1, const ob::State* s2, double more,
                                     const std::function<bool()>& isStopped) const {
    if (!(more >= 0) || !std::isfinite(more)) {
        throw std::invalid_argument("the clearance to keep is " + shortNumber(more) +
                                    ", expected a finite number >= 0");
    }
    return count(judge(s1, s2, {false, more, isStopped}));
}

/// Interpolated between two states on the bounds' border, a state may be outside by rounding.
double MotionValidator::timeWithinBounds(const ob::State* s1, const ob::State* s2, double time) const {
    if (time == 0) return time;
    const ScratchState scratch(*si_);
    si_->getStateSpace()->interpolate(s1, s2, time, scratch.get());
    return si_->satisfiesBounds(scratch.get()) ? time : 0;
}

Motion MotionValidator::motion(const ob::State* s1, const ob::State* s2, bool isReported,
                               double floor) const {
    const ClearanceDetail detail = isReported ? ClearanceDetail::kWhole : ClearanceDetail::kRough;
    return Motion({*si_, *clearance_, stateToPose_, bound_, areBoundsConvex_, detail, floor}, s1, s2);
}

MotionValidator::Outcome MotionValidator::judge(const ob::State* s1, const ob::State* s2,
                                                const Judging& judging) const {
    Outcome outcome;
    try {
        Motion looked = motion(s1, s2, false, judging.floor);
        MotionSearch search(looked, leastInterval_, kContactIntervals * leastInterval_,
                            either(judging.isStopped, isStopped_));
        outcome.verdict = judging.forward ? search.goForward() : search.certify();
        outcome.certifiedTime = search.certifiedTime();
        outcome.isStartInvalid = search.isStartInvalid();
        outcome.queries = looked.queries();
    } catch (const std::exception& error) {
        outcome = {};
        outcome.isUnusable = true;
        logOnce(error.what());
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
    report.lowerClearance = -scene().largestMargin();  // of a distance that is at least 0
    report.upperClearance = std::numeric_limits<double>::infinity();
    try {
        Motion looked = motion(s1, s2, true, 0);
        MotionSearch search(looked, leastInterval_, leastInterval_, isStopped_);
        report.verdict = search.goForward();
        report.certifiedTime = search.certifiedTime();
        if (report.verdict == MotionVerdict::kValid) {
            report.lowerClearance = search.refineLower(usualResolution(scene(), leastInterval_));
        } else {
            report.blockedTime = search.blocked().time;
            report.leavesBounds = search.blocked().isOutOfBounds;
        }
        if (profile) *profile = pointsOf(search, report);
        report.travel = looked.length();
        report.upperClearance = looked.leastUpper();
        report.closestTime = looked.closestTime();
        report.closest = looked.closest().nearest;
        report.startContact = looked.startContact();
        report.goalContact = looked.goalContact();
        report.queries = looked.queries();
    } catch (const std::exception& error) {
        report.verdict = MotionVerdict::kInvalid;
        report.certifiedTime = 0;
        report.problem = error.what();
    }
    return report;
}

bool MotionValidator::count(const Outcome& outcome) const {
    const auto add = [](std::atomic<std::uint64_t>& counter, std::uint64_t more) {
        if (more > 0) counter.fetch_add(more, std::memory_order_relaxed);
    };
    const bool valid = outcome.verdict == MotionVerdict::kValid;
    countAtomically(valid ? valid_ : invalid_);
    add(valid ? validMotions_ : invalidMotions_, 1);
    add(undecided_, outcome.verdict == MotionVerdict::kUndecided);
    add(invalidStarts_, outcome.isStartInvalid);
    add(unusable_, outcome.isUnusable);
    add(queries_, outcome.queries);
    return valid;
}

MotionCounters MotionValidator::counters() const {
    const auto read = [](const std::atomic<std::uint64_t>& counter) {
        return counter.load(std::memory_order_relaxed);
    };
    MotionCounters counters;
    counters.valid = read(validMotions_);
    counters.invalid = read(invalidMotions_);
    counters.undecided = read(undecided_);
    counters.invalidStarts = read(invalidStarts_);
    counters.unusable = read(unusable_);
    counters.queries = read(queries_);
    return counters;
}

void MotionValidator::logOnce(const std::string& problem) const {
    if (!isLogged_.exchange(true, std::memory_order_relaxed)) {
        OMPL_WARN("clearway: a motion was answered invalid: %s. Further ones are only counted.",
                  problem.c_str());
    }
}

}  // namespace clearway::planning
