// Going forward along motions by whatever validator a space information has.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// How far motions are valid. Validators of clearway are asked no more closely than the caller needs.
class ForwardCheck {
  public:
    /// The space information must outlive this object, and keep its motion validator.
    explicit ForwardCheck(const ompl::base::SpaceInformationPtr& si);

    /// Returns the time in [0, 1] up to which a motion is valid, 1 for all of it. within: see ForwardOptions.
    double operator()(const ompl::base::State* s1, const ompl::base::State* s2, double within) const;

  private:
    const ompl::base::SpaceInformation& si_;
    const MotionValidator* validator_ = nullptr;  ///< null for a validator that is not one of clearway's
    double floor_ = 0;
};

}  // namespace clearway::planning
