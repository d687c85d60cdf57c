// Draws dark lines around things and fainter lines along their own edges, which make small pictures readable.
#pragma once

#include "program/render/camera.h"
#include "program/render/image.h"
#include "program/render/stage.h"

namespace clearway::render {

/// width: line width in pixels.
void drawOutlines(const Stages& stages, const Camera& camera, float width, Image& image);

}  // namespace clearway::render
