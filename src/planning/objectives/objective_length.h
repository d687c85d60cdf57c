// Lengths among the options of objectives.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"
#include "clearway/planning/clearance_objectives.h"

namespace clearway::planning {

/// The length given, or so large a share of the diagonal of the part's box. Throws std::invalid_argument that
/// names it unless it is finite and above 0.
double lengthOr(const std::optional<double>& given, double share, const Model& part, const std::string& name);

/// What the options want of a part, or by default.
double wantedClearance(const LengthWithClearanceOptions& options, const Model& part);

}  // namespace clearway::planning
