// Lengths among the options of objectives.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"

namespace clearway::planning {

/// The length given, or so large a share of the diagonal of the part's box. Throws std::invalid_argument that
/// names it unless it is finite and above 0.
double lengthOr(const std::optional<double>& given, double share, const Model& part, const std::string& name);

}  // namespace clearway::planning
