// Cells of CSV files, separated by commas; numbers have 17 digits.
#pragma once

#include <string>

#include "clearway/problem.h"
#include "clearway/types.h"

namespace clearway::cli {

/// The text, in quotes where it needs them (RFC 4180).
std::string textCell(const std::string& text);

std::string numberCells(const Vector3& point);

/// x, y, z and a quaternion with w last.
std::string numberCells(const PartState& state);
std::string numberCells(const Pose& pose);

}  // namespace clearway::cli
