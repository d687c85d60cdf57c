// The small drawings of a legend, each beside its words.
#pragma once

#include "program/render/camera.h"
#include "program/render/legend.h"

namespace clearway::render {

/// Draws the sign into an area of the legend.
void drawSign(Sign sign, const Area& area, Image& image);

}  // namespace clearway::render
