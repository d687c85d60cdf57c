// Going forward along motions by whatever validator a space information has.
#pragma once

#include "planning/check/floor_validator.h"

namespace clearway::planning {

/// How far motions are valid. Validators of clearway are asked no more closely than the caller needs.
class ForwardCheck {
  public:
    /// The space information must outlive this object, and keep its motion validator.
    explicit ForwardCheck(const ompl::base::SpaceInformationPtr& si) : given_(*si->getMotionValidator()) {
        const auto* raised = dynamic_cast<const FloorValidator*>(&given_);
        validator_ = raised ? &raised->validator() : dynamic_cast<const MotionValidator*>(&given_);
        if (raised) floor_ = raised->floor();
    }

    /// Returns the time in [0, 1] up to which a motion is valid, 1 for all of it. within: see ForwardOptions.
    double operator()(const ompl::base::State* s1, const ompl::base::State* s2, double within) const {
        if (validator_ != nullptr) return validator_->validUntil(s1, s2, {within, floor_});
        std::pair<ompl::base::State*, double> lastValid(nullptr, 1);
        return given_.checkMotion(s1, s2, lastValid) ? 1 : lastValid.second;
    }

  private:
    const ompl::base::MotionValidator& given_;
    const MotionValidator* validator_;  ///< null for a validator that is not one of clearway's
    double floor_ = 0;
};

}  // namespace clearway::planning
