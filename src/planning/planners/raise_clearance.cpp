#include "planning/planners/raise_clearance.h"

#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "clearway/planning/validity_checker.h"
#include "planning/validity/ompl_states.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr int kTries = 6;        ///< moves tried for a state in a round
constexpr int kIdleRounds = 12;  ///< this many rounds in a row without gain are the last
constexpr double kGain = 1;      ///< the first gain tried, as a share of the clearance
constexpr double kLeastGain = 5e-3;
constexpr double kRoomy = 2;  ///< times the path's clearance; states that have more are not moved
constexpr double kLongestMove = 1e-2, kShortestMove = 1e-4;  ///< of the part's diagonal
constexpr double kNearEnd = 0.1;  ///< of a motion; a new state so close to its end would change nothing

class Raiser {
  public:
    Raiser(og::PathGeometric& path, const MotionValidator& validator, const RaiseOptions& options)
        : path_(path),
          si_(path.getSpaceInformation()),
          validator_(validator),
          options_(options),
          checker_(si_, validator.scene()),
          sampler_(si_->allocStateSampler()),
          kept_(options.clearance) {
        const double diagonal = validator.scene().part.box().diagonal().norm();
        shortest_ = kShortestMove * diagonal;
        longest_ = kLongestMove * diagonal;
    }

    double run() {
        for (int idle = 0; idle < kIdleRounds && !isOver();) {
            const double before = kept_;
            raiseKept();
            divideTightest();
            for (std::size_t i = 1; i + 1 < path_.getStateCount() && !isOver(); ++i) move(i);
            idle = kept_ > before ? 0 : idle + 1;
        }
        return kept_;
    }

  private:
    bool isOver() const { return kept_ >= options_.enough || (options_.isSpent && options_.isSpent()); }

    bool keeps(std::size_t motion, double clearance) const {
        return validator_.keepsClearance(path_.getState(motion), path_.getState(motion + 1), clearance,
                                         options_.isSpent);
    }

    /// Remembers the first motion that does not keep the clearance. The search begins with the one found
    /// last.
    bool allKeep(double clearance) {
        const std::size_t count = path_.getStateCount() - 1;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t motion = (tightest_ + i) % count;
            if (keeps(motion, clearance)) continue;
            tightest_ = motion;
            return false;
        }
        return true;
    }

    void raiseKept() {
        for (double gain = kGain; gain >= kLeastGain && !isOver();) {
            const double next =
                std::min(options_.enough, std::max(kept_ * (1 + gain), validator_.leastInterval()));
            if (allKeep(next)) {
                kept_ = next;
            } else {
                gain *= 0.5;
            }
        }
    }

    void divideTightest() {
        const ob::State *from = path_.getState(tightest_), *to = path_.getState(tightest_ + 1);
        const double time = validator_.report(from, to).closestTime;
        if (time < kNearEnd || time > 1 - kNearEnd || si_->distance(from, to) < kept_) return;
        ob::State* state = si_->allocState();
        si_->getStateSpace()->interpolate(from, to, time, state);
        if (validator_.keepsClearance(from, state, kept_) && validator_.keepsClearance(state, to, kept_)) {
            auto& states = path_.getStates();
            states.insert(states.begin() + static_cast<std::ptrdiff_t>(tightest_) + 1, state);
        } else {
            si_->freeState(state);
        }
    }

    void move(std::size_t i) {
        ob::State* state = path_.getState(static_cast<unsigned int>(i));
        double clearance = checker_.clearance(state);
        const ScratchState far(*si_), moved(*si_);
        for (int k = 0; k < kTries && clearance < kRoomy * kept_ && !isOver(); ++k) {
            sampler_->sampleUniform(far.get());
            const double length = std::exp(random_.uniformReal(std::log(shortest_), std::log(longest_)));
            const double share = length / si_->distance(state, far.get());
            si_->getStateSpace()->interpolate(state, far.get(), std::min(1.0, share), moved.get());
            const double found = checker_.clearance(moved.get());
            if (found <= clearance) continue;
            if (!validator_.keepsClearance(path_.getState(i - 1), moved.get(), kept_) ||
                !validator_.keepsClearance(moved.get(), path_.getState(i + 1), kept_)) {
                continue;
            }
            si_->copyState(state, moved.get());
            clearance = found;
        }
    }

    og::PathGeometric& path_;
    const ob::SpaceInformationPtr& si_;
    const MotionValidator& validator_;
    const RaiseOptions& options_;
    ValidityChecker checker_;
    ob::StateSamplerPtr sampler_;
    ompl::RNG random_;
    double kept_, shortest_, longest_;
    std::size_t tightest_ = 0;
};

}  // namespace

double raiseClearance(og::PathGeometric& path, const MotionValidator& validator,
                      const RaiseOptions& options) {
    if (path.getStateCount() < 3) return options.clearance;
    return Raiser(path, validator, options).run();
}

}  // namespace clearway::planning
