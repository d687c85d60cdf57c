// Checks a motion at states so close that no point of the part moves further than a given length from one to
// the next.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include <atomic>
#include <cstdint>
#include <utility>

#include "clearway/model.h"
#include "clearway/planning/displacement_bound.h"

namespace clearway::planning {

/// The states checked are s1, s2 and OMPL's own interpolation between them, by the space information's
/// validity checker. What is thinner than the step can be jumped: choose at most half the thinnest wall.
///
/// Any number of threads may use one validator.
class DiscreteMotionValidator : public ompl::base::MotionValidator {
  public:
    /// For OMPL's SE(3) and SE(2). step: environment units. Throws std::invalid_argument when si has another
    /// space (see displacementBound) or the step is not a finite number above 0.
    DiscreteMotionValidator(const ompl::base::SpaceInformationPtr& si, const Model& part, double step);

    /// For any space. Throws likewise, and when the bound is empty.
    DiscreteMotionValidator(const ompl::base::SpaceInformationPtr& si, DisplacementBound bound, double step);

    /// Invalid as well: a motion whose interpolation ends farther from s2 than the step (OMPL leaves out
    /// rotations below 1.6e-4 rad), for it cannot be checked that closely, and one without a finite bound.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// On false lastValid.second is in [0, 1) and lastValid.first, unless null, holds the state there, the
    /// last valid one before the first invalid one (s1 when s1 itself is invalid). lastValid.first may be s1
    /// or s2. On true both stay.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override;

    /// The number n of equal parts the motion is checked in: at the states at 0, 1/n, ..., 1. 0 when it
    /// cannot be checked.
    std::uint64_t partsOf(const ompl::base::State* s1, const ompl::base::State* s2) const;

    double step() const { return step_; }

    /// Motions that began in an invalid state, against OMPL's contract.
    std::uint64_t invalidStarts() const { return invalidStarts_.load(std::memory_order_relaxed); }

  private:
    bool isMotionValid(const ompl::base::State* s1, const ompl::base::State* s2) const;
    double lastValidTime(const ompl::base::State* s1, const ompl::base::State* s2) const;
    bool isStartValid(const ompl::base::State* s1) const;
    bool count(bool valid) const;

    DisplacementBound bound_;
    double step_;
    mutable std::atomic<std::uint64_t> invalidStarts_{0};
};

}  // namespace clearway::planning
