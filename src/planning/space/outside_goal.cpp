#include "clearway/planning/outside_goal.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "planning/space/ompl_states.h"
#include "problem/outside.h"

namespace clearway::planning {
namespace {

constexpr int kMostDraws = 100;  ///< draws until one is valid
/// States that a planner may ask for. BIT* and its kin ask for all of them before they begin.
constexpr unsigned int kMostGoals = 100;
/// Shares of the draws with any rotation, and straight ahead of the start. A part often leaves by an opening that it lies along
/// as it starts: RRTConnect gets the bracket through its window in 4 of 8 runs of 10,000 iterations. With any rotation in all
/// draws it does so in none of 8 runs of 20,000.
constexpr double kTurnedShare = 0.25;
constexpr double kStraightShare = 0.5;

Box boundsOf(const ob::StateSpace& space, Space kind) {
    const ob::RealVectorBounds& bounds = positionBounds(kind, space);
    Box box(Vector3::Zero(), Vector3::Zero());
    for (std::size_t i = 0; i < bounds.low.size(); ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        box.min()[axis] = bounds.low[i];
        box.max()[axis] = bounds.high[i];
    }
    return box;
}

int dimensionsOf(Space kind) {
    return kind == Space::kSe3 ? 3 : 2;
}

/// The positions within the bounds at which a part turned like this one is beyond the side; empty when there are none.
Box positionsBeyond(const BoxSide& side, const Box& turnedPart, const Box& surroundings, const Box& bounds,
                    int dimensions) {
    const double overlap = overlapAt(side, turnedPart, surroundings);  // at position 0
    Box positions = bounds;
    if (side.axis >= dimensions) {
        if (!(overlap < 0)) positions.setEmpty();
        return positions;
    }
    double& low = positions.min()[side.axis];
    double& high = positions.max()[side.axis];
    if (side.isUpper) {
        low = std::max(low, overlap);
    } else {
        high = std::min(high, -overlap);
    }
    if (!(low < high)) positions.setEmpty();
    return positions;
}

double volumeOf(const Box& positions, int dimensions) {
    return positions.isEmpty() ? 0 : positions.sizes().head(dimensions).prod();
}

/// The positions on the line through a point along an axis.
Box onLine(const Box& positions, const Vector3& point, int axis) {
    Vector3 low = point, high = point;
    low[axis] = positions.min()[axis];
    high[axis] = positions.max()[axis];
    return Box(low, high);
}

}  // namespace

OutsideGoal::OutsideGoal(const ob::SpaceInformationPtr& si, const Scene& scene, const Outside& outside,
                         const PartState& start)
    : GoalSampleableRegion(si),
      outside_(outside),
      start_(start),
      part_(scene.part.box()),
      surroundings_(scene.environmentBox()),
      kind_(kindOf(spaceOf(si))),
      stateToPose_(stateToPose(spaceOf(si))),
      sampler_(si->allocStateSampler()) {
    bounds_ = boundsOf(*si->getStateSpace(), kind_);
}

OutsideGoal::OutsideGoal(const ob::SpaceInformationPtr& si, const OutsideGoal& goal)
    : GoalSampleableRegion(si),
      outside_(goal.outside_),
      start_(goal.start_),
      part_(goal.part_),
      surroundings_(goal.surroundings_),
      kind_(kindOf(spaceOf(si))),
      stateToPose_(stateToPose(spaceOf(si))),
      sampler_(si->allocStateSampler()) {
    bounds_ = boundsOf(*si->getStateSpace(), kind_);
}

double OutsideGoal::overlap(const ob::State* state) const {
    return overlapOf(outside_, movedBox(stateToPose_(state), part_), surroundings_);
}

double OutsideGoal::distanceGoal(const ob::State* state) const {
    return std::max(0.0, overlap(state));
}

bool OutsideGoal::isSatisfied(const ob::State* state) const {
    return overlap(state) < 0;
}

bool OutsideGoal::isSatisfied(const ob::State* state, double* distance) const {
    const double found = overlap(state);
    if (distance != nullptr) *distance = std::max(0.0, found);
    return found < 0;
}

void OutsideGoal::moveOut(ob::State* state, double gap) const {
    const Box part = movedBox(stateToPose_(state), part_);
    PartState at = fromOmpl(kind_, state);
    double most = 0;
    Vector3 way = Vector3::Zero();
    for (const BoxSide& side : sidesOf(outside_)) {
        const double now = -overlapAt(side, part, surroundings_);
        if (side.axis >= dimensionsOf(kind_) || !(now > 0)) continue;
        const double left = side.isUpper ? bounds_.max()[side.axis] - at.position[side.axis]
                                         : at.position[side.axis] - bounds_.min()[side.axis];
        const double distance = std::clamp(gap - now, 0.0, std::max(0.0, left));
        if (!(now + distance > most)) continue;
        most = now + distance;
        way = (side.isUpper ? distance : -distance) * Vector3::Unit(side.axis);
    }
    at.position += way;
    si_->copyState(state, toOmpl(si_->getStateSpace(), kind_, at).get());
}

unsigned int OutsideGoal::maxSampleCount() const {
    return kMostGoals;
}

void OutsideGoal::sampleGoal(ob::State* state) const {
    PartState drawn;
    for (int i = 0; i < kMostDraws; ++i) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            drawn = draw(state);
        }
        si_->copyState(state, toOmpl(si_->getStateSpace(), kind_, drawn).get());
        if (isSatisfied(state) && si_->satisfiesBounds(state) && si_->isValid(state)) return;
    }
    drawn.position = bounds_.max() + bounds_.sizes();
    si_->copyState(state, toOmpl(si_->getStateSpace(), kind_, drawn).get());
}

