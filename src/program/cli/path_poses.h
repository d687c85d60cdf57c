// Poses along a path as pictures show them: with their clearances, solid or to be seen through.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/planning/scene_clearance.h"
#include "program/render/render.h"
#include "program/report/path_line.h"

namespace clearway::cli {

constexpr std::size_t kUsualPoses = 4;
constexpr std::size_t kWayPoses = 240;  ///< that the line along the path is drawn through

/// The part at these shares of the path. A pose out of the problem's bounds has all the clearance there is.
/// isPrinted: with a row for each.
std::vector<render::PosedPart> posesAt(const report::PathLine& line, const std::vector<double>& shares,
                                       const planning::SceneClearance& clearance, bool isPrinted);

/// The tightest pose is drawn solid, and the others are unless they run through one that is.
void chooseGhosts(const Model& part, std::vector<render::PosedPart>& poses);

}  // namespace clearway::cli
