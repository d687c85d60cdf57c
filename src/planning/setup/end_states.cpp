#include "planning/setup/end_states.h"

#include <stdexcept>

namespace clearway::planning {

double requireValid(const ValidityChecker& checker, const ompl::base::State* state, const std::string& what) {
    double clearance = 0;
    if (checker.isValid(state, clearance)) return clearance;
    throw std::invalid_argument(what + " is " + checker.whyInvalid(state));
}

}  // namespace clearway::planning
