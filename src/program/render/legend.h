// The colour scale at the right side of a picture: the meaning of the part's colours.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

/// The area of the picture that the legend leaves to the scene.
Area areaBesideLegend(int width, int height);

/// Draws the scale from 0 to `most` with a mark for each of the clearances.
void drawLegend(double most, const std::vector<double>& clearances, Image& image);

}  // namespace clearway::render
