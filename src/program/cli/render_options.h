// The options of pictures and films: size, camera, what is drawn beside the part.
#pragma once

#include <string>
#include <vector>

#include "program/options/command_line.h"
#include "program/render/render.h"

namespace clearway::cli {

constexpr int kLeastSide = 16, kLargestSide = 16384;  ///< of a picture, pixels

/// Declares --size, the options of the camera, --scale, --axes and --samples.
void addDrawing(CommandLine& line, render::RenderOptions& drawing);

/// Reads numbers with commas between them. Throws Expected.
std::vector<double> numbersOf(const std::string& text, const std::string& expected);

}  // namespace clearway::cli
