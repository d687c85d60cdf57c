#include "program/render/exposure.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include "program/render/outlines.h"
#include "program/render/pixel.h"
#include "program/render/smooth_light.h"

namespace clearway::render {

Image expose(const Stages& stages, const Camera& camera, const Exposure& exposure) {
    Image image(exposure.width, exposure.height, exposure.background);
    std::vector<PixelLight> lights(image.pixels.size());
    const Light light(stages.solids, camera, exposure.lightReach);
    forEachPixel(exposure, [&](int x, int y) {
        image.at(x, y) = Pixel(stages, light, exposure, x, y).colour(camera, lights[image.indexOf(x, y)]);
    });
    smoothLight(lights, image);
    lights = {};  // frees gigabytes when the picture is large
    if (exposure.lineWidth > 0 && !exposure.isStopped())
        drawOutlines(stages, camera, exposure.lineWidth, image);
    return image;
}

void forEachPixel(const Exposure& exposure, const std::function<void(int, int)>& work) {
    constexpr int kTile = 16;
    const tbb::blocked_range2d<int> all(0, exposure.height, kTile, 0, exposure.width, kTile);
    tbb::parallel_for(all, [&](const tbb::blocked_range2d<int>& tile) {
        if (exposure.isStopped()) return;
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y) {
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) work(x, y);
        }
    });
}

}  // namespace clearway::render
