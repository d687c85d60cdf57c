// Takes the samples of one pixel.
#pragma once

#include <cstdint>
#include <limits>

#include "program/render/exposure.h"
#include "program/render/light.h"
#include "program/render/samples.h"
#include "program/render/smooth_light.h"

namespace clearway::render {

/// The ray of one sample in a scene, as far as it tells whether one more body would change the sample.
struct KeptRay {
    Vector3f start = Vector3f::Zero(), sky = Vector3f::Zero();  ///< as in Lit
    float along = std::numeric_limits<float>::infinity();       ///< where the ray met something
    bool isSkyOpen = false, isKeyOpen = false;                  ///< as in Lit
};

class Pixel {
  public:
    Pixel(const Stages& stages, const Light& light, const Exposure& exposure, int x, int y);

    /// met: returns the averages over the rays. kept: room for one entry a sample, or null.
    Colour colour(const Camera& camera, PixelLight& met, KeptRay* kept = nullptr) const;

    /// Whether a body that is added to the scene of the kept rays can change the pixel. mayHide: the body may
    /// lie in front of the pixel; if false, only its shadow counts.
    bool isChangedBy(const RayScene& added, const Camera& camera, const KeptRay* kept, bool mayHide) const;

  private:
    struct Place {
        float x, y;
    };
    Pixel(const Stages& stages, const Light& light, const Exposure& exposure, Place corner,
          std::uint32_t seed, std::uint32_t mask);
    Place placeOf(std::uint32_t sample) const;
    Colour shown(const SeenPoint& seen, const Place& place) const;
    Colour throughGhosts(const Ray& ray, const Place& place, const RayHit& end, Colour behind,
                         bool& isPlain) const;

    const Stages& stages_;
    const Light& light_;
    const Exposure& exposure_;
    Place corner_;
    SquareSamples place_, sky_, key_;
};

}  // namespace clearway::render
