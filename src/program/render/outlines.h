// Draws dark lines around things and fainter lines along their own edges, which make small pictures readable.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"
#include "program/render/stage.h"

namespace clearway::render {

Colour penColour(Pen pen);

/// How much of a pixel lines cover, and in which colour.
struct Ink {
    float share = 0;
    Pen pen = Pen::kPlain;
};

/// The pixels in columns [left, right) and rows [top, bottom).
struct PixelArea {
    int left = 0, top = 0, right = 0, bottom = 0;

    int width() const { return right - left; }
    PixelArea grownBy(int pixels) const {
        return {left - pixels, top - pixels, right + pixels, bottom + pixels};
    }
    PixelArea within(const PixelArea& other) const;
    bool holds(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
};

struct OutlineOptions {
    float width;        ///< of a line, pixels
    PixelArea picture;  ///< the whole picture
};

/// How far a line lies around what it outlines, pixels.
int outlineReach(float width);

/// The ink in an area of the picture, row by row. Each pixel's ink is that of the whole picture.
std::vector<Ink> outlineInk(const Stages& stages, const Camera& camera, const OutlineOptions& options,
                            const PixelArea& area);

void lay(const Ink& ink, Colour& pixel);

/// Draws the lines in the whole picture. width: in pixels.
void drawOutlines(const Stages& stages, const Camera& camera, float width, Image& image);

}  // namespace clearway::render
