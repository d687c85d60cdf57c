#include "planning/improve/unwind.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <typeinfo>
#include <vector>

#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

constexpr double kAsMuch = 0.97;                  ///< of another clearance is about as much
constexpr double kLeastSaving = 5 * M_PI / 180;   ///< radians; less is not worth a stretch's motions
constexpr double kLongestTurn = 20 * M_PI / 180;  ///< of a motion to be unwound, radians
constexpr double kLongestWay = 0.5;  ///< of a motion to be unwound, in diagonals of the part's box
constexpr double kEveryPart = 4;     ///< stretches begin a quarter of their length apart

bool isOmplSe2(const ob::StateSpace& space) {
    return typeid(space) == typeid(ob::SE2StateSpace);
}

PartState partStateOf(const ob::StateSpace& space, const ob::State* state) {
    return isOmplSe2(space) ? partStateOfSe2(state) : partStateOfSe3(state);
}

void setPosition(const ob::StateSpace& space, const Vector3& position, ob::State* state) {
    if (isOmplSe2(space)) {
        state->as<ob::SE2StateSpace::StateType>()->setXY(position.x(), position.y());
    } else {
        state->as<ob::SE3StateSpace::StateType>()->setXYZ(position.x(), position.y(), position.z());
    }
}

/// Between two states of a path.
struct Step {
    double way = 0, angle = 0;  ///< environment units, radians
};

Step stepBetween(const ob::StateSpace& space, const ob::State* a, const ob::State* b) {
    const PartState from = partStateOf(space, a), to = partStateOf(space, b);
    return {(to.position - from.position).norm(),
            from.rotation.normalized().angularDistance(to.rotation.normalized())};
}

class Unwinder {
  public:
    Unwinder(og::PathGeometric& path, const MotionValidator& validator, double floor,
             const std::function<bool()>& isSpent)
        : path_(path),
          si_(*path.getSpaceInformation()),
          space_(*si_.getStateSpace()),
          validator_(validator),
          floor_(floor),
          isSpent_(isSpent) {}

    void run() {
        divideMotions();
        const std::size_t motions = path_.getStateCount() - 1;
        for (std::size_t length = motions; length >= 2; length /= 2) {
            const auto hop = std::max<std::size_t>(1, static_cast<std::size_t>(length / kEveryPart));
            for (std::size_t first = 0; first + length <= motions; first += hop) {
                if (isSpent_ && isSpent_()) return;
                unwindStretch(first, first + length);
            }
        }
    }

  private:
    ob::State* state(std::size_t i) const { return path_.getState(static_cast<unsigned int>(i)); }

    bool keeps(const ob::State* from, const ob::State* to) const {
        return validator_.keepsClearance(from, to, floor_, isSpent_);
    }

    /// Motions that turn or move far become several, where these keep the floor too.
    void divideMotions() {
        const double longest = kLongestWay * validator_.scene().part.box().diagonal().norm();
        og::PathGeometric divided(path_.getSpaceInformation());
        divided.append(state(0));
        for (std::size_t i = 1; i < path_.getStateCount(); ++i) {
            const Step step = stepBetween(space_, state(i - 1), state(i));
            const double turns = step.angle / kLongestTurn;
            const double ways = longest > 0 ? step.way / longest : 0;
            appendDivided(divided, i, static_cast<int>(std::ceil(std::max(turns, ways))));
            divided.append(state(i));
        }
        path_ = divided;
    }

    void appendDivided(og::PathGeometric& divided, std::size_t i, int parts) const {
        std::vector<std::unique_ptr<ScratchState>> between;
        const ob::State* last = state(i - 1);
        for (int k = 1; k < parts; ++k) {
            between.push_back(std::make_unique<ScratchState>(si_));
            const double time = static_cast<double>(k) / parts;
            space_.interpolate(state(i - 1), state(i), time, between.back()->get());
            if (!keeps(last, between.back()->get())) return;
            last = between.back()->get();
        }
        if (between.empty() || !keeps(last, state(i))) return;
        for (const auto& added : between) divided.append(added->get());
    }

    void unwindStretch(std::size_t first, std::size_t last) {
        double turned = 0, length = 0;
        for (std::size_t i = first; i < last; ++i) {
            const Step step = stepBetween(space_, state(i), state(i + 1));
            turned += step.angle;
            length += step.way;
        }
        const double least = stepBetween(space_, state(first), state(last)).angle;
        if (turned - least < kLeastSaving || !(length > 0)) return;
        std::vector<std::unique_ptr<ScratchState>> turnedStates;
        const ob::State* before = state(first);
        double passed = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
            passed += stepBetween(space_, state(i - 1), state(i)).way;
            turnedStates.push_back(turnedState(first, last, i, passed / length));
            const ob::State* next = turnedStates.back()->get();
            if (!keeps(before, next)) return;
            before = next;
        }
        if (!keeps(before, state(last))) return;
        for (std::size_t i = first + 1; i < last; ++i)
            si_.copyState(state(i), turnedStates[i - first - 1]->get());
    }

    /// State i with the rotation that a turn from the first to the last one has at a time.
    std::unique_ptr<ScratchState> turnedState(std::size_t first, std::size_t last, std::size_t i,
                                              double time) const {
        auto made = std::make_unique<ScratchState>(si_);
        space_.interpolate(state(first), state(last), time, made->get());
        setPosition(space_, partStateOf(space_, state(i)).position, made->get());
        return made;
    }

    og::PathGeometric& path_;
    const ob::SpaceInformation& si_;
    const ob::StateSpace& space_;
    const MotionValidator& validator_;
    double floor_;
    const std::function<bool()>& isSpent_;
};

}  // namespace

double windingLength(const og::PathGeometric& path, double radius) {
    const ob::StateSpace& space = *path.getSpaceInformation()->getStateSpace();
    double winding = 0;
    for (unsigned int i = 1; i < path.getStateCount(); ++i) {
        const Step step = stepBetween(space, path.getState(i - 1), path.getState(i));
        winding += step.way + radius * step.angle;
    }
    return winding;
}

bool isBetterPath(const WidePath& way, const WidePath& other, double radius) {
    if (way.clearance < kAsMuch * other.clearance) return false;
    if (other.clearance < kAsMuch * way.clearance) return true;
    return windingLength(*way.path, radius) < windingLength(*other.path, radius);
}

void unwind(og::PathGeometric& path, const MotionValidator& validator, double floor,
            const std::function<bool()>& isSpent) {
    const ob::StateSpace& space = *path.getSpaceInformation()->getStateSpace();
    if (!(isOmplSe3(space) || isOmplSe2(space)) || path.getStateCount() < 3) return;
    Unwinder(path, validator, floor, isSpent).run();
}

}  // namespace clearway::planning
