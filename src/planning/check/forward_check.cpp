#include "planning/check/forward_check.h"

#include "clearway/planning/motion_validator.h"
#include "planning/check/floor_validator.h"

namespace clearway::planning {

namespace ob = ompl::base;

ForwardCheck::ForwardCheck(const ob::SpaceInformationPtr& si) : si_(*si) {
    const ob::MotionValidator* given = si->getMotionValidator().get();
    if (const auto* raised = dynamic_cast<const FloorValidator*>(given)) {
        validator_ = &raised->validator();
        floor_ = raised->floor();
    } else {
        validator_ = dynamic_cast<const MotionValidator*>(given);
    }
}

double ForwardCheck::operator()(const ob::State* s1, const ob::State* s2, double within) const {
    if (validator_ != nullptr) return validator_->validUntil(s1, s2, {within, floor_});
    std::pair<ob::State*, double> lastValid(nullptr, 1);
    return si_.getMotionValidator()->checkMotion(s1, s2, lastValid) ? 1 : lastValid.second;
}

}  // namespace clearway::planning
