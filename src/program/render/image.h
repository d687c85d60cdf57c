// A picture in linear light, as floats, and its PNG file.
#pragma once

#include <string>
#include <vector>

#include "program/render/colour.h"

namespace clearway::render {

struct Image {
    int width = 0, height = 0;
    std::vector<Colour> pixels;  ///< rows from top to bottom

    Image(int w, int h, const Colour& colour)
        : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), colour) {}
    std::size_t indexOf(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
    Colour& at(int x, int y) { return pixels[indexOf(x, y)]; }
    const Colour& at(int x, int y) const { return pixels[indexOf(x, y)]; }
};

/// The picture as 8-bit sRGB: red, green and blue of each pixel.
std::vector<std::uint8_t> bytesOf(const Image& image);

/// Writes an 8-bit sRGB PNG under a temporary name and renames it. Throws std::runtime_error on failure.
void writePng(const Image& image, const std::string& file);

}  // namespace clearway::render
