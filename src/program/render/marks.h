// Rings around places of interest, and the axes' directions: drawn over the picture, so that nothing hides them.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

Colour markColour();

/// Draws a ring around each point that the camera sees or that is hidden from it, not around those behind it.
/// Points in the camera's coordinates.
void drawMarks(const std::vector<Vector3f>& points, const Camera& camera, Image& image);

/// Draws an arrow with its letter for each of x, y and z in the lower left corner, as the camera sees their directions from far
/// away.
void drawAxes(const Camera& camera, Image& image);

}  // namespace clearway::render
