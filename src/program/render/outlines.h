// Dark lines where one thing ends before another, and fainter ones along its own edges: what a reader of a
// small picture goes by.
#pragma once

#include "program/render/camera.h"
#include "program/render/image.h"
#include "program/render/stage.h"

namespace clearway::render {

/// width: pixels.
void drawOutlines(const Stages& stages, const Camera& camera, float width, Image& image);

}  // namespace clearway::render
