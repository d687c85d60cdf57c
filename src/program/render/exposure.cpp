#include "program/render/exposure.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "program/render/outlines.h"
#include "program/render/samples.h"
#include "program/render/smooth_light.h"

namespace clearway::render {

namespace {

constexpr int kMostGhosts = 4;  ///< ghosts seen one behind another
constexpr int kMostWalls = 24;  ///< walls of ghosts that one ray passes
constexpr float kPast = 1e-5f;  ///< restarts a ray beyond the wall of a ghost; lengths along the ray

constexpr float kSky = 0.54f, kKey = 0.48f,
                kFromCamera = 0.20f;  ///< shares of the sky, the key light and a light at the camera
constexpr float kKeyRadius = 0.16f;   ///< radius of the key light's disk at distance 1
constexpr float kStep = 2e-5f;        ///< lifts rays off the surface they begin on; the stage has size 1

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

/// Lights a point: a soft key light, the sky all around, and a little light from the camera.
class Light {
  public:
    /// reach: obstacles farther away do not darken the sky.
    Light(const Stage& stage, const Camera& camera, float reach);

    /// The light at a point, sampled by one ray to the sky and one to the key light. The samples are points
    /// of the unit square.
    float at(const SeenPoint& seen, std::pair<float, float> skySample,
             std::pair<float, float> keySample) const;

    /// The light at a point that nothing shades, for translucent surfaces.
    float unshaded(const SeenPoint& seen) const;

  private:
    const Stage& stage_;
    Vector3f key_;     ///< direction to the key light
    Vector3f camera_;  ///< direction to the camera
    float reach_;
};

Light::Light(const Stage& stage, const Camera& camera, float reach)
    : stage_(stage),
      key_((-camera.forward - 0.55f * camera.right + 0.9f * camera.up).normalized()),
      camera_(-camera.forward),
      reach_(reach) {}

float Light::unshaded(const SeenPoint& seen) const {
    return kFromCamera * std::max(0.0f, seen.normal.dot(camera_)) + kSky +
           kKey * std::max(0.0f, seen.normal.dot(key_));
}

float Light::at(const SeenPoint& seen, std::pair<float, float> skySample,
                std::pair<float, float> keySample) const {
    const Vector3f start = seen.point + kStep * seen.facet;
    const Vector3f across = seen.normal.unitOrthogonal();
    const auto [x, y] = onDisk(skySample);
    const float height = std::sqrt(std::max(0.0f, 1 - x * x - y * y));
    const Vector3f sky = x * across + y * seen.normal.cross(across) + height * seen.normal;
    float light = kFromCamera * std::max(0.0f, seen.normal.dot(camera_));
    if (sky.dot(seen.facet) > 0 && !stage_.rays().isBlocked({start, sky}, reach_)) {
        light += kSky * (0.85f + 0.15f * sky.z());
    }
    const auto [right, up] = onDisk(keySample);
    const Vector3f aside = key_.unitOrthogonal();
    const Vector3f key = (key_ + kKeyRadius * (right * aside + up * key_.cross(aside))).normalized();
    const float slope = seen.normal.dot(key);
    if (slope > 0 && key.dot(seen.facet) > 0 && !stage_.rays().isBlocked({start, key}, 8.0f))
        light += kKey * slope;
    return light;
}

std::uint32_t maskFor(int samples) {
    std::uint32_t mask = 0;
    while (static_cast<int>(mask) + 1 < samples) mask = 2 * mask + 1;
    return mask;
}

/// Averages what the rays of one pixel met.
struct Mean {
    PixelLight sums;
    float along = 0;
    int count = 0;
    bool isPlain = true;

    void add(const RayHit& hit, const SeenPoint& seen, float light) {
        if (count++ == 0) sums.body = hit.body;
        isPlain &= sums.body == hit.body;
        sums.light += light;
        sums.point += seen.point;
        sums.normal += seen.normal;
        along += hit.along;
    }
    PixelLight over(int samples, float focal) const {
        PixelLight mean = sums;
        const float share = 1 / static_cast<float>(samples);
        mean.isPlain = isPlain && count == samples;
        mean.light *= share;
        mean.point *= share;
        mean.normal.stableNormalize();
        mean.size = share * along / focal;
        return mean;
    }
};

/// Takes the samples of one pixel.
class Pixel {
  public:
    Pixel(const Stages& stages, const Light& light, const Exposure& exposure, int x, int y)
        : Pixel(stages, light, exposure, x, y,
                mixed(static_cast<std::uint32_t>(y) * 0x9e3779b9u + static_cast<std::uint32_t>(x)),
                maskFor(exposure.samples)) {}

