#include "planning/motion/motion_search.h"

#include <algorithm>
#include <cmath>

namespace clearway::planning {
namespace {

constexpr double kDefaultLeastInterval = 1e-5;  ///< of the part's diagonal

constexpr double kUsualShare = 1e-2;
constexpr double kUsualLargestShare = 0.1;
constexpr double kUsualDiagonal = 1e-3;  ///< of the part's diagonal

double diagonalOf(const Box& box) {
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// A pose's clearance is asked for as far as both halves of an interval need it, and this much more, for the
/// query's answer is rounded.
constexpr double kWantedMore = 1 + 1e-9;

/// The heap's first: with the least lower bound, which is the widest stretch that is not certified.
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

ClearanceResolution usualResolution(const Scene& scene, double leastInterval) {
    return {kUsualShare, kUsualLargestShare, kUsualDiagonal * diagonalOf(scene.part.box()), leastInterval};
}

MotionSearch::MotionSearch(Motion& motion, double leastInterval, double contactInterval,
                           std::function<bool()> isStopped)
    : motion_(motion),
      leastInterval_(leastInterval),
      contactInterval_(contactInterval),
      isStopped_(std::move(isStopped)) {}

/// A slack is rounding: what is shorter is not looked into.
void MotionSearch::measure() {
    motion_.measure();
    leastInterval_ = std::max(leastInterval_, 4 * motion_.slack());
    contactInterval_ = std::max(contactInterval_, 4 * motion_.slack());
}

/// Twice what is certain at the pose that the clearances of both ends tell least about.
double MotionSearch::spare(const MotionSample& from, const MotionSample& to) const {
    if (motion_.length() == 0) return from.clearance + to.clearance;  // s1's own pose throughout
    return from.clearance + to.clearance - motion_.length() * (to.time - from.time) - motion_.slack();
}

MotionInterval MotionSearch::interval(const MotionSample& from, const MotionSample& to) const {
    if (motion_.zoneCount() == 0) {
        return {from, to, std::min({0.5 * spare(from, to), from.clearance, to.clearance})};
    }
    const double way = motion_.length() == 0 ? 0 : motion_.length() * (to.time - from.time) + motion_.slack();
    double lower = std::min({0.5 * (from.always + to.always - way), from.always, to.always});
    for (std::size_t i = 0; i < motion_.zoneCount(); ++i) {
        lower = std::min(lower, lowerBetween(from.zones[i], to.zones[i], way));
    }
    return {from, to, lower};
}

/// Having moved by x, the part is at least from.clearance - x away, and no less than to.clearance - (way -
/// x). It counts for x between what it is ignored for after one sample and before the other.
double MotionSearch::lowerBetween(const ZoneRoom& from, const ZoneRoom& to, double way) const {
    const double low = std::max(from.spare, 0.0), high = way - std::max(to.spare, 0.0);
    const bool isIgnoredThroughout = low > high || (way == 0 && from.isIgnored());
    if (isIgnoredThroughout) return std::numeric_limits<double>::infinity();
    const double x = std::clamp(0.5 * (way + from.clearance - to.clearance), low, high);
    return std::max(from.clearance - x, to.clearance - (way - x));
}

/// The middle of what the ends' clearances leave open, where they tell least.
double MotionSearch::dividingTime(const MotionSample& from, const MotionSample& to) const {
    const double middle = middleOf(from, to);
    const double time = middle + 0.5 * (from.clearance - to.clearance) / motion_.length();
    return isBetween(time, from, to) ? time : middle;
}

/// Where lower bounds are least sure. In contact zones that is another place than where the motion is.
double MotionSearch::profiledTime(const MotionSample& from, const MotionSample& to) const {
    return motion_.zoneCount() == 0 ? dividingTime(from, to) : middleOf(from, to);
}

/// The clearance with which both halves of a stretch are certified that its ends leave open so far.
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
    measure();
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
    measure();
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

/// Where the part comes near by grazing, it may be too close to tell before it collides.
MotionVerdict MotionSearch::verdictBefore(const std::vector<MotionSample>& ahead) {
    const auto invalid = std::find_if(ahead.rbegin(), ahead.rend(),
                                      [](const MotionSample& sample) { return !sample.isValid(); });
    if (invalid == ahead.rend()) return MotionVerdict::kUndecided;
    blocked_ = *invalid;
    return MotionVerdict::kInvalid;
}

/// Before a pose in collision only the last sample's clearance certifies anything; how far the bounds reach
/// is found by halving.
MotionSearch::Stretch MotionSearch::stretchBefore(const MotionSample& next) const {
    if (next.isOutOfBounds) {
        const double step = next.time - reached_.time;
        return {motion_.length() * step, reached_.time + 0.5 * step};
    }
    MotionSample sample;
    sample.time = next.time;
    sample.clearance = std::max(next.clearance, 0.0);
    return {-spare(reached_, sample), dividingTime(reached_, sample)};
}

void MotionSearch::advance(const MotionSample& next) {
    intervals_.push_back(interval(reached_, next));
    reached_ = next;
}

/// What the last sample alone certifies beyond itself counts too, but for half a stop, which the last valid
/// pose keeps as clearance: a planner goes on from there.
void MotionSearch::stopBefore(const MotionSample& blocked, double stop) {
    blocked_ = blocked;
    const double certain = reached_.clearance - 0.5 * stop;
    const double time = reached_.time + certain / motion_.length();
    if (certain <= 0.5 * stop || !isBetween(time, reached_, blocked)) return;
    const MotionSample last = motion_.at(time, stop);
    if (last.isValid()) reached_ = last;
}

double MotionSearch::refineLower(const ClearanceResolution& resolution) {
    std::make_heap(intervals_.begin(), intervals_.end(), isLessUrgent);
    double least = reached_.counting;
    for (const MotionInterval& known : intervals_) least = std::min(least, known.from.counting);
    refine(least, resolution);
    return intervals_.front().lower;
}

std::optional<double> MotionSearch::leastClearance(double cap, const ClearanceResolution& resolution) {
    measure();
    const double wanted = cap + wantedAtEnds();
    const MotionSample end = motion_.atEnd(wanted);
    if (!end.isValid() || !lookAtStart(wanted)) return std::nullopt;
    intervals_ = {interval(reached_, end)};
    if (!refine(std::min({cap, reached_.counting, end.counting}), resolution)) return std::nullopt;
    return intervals_.front().lower;
}

/// Divides the interval of the least lower bound until that is known well enough, given a pose of so little
/// clearance. A pose is asked for as much as certifies that clearance in both halves. False when one is
/// invalid.
bool MotionSearch::refine(double least, const ClearanceResolution& resolution) {
    // Infinite: nothing counts at the poses looked at so far, but between them something may.
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
        least = std::min(least, middle.countingUpper);
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
        if (lower >= share * std::min(from.clearance, to.clearance) || isShort ||
            !isBetween(time, from, to)) {
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

std::vector<MotionSample> MotionSearch::lookAhead(int poses) {
    constexpr double kFully = std::numeric_limits<double>::infinity();
    motion_.forgetOutside();
    std::vector<MotionSample> samples;
    for (int i = 1; i < poses; ++i) {
        const double time = reached_.time + (1 - reached_.time) * i / poses;
        if (time > reached_.time && time < 1) samples.push_back(motion_.at(time, kFully));
    }
    samples.push_back(motion_.atEnd(kFully));
    return samples;
}

}  // namespace clearway::planning
