// Poses along a path as pictures show them: with their clearances, solid or transparent.
#pragma once

#include <cstddef>
#include <vector>

#include "planning/validity/scene_clearance.h"
#include "program/render/render.h"
#include "program/report/path_line.h"

namespace clearway::cli {

constexpr std::size_t kUsualPoses = 4;
constexpr std::size_t kWayPoses = 240;  ///< of the line drawn along the path

/// The part at these shares of the path. A pose outside the problem's bounds has infinite clearance.
/// isPrinted: also prints a row for each pose.
std::vector<render::PosedPart> posesAt(const report::PathLine& line, const std::vector<double>& shares,
                                       const planning::SceneClearance& clearance, bool isPrinted);

/// Draws the tightest pose solid, and each other pose unless it intersects a solid one.
void chooseGhosts(const Model& part, std::vector<render::PosedPart>& poses);

}  // namespace clearway::cli
