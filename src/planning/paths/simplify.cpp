#include "clearway/planning/simplify.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/number.h"
#include "planning/motion/floor_validator.h"
#include "planning/paths/shorten.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Where a floor cannot be kept, this share of it is tried next.
constexpr double kNextFloor = 0.25;

/// As long as a path does not keep the floor all along: shortcuts are random, and others may.
constexpr int kTries = 3;

class Simplifier {
  public:
    Simplifier(const MotionValidator& validator, const SimplifyOptions& options)
        : validator_(validator), options_(options) {}

    bool isSpent() const { return options_.isSpent && options_.isSpent(); }

    /// The whole path by motions that keep the floor; then each run of motions that do not, on its own, by
    /// motions that keep a lower one, down to what the run keeps.
    void shortenKeeping(double floor, double least, og::PathGeometric& path) const {
        shortenBy(floor, path);
        if (least >= floor || isSpent()) return;
        og::PathGeometric result(path.getSpaceInformation());
        const auto count = static_cast<unsigned int>(path.getStateCount());
        result.append(path.getState(0));
        for (unsigned int k = 0; k + 1 < count;) {
            unsigned int end = k;
            while (end + 1 < count && !keeps(floor, path, end)) ++end;
            if (end > k + 1) {
                appendShortened(floor, path, {k, end}, result);
            } else {
                end = k + 1;
                result.append(path.getState(end));
            }
            k = end;
        }
        path = result;
    }

  private:
    struct Run {
        unsigned int first, last;  ///< states
    };

    bool keeps(double floor, const og::PathGeometric& path, unsigned int motion) const {
        return validator_.keepsClearance(path.getState(motion), path.getState(motion + 1), floor,
                                         options_.isSpent);
    }

    /// OMPL asks the path's own space information.
    void shortenBy(double floor, og::PathGeometric& path) const {
        const ob::SpaceInformationPtr& given = path.getSpaceInformation();
        const auto si = std::make_shared<ob::SpaceInformation>(given->getStateSpace());
        si->setStateValidityChecker(given->getStateValidityChecker());
        si->setMotionValidator(std::make_shared<FloorValidator>(si, validator_, floor, options_.isSpent));
        si->setup();
        og::PathGeometric shorter(si);
        for (const ob::State* state : path.getStates()) shorter.append(state);
        shorten(shorter, [this] { return isSpent(); });
        path.clear();
        for (const ob::State* state : shorter.getStates()) path.append(state);
    }

    void appendShortened(double floor, const og::PathGeometric& path, Run run,
                         og::PathGeometric& result) const {
        og::PathGeometric tight(path.getSpaceInformation());
        for (unsigned int k = run.first; k <= run.last; ++k) tight.append(path.getState(k));
        if (!isSpent()) {
            const double least = std::max(0.0, audit(tight, validator_).lowerClearance);
            shortenKeeping(std::max(least, kNextFloor * floor), least, tight);
        }
        for (unsigned int k = 1; k < tight.getStateCount(); ++k) result.append(tight.getState(k));
    }

    const MotionValidator& validator_;
    const SimplifyOptions& options_;
};

}  // namespace

PathAudit simplify(og::PathGeometric& path, const MotionValidator& validator,
                   const SimplifyOptions& options) {
    if (!(options.floor >= 0) || !std::isfinite(options.floor)) {
        throw std::invalid_argument("floor is " + shortNumber(options.floor) +
                                    ", expected a finite number >= 0");
    }
    PathAudit before = audit(path, validator);
    if (!before.isValid() || path.getStateCount() < 3) return before;
    og::PathGeometric shorter = path;
    const Simplifier simplifier(validator, options);
    PathAudit after = before;
    for (int i = 0; i < kTries && !simplifier.isSpent(); ++i) {
        simplifier.shortenKeeping(options.floor, after.lowerClearance, shorter);
        after = audit(shorter, validator);
        if (!after.isValid() || after.upperClearance >= options.floor) break;
    }
    // What is left of an old motion is a motion of its own for OMPL, which leaves out turns below 1.6e-4 rad.
    const double kept = std::min(options.floor, before.lowerClearance);
    if (!after.isValid() || after.upperClearance < kept) return before;
    path = shorter;
    return after;
}

}  // namespace clearway::planning