PartState OutsideGoal::draw(ob::State* scratch) const {
    const double drawn = random_.uniform01();
    const bool isTurned = drawn<kTurnedShare, isStraight = drawn> 1 - kStraightShare;
    PartState state = start_;
    if (isTurned) {
        sampler_->sampleUniform(scratch);
        state.rotation = fromOmpl(kind_, scratch).rotation;
    }
    if (placeOutside(state, isStraight)) return state;
    turnFlat(state);
    placeOutside(state, false);
    return state;
}

/// Draws a position at which the part, turned as it is, is outside. isStraight: one that it reaches from its position
/// straight along an axis. Returns false when the bounds have none.
bool OutsideGoal::placeOutside(PartState& state, bool isStraight) const {
    const int dimensions = dimensionsOf(kind_);
    const Box turnedPart = movedBox({poseOf(state).rotation, Vector3::Zero()}, part_);
    std::vector<Box> places;
    std::vector<double> weights;
    double sum = 0;
    for (const BoxSide& side : sidesOf(outside_)) {
        const Box beyond = positionsBeyond(side, turnedPart, surroundings_, bounds_, dimensions);
        if (beyond.isEmpty()) continue;
        places.push_back(isStraight ? onLine(beyond, state.position, side.axis) : beyond);
        weights.push_back(isStraight ? 1 : volumeOf(beyond, dimensions));
        sum += weights.back();
    }
    if (places.empty()) return false;
    double left = random_.uniformReal(0, sum);
    std::size_t chosen = 0;
    while (chosen + 1 < places.size() && left > weights[chosen]) left -= weights[chosen++];
    const Box& place = places[chosen];
    for (int i = 0; i < dimensions; ++i)
        state.position[i] = random_.uniformReal(place.min()[i], place.max()[i]);
    return true;
}

/// Turns the part so that it reaches as little as possible towards the surroundings from one of the goal's sides, with a
/// random turn about that direction.
void OutsideGoal::turnFlat(PartState& state) const {
    const std::vector<BoxSide> sides = sidesOf(outside_);
    const auto count = static_cast<int>(outside_.side ? 1 : 2 * dimensionsOf(kind_));
    const BoxSide& side = sides[static_cast<std::size_t>(random_.uniformInt(0, count - 1))];
    const Vector3 inwards = (side.isUpper ? -1 : 1) * Vector3::Unit(side.axis);
    const Vector3 flattest = flattestDirection(part_, dimensionsOf(kind_));
    if (kind_ == Space::kSe2) {
        const double angle = std::atan2(inwards.y(), inwards.x()) - std::atan2(flattest.y(), flattest.x());
        state.rotation = Eigen::AngleAxisd(angle, Vector3::UnitZ());
    } else {
        const Eigen::AngleAxisd turn(random_.uniformReal(-M_PI, M_PI), inwards);
        state.rotation = turn * Eigen::Quaterniond::FromTwoVectors(flattest, inwards);
    }
}

}  // namespace clearway::planning
