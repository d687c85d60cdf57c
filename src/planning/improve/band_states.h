// The states of an elastic band: evenly spaced, closer where a motion between them cuts a corner.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/improve/contact_planes.h"
#include "planning/improve/part_moves.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

/// A state of a band, with what is known around it.
struct BandState {
    std::unique_ptr<ScratchState> scratch;
    std::vector<ContactPlane>
        planes;            ///< of the closest pairs found here, in part by earlier states in its place
    double clearance = 0;  ///< a lower bound; 0: not known
    int spared = 0;        ///< respace() drops the state only after so many calls

    ob::State* get() const { return scratch->get(); }
};

class BandStates {
  public:
    /// The arguments must outlive this object. isSpent may be empty; once it returns true no motion keeps anything.
    BandStates(const ob::SpaceInformation& si, const MotionValidator& validator, const PartMoves& moves,
               const std::function<bool()>& isSpent)
        : si_(si), validator_(validator), moves_(moves), isSpent_(isSpent) {}

    /// Forgets what is known around the states.
    void takeFrom(const og::PathGeometric& path);
    void copyTo(og::PathGeometric& path) const;

    std::size_t count() const { return states_.size(); }
    BandState& operator[](std::size_t i) { return states_[i]; }
    const BandState& operator[](std::size_t i) const { return states_[i]; }

    /// No point of the part moves further.
    double displacementOf(const Twist& twist) const {
        return twist.head<3>().norm() + twist.tail<3>().norm() * moves_.radius() / moves_.lever();
    }

    bool keeps(const ob::State* from, const ob::State* to, double clearance) const {
        return validator_.keepsClearance(from, to, clearance, isSpent_);
    }

    /// Begins with the motion that failed last.
    bool allKeep(double clearance);

    /// Divides motions that move the part by more than `spacing`, and drops states that are much closer. With a floor
    /// only where the new motions keep it.
    void respace(double spacing, const std::optional<double>& floor);

    /// Divides the motions that do not keep the clearance although their two states have it. With a floor only where
    /// the new motions keep it.
    void divideTight(double clearance, const std::optional<double>& floor);

  private:
    BandState make(const ob::State* state) const;
    /// True when a state may be put between two others.
    bool mayStand(const ob::State* from, const ob::State* state, const ob::State* to,
                  const std::optional<double>& floor) const {
        return !floor || (keeps(from, state, *floor) && keeps(state, to, *floor));
    }
    void divide(std::vector<BandState>& spaced, const BandState& next, double parts,
                const std::optional<double>& floor) const;
    bool isTight(const BandState& from, const BandState& to, double clearance) const;

    const ob::SpaceInformation& si_;
    const MotionValidator& validator_;
    const PartMoves& moves_;
    const std::function<bool()>& isSpent_;
    std::vector<BandState> states_;
    std::size_t tightest_ = 0;  ///< the motion that failed last
};

}  // namespace clearway::planning