    /// met: returns the averages over the rays.
    Colour colour(const Camera& camera, PixelLight& met) const {
        Colour sum = Colour::Zero();
        Mean mean;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(exposure_.samples); ++i) {
            const auto [dx, dy] = place_(i);
            sum += colourAlong(camera.rayThrough(x_ + dx, y_ + dy), i, mean);
        }
        met = mean.over(exposure_.samples, camera.focal);
        return sum / static_cast<float>(exposure_.samples);
    }

  private:
    Pixel(const Stages& stages, const Light& light, const Exposure& exposure, int x, int y,
          std::uint32_t seed, std::uint32_t mask)
        : stages_(stages),
          light_(light),
          exposure_(exposure),
          x_(static_cast<float>(x)),
          y_(static_cast<float>(y)),
          place_(seed, mask),
          sky_(seed + 1, mask),
          key_(seed + 2, mask) {}

    Colour colourAlong(const Ray& ray, std::uint32_t i, Mean& mean) const {
        const RayHit hit = stages_.solids.rays().nearest(ray);
        Colour behind = exposure_.background;
        if (hit.isHit) {
            const SeenPoint seen = stages_.solids.seenAt(ray, hit);
            const float light = light_.at(seen, sky_(i), key_(i));
            behind = light * seen.colour;
            mean.add(hit, seen, light);
        }
        return stages_.ghosts.isEmpty() ? behind : throughGhosts(ray, hit, behind, mean);
    }

    /// Only the nearest wall of each ghost counts, so that the inside of a ghost does not blur it.
    Colour throughGhosts(Ray ray, const RayHit& end, Colour behind, Mean& mean) const {
        std::array<RayHit, kMostGhosts> met;
        int count = 0;
        for (int wall = 0; wall < kMostWalls && count < kMostGhosts; ++wall) {
            const RayHit hit = stages_.ghosts.rays().nearest(ray);
            if (!hit.isHit || (end.isHit && hit.along > end.along - kGhostGap)) break;
            const auto isSame = [&](const RayHit& other) { return other.body == hit.body; };
            if (std::none_of(met.begin(), met.begin() + count, isSame)) met[count++] = hit;
            ray.least = hit.along + kPast;
        }
        mean.isPlain &= count == 0;
        const bool isVeil =
            stages_.solids.isOnScale(end);  // a blue ghost over orange would read as the red of the scale
        while (count-- > 0) {
            const SeenPoint seen = stages_.ghosts.seenAt(ray, met[count]);
            const Colour ghost = light_.unshaded(seen) * (isVeil ? Colour(Colour::Ones()) : seen.colour);
            behind += (isVeil ? exposure_.veilShare : exposure_.ghostShare) * (ghost - behind);
        }
        return behind;
    }

    const Stages& stages_;
    const Light& light_;
    const Exposure& exposure_;
    float x_, y_;
    SquareSamples place_, sky_, key_;
};

}  // namespace

Image expose(const Stages& stages, const Camera& camera, const Exposure& exposure) {
    Image image(exposure.width, exposure.height, exposure.background);
    std::vector<PixelLight> lights(image.pixels.size());
    const Light light(stages.solids, camera, exposure.lightReach);
    constexpr int kTile = 16;
    tbb::parallel_for(tbb::blocked_range2d<int>(0, image.height, kTile, 0, image.width, kTile),
                      [&](const tbb::blocked_range2d<int>& tile) {
                          for (int y = tile.rows().begin(); y < tile.rows().end(); ++y) {
                              for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                                  PixelLight& met =
                                      lights[std::size_t(y) * std::size_t(image.width) + std::size_t(x)];
                                  image.at(x, y) = Pixel(stages, light, exposure, x, y).colour(camera, met);
                              }
                          }
                      });
    smoothLight(lights, image);
    lights = {};  // frees gigabytes when the picture is large
    if (exposure.lineWidth > 0) drawOutlines(stages, camera, exposure.lineWidth, image);
    return image;
}

}  // namespace clearway::render
