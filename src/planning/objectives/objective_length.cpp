#include "planning/objectives/objective_length.h"

#include <cmath>
#include <stdexcept>

#include "core/number.h"

namespace clearway::planning {

double lengthOr(const std::optional<double>& given, double share, const Model& part,
                const std::string& name) {
    const double length = given ? *given : share * part.box().diagonal().norm();
    if (length > 0 && std::isfinite(length)) return length;
    throw std::invalid_argument(name + " is " + shortNumber(length) + ", expected a finite length above 0");
}

}  // namespace clearway::planning
