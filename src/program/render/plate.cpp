#include "program/render/plate.h"

#include <algorithm>

namespace clearway::render {

namespace {

constexpr std::size_t kMostMemory = std::size_t(1) << 30;  ///< of the kept rays, bytes

/// 1 for each pixel with a changed one within this many rows and columns.
std::vector<std::uint8_t> spread(const std::vector<std::uint8_t>& isChanged, const Image& image, int reach) {
    std::vector<std::uint8_t> isNear(isChanged.size(), 0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (isChanged[image.indexOf(x, y)] == 0) continue;
            const PixelArea near =
                PixelArea{x, y, x + 1, y + 1}.grownBy(reach).within({0, 0, image.width, image.height});
            for (int row = near.top; row < near.bottom; ++row)
                std::fill_n(&isNear[image.indexOf(near.left, row)], near.width(), 1);
        }
    }
    return isNear;
}

}  // namespace

bool Plate::canHold(const Exposure& exposure) {
    const auto pixels = static_cast<std::size_t>(exposure.width) * static_cast<std::size_t>(exposure.height);
    return pixels <= kMostMemory / sizeof(KeptRay) / static_cast<std::size_t>(exposure.samples);
}

Plate::Plate(const Stages& stages, const Camera& camera, const Exposure& exposure)
    : stages_(stages),
      camera_(camera),
      exposure_(exposure),
      light_(stages.solids, camera, exposure.lightReach),
      rough_(exposure.width, exposure.height, exposure.background),
      smooth_(rough_),
      lights_(rough_.pixels.size()),
      rays_(rough_.pixels.size() * static_cast<std::size_t>(exposure.samples)) {
    forEachPixel(exposure_, [&](int x, int y) {
        const std::size_t i = rough_.indexOf(x, y);
        KeptRay* const rays = &rays_[i * static_cast<std::size_t>(exposure_.samples)];
        rough_.pixels[i] = Pixel(stages_, light_, exposure_, x, y).colour(camera_, lights_[i], rays);
    });
    smooth_ = rough_;
    smoothLight(lights_, smooth_);
    ink_.resize(rough_.pixels.size());
    if (exposure_.lineWidth > 0 && !exposure_.isStopped())
        ink_ = outlineInk(stages_, camera_, {exposure_.lineWidth, picture()}, picture());
}

Image Plate::with(const RayScene& added, const PixelArea& area) const {
    Image image = rough_;
    std::vector<PixelLight> lights = lights_;
    std::vector<std::uint8_t> isChanged(lights.size(), 0);
    forEachPixel(exposure_, [&](int x, int y) {
        const std::size_t i = image.indexOf(x, y);
        const Pixel pixel(stages_, light_, exposure_, x, y);
        if (!pixel.isChangedBy(added, camera_, raysAt(i), area.holds(x, y))) return;
        isChanged[i] = 1;
        image.pixels[i] = pixel.colour(camera_, lights[i]);
    });
    smooth(isChanged, lights, image);
    if (exposure_.lineWidth > 0) drawInk(area.grownBy(outlineReach(exposure_.lineWidth)), image);
    return image;
}

void Plate::smooth(const std::vector<std::uint8_t>& isChanged, const std::vector<PixelLight>& lights,
                   Image& image) const {
    const std::vector<std::uint8_t> isNear = spread(isChanged, image, kSmoothReach);
    smoothLight(lights, image, isNear);
    for (std::size_t i = 0; i < isNear.size(); ++i) {
        if (isNear[i] == 0) image.pixels[i] = smooth_.pixels[i];
    }
}

void Plate::drawInk(const PixelArea& area, Image& image) const {
    const PixelArea fresh = area.within(picture());
    const bool isSeen = fresh.left < fresh.right && fresh.top < fresh.bottom;
    std::vector<Ink> ink;
    if (isSeen) ink = outlineInk(stages_, camera_, {exposure_.lineWidth, picture()}, fresh);
    auto next = ink.begin();
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t i = image.indexOf(x, y);
            lay(isSeen && fresh.holds(x, y) ? *next++ : ink_[i], image.pixels[i]);
        }
    }
}

}  // namespace clearway::render
