// The directions of the environment's axes, drawn in the lower left corner of a picture.
#pragma once

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

/// Draws an arrow with its letter for each of x, y and z, as the camera sees their directions from far away.
void drawAxes(const Camera& camera, Image& image);

}  // namespace clearway::render
