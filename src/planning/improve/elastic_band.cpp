#include "planning/improve/elastic_band.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "clearway/errors.h"
#include "clearway/scene_clearance.h"
#include "core/number.h"
#include "planning/improve/band_states.h"
#include "planning/improve/kept_clearance.h"

namespace clearway::planning {
namespace {

constexpr int kSweepsPerCheck = 4, kSweepsPerStage = 16;
constexpr double kStageGain = 1.005;  ///< a stage that raises the clearance by less has stopped to gain
constexpr double kRoughKept = 0.1;    ///< so close is the clearance known that the band begins with
constexpr double kNearlyMost = 0.999;

// Each stage without gain by free and one by certified moves makes the steps finer by these factors.
constexpr double kGainLoss = 0.6, kLeastGain = 0.004;
constexpr double kFirstSpacing = 1.5, kSpacingLoss = 0.8, kLeastSpacing = 0.3;  ///< of the clearance aimed at
constexpr double kFirstSmoothing = 0.5, kSmoothingLoss = 0.8, kLeastSmoothing = 0.02;

constexpr double kLeastRise = 0.002;  ///< of the part's radius; what is aimed at is so much more at least
constexpr double kShortestSpacing = 0.05;  ///< of the part's radius
constexpr double kMostAhead = 4;           ///< of the clearance kept; states may have gained so much more
constexpr double kMostAimed = 1.02;        ///< of the most, so that the states may reach it
constexpr double kSureShare = 0.02;      ///< of what the states have more than the motions keep, tried first
constexpr int kBisections = 4;           ///< from there to all of it
constexpr double kNear = 2;              ///< times the clearance aimed at; planes farther away do not count
constexpr double kCapSlack = 1.3;        ///< so that a state that moves a little needs no query again
constexpr std::size_t kMostPlanes = 10;  ///< that a state remembers
constexpr double kLikePlane = 0.1;       ///< between the rows of planes that replace each other
constexpr double kStale = 0.5, kSlack = 0.02;  ///< planes closer than this share of the gap have been passed
constexpr double kLongestPull = 0.5;           ///< of the clearance aimed at
constexpr double kLongestMove = 0.4;           ///< of the gap
constexpr int kMoveTries = 3;                  ///< of a certified move, each a share of the one before
constexpr double kNextTry = 0.4;

class Band {
  public:
    Band(og::PathGeometric& path, const MotionValidator& validator, const WideningOptions& options)
        : path_(path),
          si_(*path.getSpaceInformation()),
          validator_(validator),
          options_(options),
          clearance_(validator.scene()),
          moves_(*si_.getStateSpace(), validator.scene().part),
          states_(si_, validator, moves_, options_.isSpent),
          kept_(options.clearance),
          start_(clearanceAt(0)),
          goal_(clearanceAt(path.getStateCount() - 1)),
          most_(std::min({options.enough, 2 * moves_.radius(), start_, goal_})),
          gain_(options.gain) {}

    double run() {
        if (!isOver()) kept_ = keptClearance(path_, validator_, {kept_, most_, kRoughKept, options_.isSpent});
        takePath();
        for (int idle = 0; idle < options_.idleStages && !isOver();) {
            const double before = kept_;
            runStage();
            if (kept_ > kStageGain * before) {
                idle = 0;
                continue;
            }
            ++idle;
            if (isCertified_) makeFiner();
            isCertified_ = !isCertified_;
            takePath();
        }
        return kept_;
    }

  private:
    bool isSpent() const { return options_.isSpent && options_.isSpent(); }

    bool isOver() const {
        return kept_ >= kNearlyMost * most_ || (options_.sweeps && sweeps_ >= *options_.sweeps) || isSpent();
    }

    double clearanceAt(std::size_t i) const {
        return clearance_.at(moves_.pose(path_.getState(static_cast<unsigned int>(i)))).lower;
    }

