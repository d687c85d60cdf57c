// Strokes, areas and small lettering on a picture, anti-aliased.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

using PicturePoint = std::pair<double, double>;  ///< pixels; y goes down

void drawStroke(const std::vector<PicturePoint>& points, double width, const Colour& colour, Image& image);

void fillArea(const Area& area, const Colour& colour, Image& image);

/// The text with the left end of its base line at the place, its figures `height` pixels high. Digits, the
/// letters of "clearance", and . - + are known; others leave a gap.
void drawText(const std::string& text, PicturePoint place, double height, const Colour& colour, Image& image);

/// How wide drawText makes it.
double widthOfText(const std::string& text, double height);

}  // namespace clearway::render
