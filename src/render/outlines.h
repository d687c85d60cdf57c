// Dark lines where one thing ends before another, and fainter ones along its own edges: what a reader of a
// small picture goes by.
#pragma once

#include "render/camera.h"
#include "render/image.h"
#include "render/stage.h"

namespace clearway {

/// width: pixels.
void drawOutlines(const Stages& stages, const Camera& camera, float width, Image& image);

}  // namespace clearway
