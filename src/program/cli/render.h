// Poses along a path as pictures show them: with their clearances, solid or translucent.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/scene_clearance.h"
#include "problem/path_line.h"
#include "program/render/render.h"

namespace clearway::cli {

constexpr std::size_t kUsualPoses = 4;
constexpr std::size_t kWayPoses = 240;  ///< poses of the line drawn along the path

/// Poses the part at these shares of the path. A pose outside the problem's bounds has infinite clearance.
/// isPrinted: also prints a row for each pose.
std::vector<render::PosedPart> posesAt(const PathLine& line, const std::vector<double>& shares,
                                       const SceneClearance& clearance, bool isPrinted);

/// Draws the pose of least clearance solid, and each other pose unless it intersects a solid one.
void chooseGhosts(const Model& part, std::vector<render::PosedPart>& poses);

}  // namespace clearway::cli
