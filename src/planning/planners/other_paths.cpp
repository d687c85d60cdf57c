#include "planning/planners/other_paths.h"

#include <utility>

namespace clearway::planning {
namespace {

/// One of so many samples is drawn anywhere; the others lie beside the narrow places.
constexpr int kAnywhere = 4;

}  // namespace

std::vector<unsigned int> narrowsOf(const og::PathGeometric& path, const MotionValidator& validator,
                                    double floor, const std::function<bool()>& isSpent) {
    std::vector<unsigned int> narrows;
    for (unsigned int i = 1; i < path.getStateCount(); ++i) {
        if (!validator.keepsClearance(path.getState(i - 1), path.getState(i), floor, isSpent))
            narrows.push_back(i);
    }
    return narrows;
}

BesideNarrows::BesideNarrows(const ob::SpaceInformation& si, const og::PathGeometric& path,
                             std::vector<unsigned int> narrows, const Model& part)
    : StateSampler(si.getStateSpace().get()),
      anywhere_(si.allocStateSampler()),
      moves_(*space_, part),
      path_(path),
      narrows_(std::move(narrows)),
      narrow_(si) {}

void BesideNarrows::sampleUniform(ob::State* state) {
    anywhere_->sampleUniform(state);
    if (++drawn_ % kAnywhere == 0) return;
    const unsigned int i = narrows_[random_.uniformInt(0, static_cast<int>(narrows_.size()) - 1)];
    space_->interpolate(path_.getState(i - 1), path_.getState(i), random_.uniform01(), narrow_.get());
    Twist there = Twist::Zero();
    there.head<3>() = centre(narrow_.get()) - centre(state);
    for (int axis = 0; axis < 3; ++axis) there[axis] += moves_.radius() * random_.uniformReal(-1, 1);
    moves_.move(state, there, state);
    space_->enforceBounds(state);
}

EndOfPath::EndOfPath(const ob::SpaceInformationPtr& si, ob::GoalPtr goal, const og::PathGeometric& path,
                     unsigned int first)
    : GoalSampleableRegion(si), goal_(std::move(goal)), path_(path), first_(first) {}

void EndOfPath::sampleGoal(ob::State* state) const {
    const unsigned int next = first_ + drawn_ / 2;
    if (drawn_++ % 2 == 0 && next < path_.getStateCount()) {
        si_->copyState(state, path_.getState(next));
    } else {
        region().sampleGoal(state);
    }
}

}  // namespace clearway::planning
