#include "program/render/marks.h"

#include <algorithm>

#include "program/render/ink_mask.h"

namespace clearway::render {

namespace {

constexpr double kRadius = 0.018, kWidth = 0.004;  ///< shares of the picture's height
const Colour kHalo = sRgb(255, 255, 255), kRing = sRgb(200, 0, 110);

}  // namespace

void drawMarks(const std::vector<Vector3f>& points, const Camera& camera, Image& image) {
    const double radius = std::max(4.0, kRadius * image.height), width = std::max(1.5, kWidth * image.height);
    InkMask halo(0, image.width, image.height), rings(0, image.width, image.height);
    for (const Vector3f& point : points) {
        const Vector3f seen = point - camera.eye;
        const float depth = camera.forward.dot(seen);
        if (!(depth > 0)) continue;
        const double x = camera.centreX + camera.focal * camera.right.dot(seen) / depth;
        const double y = camera.centreY - camera.focal * camera.up.dot(seen) / depth;
        halo.drawCircle(x, y, radius, 2.5 * width);
        rings.drawCircle(x, y, radius, width);
    }
    halo.layOver(image, kHalo);
    rings.layOver(image, kRing);
}

}  // namespace clearway::render