    void takePath() {
        reached_ = 0;
        states_.takeFrom(path_);
        states_[0].clearance = start_;
        states_[states_.count() - 1].clearance = goal_;
    }

    /// More than the motions keep, and than the states have: so the states rise sweep by sweep, while the motions between
    /// them, which cost more, are asked now and then.
    double aimed() const {
        const double base = std::max(kept_, reached_);
        return std::min(kMostAimed * most_, base + std::max(gain_ * base, kLeastRise * moves_.radius()));
    }

    /// With certified moves all motions of the band keep this; with free ones only those of path_ do.
    std::optional<double> floor() const { return isCertified_ ? std::optional<double>(kept_) : std::nullopt; }

    void makeFiner() {
        gain_ = std::max(std::min(gain_, kLeastGain), kGainLoss * gain_);
        spacing_ = std::max(kLeastSpacing, kSpacingLoss * spacing_);
        smoothing_ = std::max(kLeastSmoothing, kSmoothingLoss * smoothing_);
    }

    void runStage() {
        for (int k = 0; k < kSweepsPerStage && !isOver(); ++k) {
            const double shortest = kShortestSpacing * moves_.radius();
            states_.respace(std::max(spacing_ * aimed(), shortest), floor());
            sweep();
            if (++sweeps_ % kSweepsPerCheck == 0 && !isSpent()) raise(leastGap_);
        }
    }

    /// Keeps the band as the path when all its motions keep more, and finds out how much, up to `most`.
    void raise(double most) {
        double high = std::min(most, most_), low = kept_ + kSureShare * (high - kept_);
        if (!(low > kept_)) return;
        if (!states_.allKeep(low)) {
            if (!isSpent()) states_.divideTight(low, floor());
            return;
        }
        for (int k = 0; k < kBisections && !isSpent(); ++k) {
            const double middle = 0.5 * (low + high);
            (states_.allKeep(middle) ? low : high) = middle;
        }
        kept_ = low;
        states_.copyTo(path_);
        if (options_.onGain) options_.onGain(kept_);
    }

    void sweep() {
        leastGap_ = most_;
        const std::size_t inner = states_.count() - 2;
        for (std::size_t k = 0; k < inner && !isSpent(); ++k) move(isForward_ ? k + 1 : inner - k);
        reached_ = std::min(leastGap_, kMostAhead * kept_);
        isForward_ = !isForward_;
    }

    void move(std::size_t i) {
        const Pose X_environmentPart = moves_.pose(states_[i].get());
        const double gap = lookAround(states_[i], X_environmentPart);
        leastGap_ = std::min(leastGap_, gap);
        if (gap <= 0 && states_[i].planes.empty()) {
            if (!isCertified_) moveBetweenNeighbours(i);
            return;
        }
        Twist twist = nearestKeeping(aimed(), rowsAt(i, X_environmentPart, gap), pullAt(i));
        const double longest = std::max(kLongestMove * gap, kSlack * aimed());
        if (twist.norm() > longest) twist *= longest / twist.norm();
        take(i, twist);
    }

    /// A part that collides has no plane that would push it out.
    void moveBetweenNeighbours(std::size_t i) {
        si_.getStateSpace()->interpolate(states_[i - 1].get(), states_[i + 1].get(), 0.5, states_[i].get());
        states_[i].clearance = 0;
    }

    /// Returns the gap of the closest pair, or a lower bound of it above what matters.
    double lookAround(BandState& state, const Pose& X_environmentPart) {
        const double near = kNear * aimed();
        if (state.clearance > near) return state.clearance;
        ClearanceOptions options;
        options.cap = kCapSlack * near;
        options.isRough = true;
        options.isOutside = true;
        const PoseClearance found = clearance_.at(X_environmentPart, options);
        state.clearance = found.lower;
        const auto plane = contactPlaneOf(found.nearest, clearance_.scene(), X_environmentPart);
        if (!plane) return found.lower;
        remember(state, *plane, X_environmentPart);
        return rowAt(*plane, moves_, X_environmentPart).gap;
    }

