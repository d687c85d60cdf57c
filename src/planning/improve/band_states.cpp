#include "planning/improve/band_states.h"

#include <cmath>
#include <utility>

namespace clearway::planning {
namespace {

/// A state so much closer to the one before than the spacing is dropped when the motion past it is not much longer.
constexpr double kClose = 0.4, kLongestJoined = 1.2;
/// Calls of respace() for which a state in the middle of a tight motion stays. Later the motion may have more clearance.
constexpr int kSpared = 24;
constexpr double kShortestTight =
    0.1;  ///< of the clearance; a shorter motion does not come closer than its ends

}  // namespace

BandState BandStates::make(const ob::State* state) const {
    BandState made{std::make_unique<ScratchState>(si_), {}};
    si_.copyState(made.get(), state);
    return made;
}

void BandStates::takeFrom(const og::PathGeometric& path) {
    states_.clear();
    tightest_ = 0;
    for (unsigned int i = 0; i < path.getStateCount(); ++i) states_.push_back(make(path.getState(i)));
}

void BandStates::copyTo(og::PathGeometric& path) const {
    path.clear();
    for (const BandState& state : states_) path.append(state.get());
}

bool BandStates::allKeep(double clearance) {
    const std::size_t motions = count() - 1;
    for (std::size_t k = 0; k < motions; ++k) {
        const std::size_t i = (tightest_ + k) % motions;
        if (keeps(states_[i].get(), states_[i + 1].get(), clearance)) continue;
        tightest_ = i;
        return false;
    }
    return true;
}

void BandStates::respace(double spacing, const std::optional<double>& floor) {
    std::vector<BandState> spaced;
    spaced.push_back(std::move(states_.front()));
    for (std::size_t i = 1; i < states_.size(); ++i) {
        const ob::State *from = spaced.back().get(), *state = states_[i].get();
        const double way = displacementOf(moves_.between(from, state));
        const bool isSpared = states_[i].spared > 0 && --states_[i].spared > 0;
        if (i + 1 < states_.size() && !isSpared && way < kClose * spacing) {
            const ob::State* next = states_[i + 1].get();
            const double joined = displacementOf(moves_.between(from, next));
            if (joined < kLongestJoined * spacing && (!floor || keeps(from, next, *floor))) continue;
        }
        if (way > spacing) divide(spaced, states_[i], way / spacing, floor);
        spaced.push_back(std::move(states_[i]));
    }
    tightest_ = 0;
    states_ = std::move(spaced);
}

/// Adds states between the last one and the next.
void BandStates::divide(std::vector<BandState>& spaced, const BandState& next, double parts,
                        const std::optional<double>& floor) const {
    const int count = static_cast<int>(std::ceil(parts));
    const ScratchState between(si_), first(si_);
    si_.copyState(first.get(), spaced.back().get());
    for (int k = 1; k < count; ++k) {
        const double time = static_cast<double>(k) / count;
        si_.getStateSpace()->interpolate(first.get(), next.get(), time, between.get());
        if (mayStand(spaced.back().get(), between.get(), next.get(), floor))
            spaced.push_back(make(between.get()));
    }
}

/// The part comes closer between the states than at them. Two clearances that overlap prove the contrary at once.
bool BandStates::isTight(const BandState& from, const BandState& to, double clearance) const {
    if (!(from.clearance > clearance) || !(to.clearance > clearance)) return false;
    const double way = displacementOf(moves_.between(from.get(), to.get()));
    if (way < kShortestTight * clearance || from.clearance + to.clearance - way >= 2 * clearance)
        return false;
    return !keeps(from.get(), to.get(), clearance);
}

void BandStates::divideTight(double clearance, const std::optional<double>& floor) {
    std::vector<BandState> divided;
    divided.push_back(std::move(states_.front()));
    const ScratchState middle(si_);
    for (std::size_t i = 1; i < states_.size(); ++i) {
        const ob::State *from = divided.back().get(), *to = states_[i].get();
        if (isTight(divided.back(), states_[i], clearance)) {
            si_.getStateSpace()->interpolate(from, to, 0.5, middle.get());
            if (mayStand(from, middle.get(), to, floor)) {
                divided.push_back(make(middle.get()));
                divided.back().spared = kSpared;
            }
        }
        divided.push_back(std::move(states_[i]));
    }
    tightest_ = 0;
    states_ = std::move(divided);
}

}  // namespace clearway::planning
