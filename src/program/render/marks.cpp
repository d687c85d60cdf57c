#include "program/render/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "program/render/ink_mask.h"

namespace clearway::render {

namespace {

constexpr double kAxisLength = 0.075;  ///< share of the picture's shorter side
constexpr double kShortest = 0.12;     ///< share of an arrow's length: a shorter one points at the viewer
const Colour kAxisInk = sRgb(40, 42, 48), kHalo = sRgb(255, 255, 255);

struct Arrow {
    char letter;
    double right, down;  ///< in the picture, in lengths of an arrow
};

using Arrows = std::array<Arrow, 3>;  // of x, y and z

Arrows arrowsOf(const Camera& camera) {
    const auto arrow = [&](char letter, int axis) -> Arrow {
        return {letter, camera.right[axis], -camera.up[axis]};
    };
    return {arrow('x', 0), arrow('y', 1), arrow('z', 2)};
}

void drawHead(double x, double y, double alongX, double alongY, double size, double width, InkMask& ink) {
    for (const double side : {-0.5, 0.5}) {
        ink.drawLine(x, y, x - size * (alongX - side * alongY), y - size * (alongY + side * alongX), width);
    }
}

/// widen: how much thicker all lines are, in widths of a line.
void drawArrows(const Arrows& arrows, double x, double y, double length, double widen, InkMask& ink) {
    const double width = std::max(1.2, 0.035 * length) * widen;
    const double letters = 0.24 * length;
    for (const Arrow& arrow : arrows) {
        const double seen = std::hypot(arrow.right, arrow.down);
        const std::string letter(1, arrow.letter);
        if (seen < kShortest) {
            ink.drawCircle(x, y, 0.08 * length, width);
            ink.drawText(letter, x - 0.45 * length, y + 0.45 * length, letters);
            continue;
        }
        const double endX = x + length * arrow.right, endY = y + length * arrow.down;
        ink.drawLine(x, y, endX, endY, width);
        drawHead(endX, endY, arrow.right / seen, arrow.down / seen, 0.18 * length, width, ink);
        const double beyond = 0.26 * length / seen;
        ink.drawText(letter, endX + beyond * arrow.right - 0.5 * ink.widthOf(letter, letters),
                     endY + beyond * arrow.down + 0.4 * letters, letters);
    }
}

constexpr double kRadius = 0.018, kWidth = 0.004;  ///< shares of the picture's height

}  // namespace

Colour markColour() {
    return sRgb(200, 0, 110);
}

void drawMarks(const std::vector<Vector3f>& points, const Camera& camera, Image& image) {
    const double radius = std::max(4.0, kRadius * image.height), width = std::max(1.5, kWidth * image.height);
    InkMask halo(0, image.width, image.height), rings(0, image.width, image.height);
    for (const Vector3f& point : points) {
        const std::optional<Eigen::Vector2f> place = camera.placeOf(point);
        if (!place) continue;
        halo.drawCircle(place->x(), place->y(), radius, 2.5 * width);
        rings.drawCircle(place->x(), place->y(), radius, width);
    }
    halo.layOver(image, kHalo);
    rings.layOver(image, markColour());
}

void drawAxes(const Camera& camera, Image& image) {
    const double length = std::max(22.0, kAxisLength * std::min(image.width, image.height));
    const double x = 1.6 * length, y = image.height - 1.6 * length;
    const Arrows arrows = arrowsOf(camera);
    InkMask halo(0, image.width, image.height), ink(0, image.width, image.height);
    drawArrows(arrows, x, y, length, 3, halo);
    drawArrows(arrows, x, y, length, 1, ink);
    halo.layOver(image, kHalo);
    ink.layOver(image, kAxisInk);
}

}  // namespace clearway::render
