// Checks a motion at states so close that no point of the part moves further than a step from one to the next: what certified
// motions are compared with.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <utility>

#include "clearway/model.h"
#include "clearway/planning/displacement_bound.h"

namespace clearway::testing {

/// Asks the space information's validity checker about s1, s2 and states of OMPL's own interpolation between them. Any number
/// of threads may use one validator.
class SteppedMotionValidator : public ompl::base::MotionValidator {
  public:
    /// For OMPL's SE(3) and SE(2). step: > 0, environment units. Throws std::invalid_argument when si has another space.
    SteppedMotionValidator(const ompl::base::SpaceInformationPtr& si, const Model& part, double step);

    /// Whether all states that are looked at are valid. A motion is also invalid when its interpolation ends farther from s2
    /// than the step (OMPL leaves out turns of up to 1.6e-4 rad), because it cannot be checked that closely.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// Fills in lastValid as OMPL asks for it.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override;

  private:
    std::uint64_t partsOf(const ompl::base::State* s1, const ompl::base::State* s2) const;
    bool isPartValid(const ompl::base::State* s1, const ompl::base::State* s2, std::uint64_t i,
                     std::uint64_t n, ompl::base::State* scratch) const;

    planning::DisplacementBound bound_;
    double step_;
};

}  // namespace clearway::testing
