#include "clearway/planning/simplify.h"

#include <ompl/config.h>
#include <ompl/geometric/PathSimplifier.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/number.h"
#include "planning/check/floor_validator.h"
#include "planning/space/ompl_refusal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// Where a floor cannot be kept, this share of it is tried next.
constexpr double kNextFloor = 0.25;

/// How often a path that does not keep the floor throughout is simplified: other random shortcuts may keep
/// it.
constexpr int kTries = 3;

constexpr int kMostRounds = 200;
constexpr int kIdleRounds = 8;  ///< this many rounds in a row without gain are the last
constexpr double kGain = 1e-3;  ///< of the length; less is no gain
/// Motions tried by each part of a round: few, so that isSpent takes effect soon.
constexpr unsigned int kSteps = 12;

/// Makes shortcuts between random points of the path. OMPL renamed the function in 1.7.
void shortcutPath(og::PathSimplifier& simplifier, og::PathGeometric& path, unsigned int mostSteps,
                  unsigned int mostEmptySteps) {
#if OMPL_VERSION_VALUE >= 1007000
    simplifier.partialShortcutPath(path, mostSteps, mostEmptySteps);
#else
    simplifier.shortcutPath(path, mostSteps, mostEmptySteps);
#endif
}

/// Runs rounds of OMPL's vertex removal and shortcuts by the motion validator of the path's own space information, until
/// they stop paying or isSpent returns true.
void shorten(og::PathGeometric& path, const std::function<bool()>& isSpent) {
    og::PathSimplifier simplifier(path.getSpaceInformation());
    int idle = 0;
    for (int round = 0; round < kMostRounds && idle < kIdleRounds && !isSpent(); ++round) {
        const double before = path.length();
        simplifier.reduceVertices(path, kSteps, kSteps);
        if (isSpent()) return;
        shortcutPath(simplifier, path, kSteps, kSteps);
        idle = path.length() < before * (1 - kGain) ? 0 : idle + 1;
    }
}

class Simplifier {
  public:
    Simplifier(const MotionValidator& validator, const SimplifyOptions& options)
        : validator_(validator), options_(options) {}

    bool isSpent() const { return options_.isSpent && options_.isSpent(); }

    /// Shortens the whole path by motions that keep the floor. Then shortens each run of motions that do not
    /// keep it on its own, by motions that keep a lower floor, down to the clearance that the run keeps.
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

    /// Works on a copy with a space information of its own, because OMPL asks the path's space information.
    void shortenBy(double floor, og::PathGeometric& path) const {
        const ob::SpaceInformationPtr& given = path.getSpaceInformation();
        const auto si = makeOnSharedSpace(given->getStateSpace());
        si->setStateValidityChecker(given->getStateValidityChecker());
        si->setMotionValidator(std::make_shared<FloorValidator>(si, validator_, floor, options_.isSpent));
        setUpOnSharedSpace(*si);
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
                   const SimplifyOptions& options) try {
    requireNotNegative("floor", options.floor);
    if (options.kept) requireNotNegative("the clearance kept", *options.kept);
    std::optional<PathAudit> before;
    if (!options.kept || path.getStateCount() < 3) before = audit(path, validator);
    if (path.getStateCount() < 3 || (before && !before->isValid())) return *before;
    const double least = before ? before->lowerClearance : *options.kept;
    og::PathGeometric shorter = path;
    const Simplifier simplifier(validator, options);
    std::optional<PathAudit> after;
    for (int i = 0; i < kTries && !simplifier.isSpent(); ++i) {
        simplifier.shortenKeeping(options.floor, after ? after->lowerClearance : least, shorter);
        after = audit(shorter, validator);
        if (!after->isValid() || after->upperClearance >= options.floor) break;
    }
    // OMPL interpolates the rest of an old motion as a motion of its own, which may come closer: OMPL leaves
    // out turns below 1.6e-4 rad.
    const double kept = std::min(options.floor, least);
    if (!after || !after->isValid() || after->upperClearance < kept)
        return before ? *before : audit(path, validator);
    path = shorter;
    return *after;
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

}  // namespace clearway::planning
