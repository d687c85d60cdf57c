// Checks a motion at states so close that no point of the part moves further than a given length from one to
// the next.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "clearway/model.h"
#include "clearway/planning/displacement_bound.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

class PosedScene;

/// Asks the space information's validity checker about s1, s2 and states of OMPL's own interpolation between
/// them. The part can jump over anything thinner than the step: choose at most half the thinnest wall.
///
/// Any number of threads may use one validator.
class DiscreteMotionValidator : public ompl::base::MotionValidator {
  public:
    /// For OMPL's SE(3) and SE(2). step: environment units. Throws std::invalid_argument when si is null or
    /// has another space (see displacementBound), or the step is not a finite number above 0. isStopped: called within
    /// motions, by any thread; true ends the check of a motion, which then counts as invalid.
    DiscreteMotionValidator(const ompl::base::SpaceInformationPtr& si, const Model& part, double step,
                            std::function<bool()> isStopped = {});

    /// For any space. Throws as the first constructor does, and when the bound is empty.
    DiscreteMotionValidator(const ompl::base::SpaceInformationPtr& si, DisplacementBound bound, double step,
                            std::function<bool()> isStopped = {});

    /// Whether all states that are looked at are valid. A motion is also invalid when its interpolation ends
    /// farther from s2 than the step (OMPL leaves out turns of up to 1.6e-4 rad), because it cannot be
    /// checked that closely, and when it has no finite bound.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// On false lastValid.second is in [0, 1) and lastValid.first, unless null, holds the state at that time:
    /// the last valid one before the first invalid one (s1 when s1 itself is invalid). lastValid.first may be
    /// s1 or s2. On true lastValid stays as it is.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override;

    /// The number n of equal parts that the motion is checked in: the states at times 0, 1/n, ..., 1 are
    /// checked. 0 when the motion cannot be checked.
    std::uint64_t partsOf(const ompl::base::State* s1, const ompl::base::State* s2) const;

    /// How far any point of the part may move from one state that is checked to the next; environment units.
    double step() const { return step_; }

    /// The number of motions that began in an invalid state, against OMPL's contract.
    std::uint64_t invalidStarts() const;

  private:
    bool isMotionValid(const ompl::base::State* s1, const ompl::base::State* s2) const;
    double lastValidTime(const ompl::base::State* s1, const ompl::base::State* s2) const;
    bool isStartValid(const ompl::base::State* s1) const;
    bool isPartValid(const ompl::base::State* s1, const ompl::base::State* s2, std::uint64_t i,
                     std::uint64_t n, ompl::base::State* scratch) const;
    bool count(bool valid) const;

    std::shared_ptr<const PosedScene> posed_;
    double step_;
    std::function<bool()> isStopped_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
