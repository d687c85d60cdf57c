// The colour scale at a picture's right side: what the part's colours mean.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

/// What is left of the picture for the scene.
Area areaBesideLegend(int width, int height);

/// most: the clearance at the top of the scale. clearances: of the poses shown; each gets a mark.
void drawLegend(double most, const std::vector<double>& clearances, Image& image);

}  // namespace clearway::render
