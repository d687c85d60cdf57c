#include "planning/check/motion_search.h"

#include <algorithm>
#include <cmath>

namespace clearway::planning {
namespace {

constexpr double kDefaultLeastInterval = 1e-5;  ///< of the part's diagonal

constexpr double kSpareShare = 0.1;    ///< of the spare at the ends, for planning
constexpr double kFinestShare = 1e-3;  ///< of the default least interval
constexpr double kAuditShare = 1.0 / 16;

constexpr double kUsualShare = 1e-2;
constexpr double kUsualLargestShare = 0.1;
constexpr double kUsualDiagonal = 1e-3;  ///< of the part's diagonal

double diagonalOf(const Box& box) {
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// A pose's clearance is asked for as far as both halves of an interval need it. The factor covers the
/// rounding of the query's answer.
constexpr double kWantedMore = 1 + 1e-9;

/// Puts the interval with the least lower bound first: the widest stretch that is not certified.
bool isLessUrgent(const MotionInterval& a, const MotionInterval& b) {
    return a.lower > b.lower;
}

bool isBetween(double time, const MotionSample& from, const MotionSample& to) {
    return time > from.time && time < to.time;
}

double middleOf(const MotionSample& from, const MotionSample& to) {
    return from.time + 0.5 * (to.time - from.time);
}

}  // namespace

double defaultLeastInterval(const Scene& scene) {
    const double part = diagonalOf(scene.part.box());
    const double size = part > 0 ? part : diagonalOf(scene.environmentBox());
    return kDefaultLeastInterval * (size > 0 ? size : 1);
}

MotionOptions planningMotions(const Scene& scene, double spareAtEnds) {
    const double usual = defaultLeastInterval(scene);
    MotionOptions options;
    options.leastInterval = std::clamp(kSpareShare * spareAtEnds, kFinestShare * usual, usual);
    return options;
}

MotionOptions auditMotions(const Scene& scene, double spareAtEnds) {
    MotionOptions options;
    options.leastInterval = kAuditShare * *planningMotions(scene, spareAtEnds).leastInterval;
    return options;
}

ClearanceResolution usualResolution(const Scene& scene, double leastInterval) {
    return {kUsualShare, kUsualLargestShare, kUsualDiagonal * diagonalOf(scene.part.box()), leastInterval};
}

/// Stretches shorter than a few slacks are not looked into, because a slack is rounding.
MotionSearch::MotionSearch(Motion& motion, double leastInterval, double contactInterval,
                           std::function<bool()> isStopped)
    : motion_(motion),
      leastInterval_(std::max(leastInterval, 4 * motion.slack())),
      contactInterval_(std::max(contactInterval, 4 * motion.slack())),
      isStopped_(std::move(isStopped)) {}

/// Twice the room that is certain at the pose between two samples that they tell least about.
double MotionSearch::spare(const MotionSample& from, const MotionSample& to) const {
    const double rooms = from.room.lower + to.room.lower;
    if (motion_.length() == 0) return rooms;  // the part stays at s1's pose
    return rooms - motion_.length() * (to.time - from.time) - motion_.slack();
}

MotionInterval MotionSearch::interval(const MotionSample& from, const MotionSample& to) const {
    if (motion_.zoneCount() == 0) {
        return {from, to, std::min({0.5 * spare(from, to), from.room.lower, to.room.lower})};
    }
    const double way = motion_.length() == 0 ? 0 : motion_.length() * (to.time - from.time) + motion_.slack();
    const double first = from.always.lower, last = to.always.lower;
    double lower = std::min({0.5 * (first + last - way), first, last});
    // The samples themselves may have less than the way between them allows: s2 is off the end of the interpolation.
    lower = std::min({lower, from.lower, to.lower});
    for (std::size_t i = 0; i < motion_.zoneCount(); ++i) {
        lower = std::min(lower, lowerBetween(from.zones[i], to.zones[i], way));
    }
    return {from, to, lower};
}

/// When the part has moved by x from the first sample, its clearance is at least from's - x and at least to's
/// - (way - x). The zone's obstacles count only for x beyond the spare of the first sample and before the
/// spare of the last.
double MotionSearch::lowerBetween(const ZoneClearance& from, const ZoneClearance& to, double way) const {
    const double low = std::max(from.spare.lower, 0.0), high = way - std::max(to.spare.lower, 0.0);
    const bool isIgnoredThroughout = low > high || (way == 0 && from.isIgnored());
    if (isIgnoredThroughout) return std::numeric_limits<double>::infinity();
    const double first = from.clearance.lower, last = to.clearance.lower;
    const double x = std::clamp(0.5 * (way + first - last), low, high);
    return std::max(first - x, last - (way - x));
}

/// The middle of the stretch that the rooms at both ends leave open.
double MotionSearch::dividingTime(const MotionSample& from, const MotionSample& to) const {
    const double middle = middleOf(from, to);
    const double time = middle + 0.5 * (from.room.lower - to.room.lower) / motion_.length();
    return isBetween(time, from, to) ? time : middle;
}

/// The time where lower bounds are least sure. In contact zones that need not be where the room is least.
double MotionSearch::profiledTime(const MotionSample& from, const MotionSample& to) const {
    return motion_.zoneCount() == 0 ? dividingTime(from, to) : middleOf(from, to);
}

/// The room at the middle of a stretch that certifies both halves, given the length that its ends leave open.
double MotionSearch::wantedFor(double open) const {
    return (motion_.slack() + 0.5 * open) * kWantedMore;
}

double MotionSearch::wantedAtEnds() const {
    return wantedFor(motion_.length());
}

bool MotionSearch::lookAtStart(double wanted) {
    reached_ = motion_.atStart(wanted);
    isStartInvalid_ = !reached_.isValid();
    return !isStartInvalid_;
}

MotionVerdict MotionSearch::certify() {
    if (!motion_.isEndValid()) return MotionVerdict::kInvalid;
    const MotionSample end = motion_.atEnd(wantedAtEnds());
    if (!end.isValid() || !lookAtStart(wantedAtEnds())) return MotionVerdict::kInvalid;
    keepOpen(interval(reached_, end));
    while (!intervals_.empty()) {
        if (isStopped_ && isStopped_()) return MotionVerdict::kUndecided;
        const MotionSample from = intervals_.front().from, to = intervals_.front().to;
        const double open = -spare(from, to), time = dividingTime(from, to);
        if (!isBetween(time, from, to)) return MotionVerdict::kUndecided;
        const MotionSample middle = motion_.at(time, wantedFor(open));
        if (!middle.isValid()) return MotionVerdict::kInvalid;
        std::pop_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
        intervals_.pop_back();
        keepOpen(interval(from, middle));
        keepOpen(interval(middle, to));
        if (open <= leastInterval_ && !(isCertified(from, middle) && isCertified(middle, to))) {
            return MotionVerdict::kUndecided;
        }
    }
    return MotionVerdict::kValid;
}

void MotionSearch::keepOpen(const MotionInterval& added) {
    if (added.lower > 0) return;
    intervals_.push_back(added);
    std::push_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
}

MotionVerdict MotionSearch::goForward() {
    if (!lookAtStart(wantedAtEnds())) return blocked_ = reached_, MotionVerdict::kInvalid;
    std::vector<MotionSample> ahead{motion_.atEnd(wantedAtEnds())};
    while (!ahead.empty()) {
        const MotionSample next = ahead.back();
        if (isStopped_ && isStopped_()) return blocked_ = next, MotionVerdict::kUndecided;
        if (next.isValid() && isCertified(reached_, next)) {
            advance(next);
            ahead.pop_back();
            continue;
        }
        const Stretch stretch = stretchBefore(next);
        const double stop = next.isValid() ? leastInterval_ : contactInterval_;
        const bool isShort = stretch.open <= stop;
        if (!isBetween(stretch.time, reached_, next) || (isShort && !next.isValid())) {
            stopBefore(next, stop);
            return verdictBefore(ahead);
        }
        const MotionSample middle = motion_.at(stretch.time, wantedFor(stretch.open));
        if (isShort && middle.isValid() && !(isCertified(reached_, middle) && isCertified(middle, next))) {
            if (isCertified(reached_, middle)) advance(middle);
            stopBefore(next, stop);
            return verdictBefore(ahead);
        }
        ahead.push_back(middle);
    }
    return MotionVerdict::kValid;
}

/// Before a grazing contact, the stretch just ahead of the collision may be too close to decide. The
/// collision is reported all the same.
MotionVerdict MotionSearch::verdictBefore(const std::vector<MotionSample>& ahead) {
    const auto invalid = std::find_if(ahead.rbegin(), ahead.rend(),
                                      [](const MotionSample& sample) { return !sample.isValid(); });
    if (invalid == ahead.rend()) return MotionVerdict::kUndecided;
    blocked_ = *invalid;
    return MotionVerdict::kInvalid;
}

/// Before a pose in collision only the last sample's room certifies anything. Where the motion leaves the
/// bounds is found by halving.
MotionSearch::Stretch MotionSearch::stretchBefore(const MotionSample& next) const {
    if (next.isOutOfBounds) {
        const double step = next.time - reached_.time;
        return {motion_.length() * step, reached_.time + 0.5 * step};
    }
    MotionSample sample;
    sample.time = next.time;
    sample.room.lower = std::max(next.room.lower, 0.0);
    return {-spare(reached_, sample), dividingTime(reached_, sample)};
}

void MotionSearch::advance(const MotionSample& next) {
    intervals_.push_back(interval(reached_, next));
    reached_ = next;
}

/// Adds what the last sample alone certifies beyond itself, less half a stop. The last valid pose keeps that
/// half as clearance, because a planner goes on from there.
void MotionSearch::stopBefore(const MotionSample& blocked, double stop) {
    blocked_ = blocked;
    const double certain = reached_.room.lower - 0.5 * stop;
    const double time = reached_.time + certain / motion_.length();
    if (certain <= 0.5 * stop || !isBetween(time, reached_, blocked)) return;
    const MotionSample last = motion_.at(time, stop);
    if (last.isValid()) advance(last);
}

double MotionSearch::refineLower(const ClearanceResolution& resolution) {
    std::make_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
    double least = reached_.lower;
    for (const MotionInterval& known : intervals_) least = std::min(least, known.from.lower);
    refine(least, resolution);
    return intervals_.front().lower;
}

std::optional<double> MotionSearch::leastClearance(double cap, const ClearanceResolution& resolution,
                                                   bool isForReverse) {
    const double wanted = cap + wantedAtEnds();
    const MotionSample end = motion_.atEnd(wanted);
    if (!end.isValid() || !lookAtStart(wanted)) return std::nullopt;
    intervals_ = {interval(reached_, end)};
    if (!refine(std::min({cap, reached_.lower, end.lower}), resolution)) return std::nullopt;
    const double jump = isForReverse ? motion_.slack() + motion_.endJump() : 0;
    return intervals_.front().lower - jump;
}

/// Divides the interval with the least lower bound until that bound is known well enough. least: the
/// clearance of some pose of the motion; each new pose is asked for as much as certifies that clearance in
/// both halves. Returns false when a pose is invalid.
bool MotionSearch::refine(double least, const ClearanceResolution& resolution) {
    // An infinite least means that nothing counts at the poses looked at so far; something may between them.
    const auto isKnown = [&](double lower) {
        if (std::isinf(least)) return std::isinf(lower);
        return lower >= least - std::max(resolution.of(least), leastInterval_);
    };
    while (!isKnown(intervals_.front().lower)) {
        const MotionSample from = intervals_.front().from, to = intervals_.front().to;
        const double time = profiledTime(from, to);
        if (!isBetween(time, from, to)) break;
        const double open = 2 * least - spare(from, to);
        const MotionSample middle = motion_.at(time, least + wantedFor(open));
        if (!middle.isValid()) return false;
        least = std::min(least, middle.upper);
        std::pop_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
        intervals_.back() = interval(from, middle);
        std::push_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
        intervals_.push_back(interval(middle, to));
        std::push_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
    }
    return true;
}

std::vector<MotionInterval> MotionSearch::profile(double share) {
    std::vector<MotionInterval> open = intervals_, settled;
    while (!open.empty()) {
        const auto [from, to, lower] = open.back();
        open.pop_back();
        const double time = profiledTime(from, to);
        const bool isShort = motion_.length() * (to.time - from.time) <= leastInterval_;
        if (lower >= share * std::min(from.room.lower, to.room.lower) || isShort ||
            !isBetween(time, from, to) || (isStopped_ && isStopped_())) {
            settled.push_back({from, to, lower});
            continue;
        }
        const MotionSample middle = motion_.at(time, std::numeric_limits<double>::infinity());
        open.push_back(interval(from, middle));
        open.push_back(interval(middle, to));
    }
    std::sort(settled.begin(), settled.end(),
              [](const MotionInterval& a, const MotionInterval& b) { return a.from.time < b.from.time; });
    return settled;
}

}  // namespace clearway::planning
