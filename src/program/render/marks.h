// Rings around places of interest, drawn over the picture, so that nothing hides them.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

Colour markColour();

/// Draws a ring around each point that the camera sees or that is hidden from it, not around those behind it.
/// Points in the camera's coordinates.
void drawMarks(const std::vector<Vector3f>& points, const Camera& camera, Image& image);

}  // namespace clearway::render
