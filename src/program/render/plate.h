// A picture of a scene in which nothing moves, kept with all its rays. A picture with one more body then
// traces anew only those pixels that this body hides or shades.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/exposure.h"
#include "program/render/outlines.h"
#include "program/render/pixel.h"

namespace clearway::render {

class Plate {
  public:
    /// Whether the rays of such a picture fit into the memory that a plate may take.
    static bool canHold(const Exposure& exposure);

    /// Takes the picture. The arguments must outlive the plate.
    Plate(const Stages& stages, const Camera& camera, const Exposure& exposure);

    /// The picture with one more solid body, which `stages` now shows beside all others. added: holds this
    /// body alone. area: all pixels that it can hide. Equals what expose() returns.
    Image with(const RayScene& added, const PixelArea& area) const;

  private:
    PixelArea picture() const { return {0, 0, exposure_.width, exposure_.height}; }
    const KeptRay* raysAt(std::size_t pixel) const {
        return &rays_[pixel * static_cast<std::size_t>(exposure_.samples)];
    }
    void smooth(const std::vector<std::uint8_t>& isChanged, const std::vector<PixelLight>& lights,
                Image& image) const;
    void drawInk(const PixelArea& area, Image& image) const;

    const Stages& stages_;
    const Camera& camera_;
    const Exposure& exposure_;
    Light light_;
    Image rough_;   ///< before light is smoothed
    Image smooth_;  ///< before outlines are drawn
    std::vector<PixelLight> lights_;
    std::vector<KeptRay> rays_;
    std::vector<Ink> ink_;
};

}  // namespace clearway::render
