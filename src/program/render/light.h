// The light on what a ray met: a soft key light, the sky all around, a little from the camera.
#pragma once

#include <utility>

#include "program/render/camera.h"
#include "program/render/stage.h"

namespace clearway::render {

class Light {
  public:
    /// reach: how far away something still darkens the sky.
    Light(const Stage& stage, const Camera& camera, float reach);

    /// The light that reaches the point, as seen along one ray to the sky and one to the key light, which two
    /// points of the unit square choose.
    float at(const SeenPoint& seen, std::pair<float, float> skySample,
             std::pair<float, float> keySample) const;

    /// The same without anything in its way: what is seen through takes no shade.
    float unshaded(const SeenPoint& seen) const;

  private:
    const Stage& stage_;
    Vector3f key_;  ///< towards it
    Vector3f camera_;
    float reach_;
};

}  // namespace clearway::render
