// A motion validator that certifies motions with margins raised by a floor.
#pragma once

#include <functional>
#include <utility>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

class FloorValidator : public ompl::base::MotionValidator {
  public:
    /// The validator must outlive this one. isStopped: like MotionOptions::isStopped.
    FloorValidator(const ompl::base::SpaceInformationPtr& si, const planning::MotionValidator& validator,
                   double floor, std::function<bool()> isStopped = {})
        : ompl::base::MotionValidator(si),
          validator_(validator),
          floor_(floor),
          isStopped_(std::move(isStopped)) {}

    const planning::MotionValidator& validator() const { return validator_; }
    double floor() const { return floor_; }

    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override {
        return validator_.keepsClearance(s1, s2, floor_, isStopped_);
    }

    /// For an invalid motion, lastValid is always s1 at time 0. The planners and shortcuts that use this
    /// validator do not need a later state.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override {
        if (checkMotion(s1, s2)) return true;
        lastValid.second = 0;
        if (lastValid.first) si_->copyState(lastValid.first, s1);
        return false;
    }

  private:
    const planning::MotionValidator& validator_;
    double floor_;
    std::function<bool()> isStopped_;
};

}  // namespace clearway::planning
