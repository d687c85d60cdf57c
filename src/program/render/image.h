// A picture while it is being made: linear light in floats.
#pragma once

#include <string>
#include <vector>

#include "core/colour.h"

namespace clearway::render {

struct Image {
    int width = 0, height = 0;
    std::vector<Colour> pixels;  ///< row by row from the top

    Image(int w, int h, const Colour& colour)
        : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), colour) {}
    Colour& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Colour& at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

/// Writes an 8-bit sRGB PNG. To a temporary name, then renamed. Throws std::runtime_error when it cannot.
void writePng(const Image& image, const std::string& file);

}  // namespace clearway::render
