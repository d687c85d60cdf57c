#include "planning/diagnose/what_blocks.h"

#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "clearway/scene_clearance.h"
#include "core/clock.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// Targets of motions may be beyond the bounds by this share of the part's diagonal. Planners never aim there, but
/// without such targets no motion would meet a bound.
constexpr double kBeyondPerDiagonal = 0.25;

/// Motions are followed to within this share of the part's diagonal of the pose that blocks: close enough to name it.
constexpr double kWithinPerDiagonal = 1e-3;

class Trial {
  public:
    Trial(const MotionValidator& validator, Space space, std::uint32_t seed)
        : validator_(validator),
          space_(space),
          random_(seed),
          diagonal_(validator.scene().part.box().diagonal().norm()) {}

    const ob::State* draw(const FailedTree& tree) {
        const int last = static_cast<int>(tree.states.size()) - 1;
        return tree.states[static_cast<std::size_t>(random_.uniformInt(0, last))].state;
    }

    /// Aims anywhere within the widened bounds. Nothing when the motion reaches its target.
    std::optional<Blocker> follow(const ob::State* from) {
        const auto target = aim();
        const double within = kWithinPerDiagonal * diagonal_;
        const double reached = validator_.validUntil(from, target.get(), {within});
        if (reached >= 1) return std::nullopt;
        const double moved =
            validator_.scene().part.displacement(validator_.pose(from), validator_.pose(target.get()));
        return blockerBetween(at(from, target.get(), reached).get(),
                              at(from, target.get(), std::min(1.0, reached + 2 * within / moved)).get());
    }

  private:
    using State = ob::ScopedState<>;

    State aim() {
        const ob::RealVectorBounds& bounds = positionBounds(space_, validator_.space());
        const double beyond = kBeyondPerDiagonal * diagonal_;
        PartState target;
        for (unsigned int axis = 0; axis < bounds.low.size(); ++axis) {
            target.position[axis] =
                random_.uniformReal(bounds.low[axis] - beyond, bounds.high[axis] + beyond);
        }
        target.rotation = aimedRotation();
        return toOmpl(spacePtr(), space_, target);
    }

    Eigen::Quaternion<double, Eigen::DontAlign> aimedRotation() {
        if (space_ == Space::kSe2) {
            const double half = 0.5 * random_.uniformReal(-M_PI, M_PI);
            return {std::cos(half), 0, 0, std::sin(half)};
        }
        double xyzw[4];
        random_.quaternion(xyzw);
        return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
    }

    /// The validator lends its space; the pointer made here does not own it.
    ob::StateSpacePtr spacePtr() const {
        return {ob::StateSpacePtr(), const_cast<ob::StateSpace*>(&validator_.space())};
    }

    State at(const ob::State* from, const ob::State* to, double time) const {
        State state(spacePtr());
        validator_.space().interpolate(from, to, time, state.get());
        return state;
    }

    Blocker blockerBetween(const ob::State* before, const ob::State* after) const {
        const MotionReport report = validator_.report(before, after);
        if (report.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds) return {};
        const MeshNames names = meshNames(validator_.scene(), report.closest);
        const bool hasSeveral = validator_.scene().part.components().size() > 1;
        return {names.environment, hasSeveral ? names.part : std::string()};
    }

    const MotionValidator& validator_;
    Space space_;
    ompl::RNG random_;
    double diagonal_;
};

/// Adds up the motions by what stopped them.
class Tally {
  public:
    void add(const Blocker& blocker, bool isAtStart) {
        Sum& sum = sums_[blocker.name];
        ++(isAtStart ? sum.blocker.atStart : sum.blocker.atGoal);
        ++sum.partMeshes[blocker.partMesh];
    }

    /// Those that stopped most motions first, equal ones in the order of their names.
    std::vector<Blocker> blockers() const {
        std::vector<Blocker> all;
        for (const auto& [name, sum] : sums_) {
            all.push_back(sum.blocker);
            all.back().name = name;
            all.back().partMesh =
                std::max_element(sum.partMeshes.begin(), sum.partMeshes.end(),
                                 [](const auto& a, const auto& b) { return a.second < b.second; })
                    ->first;
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Blocker& a, const Blocker& b) { return a.motions() > b.motions(); });
        return all;
    }

  private:
    struct Sum {
        Blocker blocker;
        std::map<std::string, std::size_t> partMeshes;
    };
    std::map<std::string, Sum> sums_;
};

}  // namespace

void findBlockers(const FailedTrees& trees, const MotionValidator& validator, Space space,
                  const WhyNoPathOptions& options, WhyNoPath& why) {
    const Clock::time_point begin = Clock::now();
    const auto isOver = [&] {
        const double spent = secondsSince(begin);
        return (options.seconds && spent >= *options.seconds) || (options.isStopped && options.isStopped());
    };
    Trial trial(validator, space, options.seed);
    Tally tally;
    for (; why.motionsTried < options.motions && !isOver(); ++why.motionsTried) {
        const bool isAtStart = why.motionsTried % 2 == 0;
        const auto blocker = trial.follow(trial.draw(isAtStart ? trees.start : trees.goal));
        if (!blocker) continue;
        ++(isAtStart ? why.start : why.goal).motionsStopped;
        tally.add(*blocker, isAtStart);
    }
    why.blockers = tally.blockers();
}

}  // namespace clearway::planning
