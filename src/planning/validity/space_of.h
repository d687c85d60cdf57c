// The space that a constructor's other arguments are made from.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <stdexcept>

namespace clearway::planning {

/// Throws std::invalid_argument when si is null.
inline const ompl::base::StateSpace& spaceOf(const ompl::base::SpaceInformationPtr& si) {
    if (si) return *si->getStateSpace();
    throw std::invalid_argument("the space information is null, expected that of the planner");
}

}  // namespace clearway::planning
