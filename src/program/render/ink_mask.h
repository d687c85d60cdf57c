// Lines and lettering that Cairo draws into a mask of ink, which is then laid over a picture. The font is
// part of the program, so that pictures have letters on machines without fonts.
#pragma once

#include <cairo/cairo.h>

#include <memory>
#include <string>

#include "program/render/camera.h"
#include "program/render/image.h"

namespace clearway::render {

/// The part of a picture right of `left`, as a mask: 0 is the picture, 1 is ink. Coordinates are the
/// picture's.
class InkMask {
  public:
    InkMask(int left, int width, int height);

    void drawLine(double fromX, double fromY, double toX, double toY, double width);
    void drawFrame(const Area& area, double width);
    void fillBox(const Area& area);
    void drawCircle(double x, double y, double radius, double width);
    /// (x, y): the left end of the base line. height: of a digit, pixels.
    void drawText(const std::string& text, double x, double y, double height);
    double widthOf(const std::string& text, double height) const;

    /// From now on no ink gets out of the area.
    void keepWithin(const Area& area);

    /// Throws std::runtime_error if Cairo could not draw.
    void layOver(Image& image, const Colour& colour) const;

  private:
    int left_;
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

}  // namespace clearway::render
