#include "program/render/smooth_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace clearway::render {

namespace {

constexpr float kNear = 0.13f;  ///< decay of the weight with the squared distance in pixels
constexpr float kFlat = 40;     ///< decay with 1 - cosine between the normals
constexpr float kGrain =
    18;  ///< decay with the squared difference of light, which keeps the edges of shadows
constexpr float kOffPlane = 1.5f;     ///< largest distance of a neighbour from the tangent plane, pixels
constexpr float kLeastLight = 1e-4f;  ///< darker pixels are not scaled

float weightOf(const PixelLight& here, const PixelLight& there, int dx, int dy) {
    if (!there.isPlain || there.body != here.body) return 0;
    if (std::abs(here.normal.dot(there.point - here.point)) > kOffPlane * here.size) return 0;
    const float bend = std::max(0.0f, 1 - here.normal.dot(there.normal));
    const float grain = there.light - here.light;
    return std::exp(-kNear * static_cast<float>(dx * dx + dy * dy) - kFlat * bend - kGrain * grain * grain);
}

}  // namespace

void smoothLight(const std::vector<PixelLight>& lights, Image& image,
                 const std::vector<std::uint8_t>& chosen) {
    const auto lightAt = [&](int x, int y) -> const PixelLight& { return lights[image.indexOf(x, y)]; };
    tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x) {
            if (!chosen.empty() && chosen[image.indexOf(x, y)] == 0) continue;
            const PixelLight& here = lightAt(x, y);
            if (!here.isPlain || here.light < kLeastLight) continue;
            float sum = 0, weights = 0;
            for (int j = std::max(0, y - kSmoothReach); j <= std::min(image.height - 1, y + kSmoothReach);
                 ++j) {
                for (int i = std::max(0, x - kSmoothReach); i <= std::min(image.width - 1, x + kSmoothReach);
                     ++i) {
                    const float weight = weightOf(here, lightAt(i, j), i - x, j - y);
                    sum += weight * lightAt(i, j).light;
                    weights += weight;
                }
            }
            image.at(x, y) *= sum / weights / here.light;  // weights >= 1, the weight of the pixel itself
        }
    });
}

}  // namespace clearway::render