    void remember(BandState& state, const ContactPlane& plane, const Pose& X_environmentPart) const {
        const Twist row = rowAt(plane, moves_, X_environmentPart).row;
        for (ContactPlane& known : state.planes) {
            if ((rowAt(known, moves_, X_environmentPart).row - row).norm() < kLikePlane) {
                known = plane;
                return;
            }
        }
        if (state.planes.size() == kMostPlanes) state.planes.erase(state.planes.begin());
        state.planes.push_back(plane);
    }

    /// The planes of the neighbours count too: else states would dodge to and fro between planes.
    std::vector<ContactRow> rowsAt(std::size_t i, const Pose& X_environmentPart, double gap) const {
        const double nearest = kStale * gap - kSlack * aimed(), farthest = kNear * aimed();
        std::vector<ContactRow> rows;
        for (std::size_t k = i - 1; k <= i + 1; ++k) {
            for (const ContactPlane& plane : states_[k].planes) {
                const ContactRow row = rowAt(plane, moves_, X_environmentPart);
                if (row.gap >= nearest && row.gap <= farthest) rows.push_back(row);
            }
        }
        return rows;
    }

    /// Towards the middle of the neighbours.
    Twist pullAt(std::size_t i) const {
        const ob::State* state = states_[i].get();
        Twist pull =
            0.5 * smoothing_ *
            (moves_.between(state, states_[i - 1].get()) + moves_.between(state, states_[i + 1].get()));
        const double longest = kLongestPull * aimed();
        if (pull.norm() > longest) pull *= longest / pull.norm();
        return pull;
    }

    void take(std::size_t i, Twist twist) {
        const ScratchState next(si_);
        for (int k = 0; k < (isCertified_ ? kMoveTries : 1); ++k, twist *= kNextTry) {
            moves_.move(states_[i].get(), twist, next.get());
            si_.enforceBounds(next.get());
            const double clearance = std::max(0.0, states_[i].clearance - states_.displacementOf(twist));
            if (isCertified_ && !staysCertified(i, next.get(), clearance)) continue;
            si_.copyState(states_[i].get(), next.get());
            states_[i].clearance = clearance;
            return;
        }
    }

    bool staysCertified(std::size_t i, const ob::State* next, double clearance) const {
        const auto isSure = [&](const BandState& other) {
            const double way = states_.displacementOf(moves_.between(other.get(), next));
            return 0.5 * (other.clearance + clearance - way) > kept_;
        };
        const BandState &before = states_[i - 1], &after = states_[i + 1];
        return (isSure(before) || states_.keeps(before.get(), next, kept_)) &&
               (isSure(after) || states_.keeps(next, after.get(), kept_));
    }

    og::PathGeometric& path_;
    const ob::SpaceInformation& si_;
    const MotionValidator& validator_;
    const WideningOptions& options_;
    SceneClearance clearance_;
    PartMoves moves_;
    BandStates states_;
    double kept_, start_, goal_, most_;
    double gain_, spacing_ = kFirstSpacing, smoothing_ = kFirstSmoothing;
    double leastGap_ = 0;  ///< of the states before the last sweep moved them
    double reached_ = 0;   ///< of that, what counts for the next aim
    std::uint64_t sweeps_ = 0;
    bool isForward_ = true, isCertified_ = false;
};

}  // namespace

double widenPath(og::PathGeometric& path, const MotionValidator& validator, const WideningOptions& options) {
    requireNotNegative("the clearance kept", options.clearance);
    if (!(options.gain > 0)) {
        throw ArgumentError("the gain is " + shortNumber(options.gain) + ", expected a number > 0");
    }
    if (path.getStateCount() < 2) return options.clearance;
    return Band(path, validator, options).run();
}

}  // namespace clearway::planning
