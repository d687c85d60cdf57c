#include "program/render/marks.h"

#include <algorithm>

#include "program/render/ink_mask.h"

namespace clearway::render {

namespace {

constexpr double kRadius = 0.018, kWidth = 0.004;  ///< shares of the picture's height
const Colour kHalo = sRgb(255, 255, 255);

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

}  // namespace clearway::render
