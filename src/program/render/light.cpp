#include "program/render/light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace clearway::render {

namespace {

constexpr float kSky = 0.54f, kKey = 0.48f,
                kFromCamera = 0.20f;  ///< shares of the sky, the key light and a light at the camera
/// Light that nothing shades: no pixel is black, and all can be smoothed.
constexpr float kEverywhere = 0.03f;
constexpr float kKeyRadius = 0.16f;  ///< radius of the key light's disk at distance 1
constexpr float kStep = 2e-5f;       ///< lifts rays off the surface they begin on; the stage has size 1

/// Maps the unit square to the disk of radius 1. Source: Shirley, Chiu, A Low Distortion Map Between Disk and
/// Square, 1997.
std::pair<float, float> onDisk(std::pair<float, float> square) {
    const float a = 2 * square.first - 1, b = 2 * square.second - 1;
    if (a == 0 && b == 0) return {0, 0};
    const auto quarter = static_cast<float>(M_PI / 4);
    const bool isFlat = std::abs(a) > std::abs(b);
    const float radius = isFlat ? a : b;
    const float angle = isFlat ? quarter * (b / a) : quarter * (2 - a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Light::Light(const Stage& stage, const Camera& camera, float reach)
    : stage_(stage),
      key_((-camera.forward - 0.55f * camera.right + 0.9f * camera.up).normalized()),
      camera_(-camera.forward),
      reach_(reach) {}

float Light::unshaded(const SeenPoint& seen) const {
    return kEverywhere + kFromCamera * std::max(0.0f, seen.normal.dot(camera_)) + kSky +
           kKey * std::max(0.0f, seen.normal.dot(key_));
}

Vector3f Light::towardsKey(std::pair<float, float> keySample) const {
    const auto [right, up] = onDisk(keySample);
    const Vector3f aside = key_.unitOrthogonal();
    return (key_ + kKeyRadius * (right * aside + up * key_.cross(aside))).normalized();
}

Lit Light::at(const SeenPoint& seen, std::pair<float, float> skySample,
              std::pair<float, float> keySample) const {
    Lit lit;
    lit.start = seen.point + kStep * seen.facet;
    const Vector3f across = seen.normal.unitOrthogonal();
    const auto [x, y] = onDisk(skySample);
    const float height = std::sqrt(std::max(0.0f, 1 - x * x - y * y));
    lit.sky = x * across + y * seen.normal.cross(across) + height * seen.normal;
    lit.light = kEverywhere + kFromCamera * std::max(0.0f, seen.normal.dot(camera_));
    lit.isSkyOpen = lit.sky.dot(seen.facet) > 0 && !stage_.rays().isBlocked({lit.start, lit.sky}, reach_);
    if (lit.isSkyOpen) lit.light += kSky * (0.85f + 0.15f * lit.sky.z());
    const Vector3f key = towardsKey(keySample);
    const float slope = seen.normal.dot(key);
    lit.isKeyOpen =
        slope > 0 && key.dot(seen.facet) > 0 && !stage_.rays().isBlocked({lit.start, key}, kKeyReach);
    if (lit.isKeyOpen) lit.light += kKey * slope;
    return lit;
}

}  // namespace clearway::render
