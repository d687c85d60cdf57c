// The light in a picture: a soft key light, the sky all around, and a little light from the camera.
#pragma once

#include <utility>

#include "program/render/camera.h"
#include "program/render/stage.h"

namespace clearway::render {

constexpr float kKeyReach =
    8;  ///< an obstacle farther away does not shade the key light; the stage has size 1

/// The light at a point, and the rays that it was sampled by.
struct Lit {
    float light = 0;
    Vector3f start = Vector3f::Zero();  ///< both rays begin here
    Vector3f sky = Vector3f::Zero();    ///< direction of the ray to the sky
    /// Whether the rays met nothing. False for a ray that begins below the surface and is not traced.
    bool isSkyOpen = false, isKeyOpen = false;
};

class Light {
  public:
    /// reach: obstacles farther away do not darken the sky.
    Light(const Stage& stage, const Camera& camera, float reach);

    /// Samples the light at a point by one ray to the sky and one to the key light. The samples are points of
    /// the unit square.
    Lit at(const SeenPoint& seen, std::pair<float, float> skySample, std::pair<float, float> keySample) const;

    /// The light at a point that nothing shades, for translucent surfaces.
    float unshaded(const SeenPoint& seen) const;

    /// Direction of the ray to the key light; the point plays no part because the light is far away.
    Vector3f towardsKey(std::pair<float, float> keySample) const;

    float reach() const { return reach_; }

  private:
    const Stage& stage_;
    Vector3f key_;     ///< direction to the middle of the key light
    Vector3f camera_;  ///< direction to the camera
    float reach_;
};

}  // namespace clearway::render
