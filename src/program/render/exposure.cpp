#include "program/render/exposure.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "program/render/light.h"
#include "program/render/outlines.h"
#include "program/render/samples.h"
#include "program/render/smooth_light.h"

namespace clearway::render {

namespace {

constexpr int kMostGhosts = 4;  ///< one behind the other
constexpr int kMostWalls = 24;  ///< of ghosts, that a ray is followed through
constexpr float kPast = 1e-5f;  ///< along the ray, beyond a wall of a ghost

std::uint32_t maskFor(int samples) {
    std::uint32_t mask = 0;
    while (static_cast<int>(mask) + 1 < samples) mask = 2 * mask + 1;
    return mask;
}

/// Sums over the rays of a pixel.
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

/// The samples of one pixel.
class Pixel {
  public:
    Pixel(const Stages& stages, const Light& light, const Exposure& exposure, int x, int y)
        : Pixel(stages, light, exposure, x, y,
                mixed(static_cast<std::uint32_t>(y) * 0x9e3779b9u + static_cast<std::uint32_t>(x)),
                maskFor(exposure.samples)) {}

    /// met: filled with what the rays met.
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

    /// Of each ghost the wall nearest to the camera counts, so that what is inside does not blur it.
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
        const bool isVeil = stages_.solids.isOnScale(end);  // orange behind blue would be the scale's red
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
    lights = {};  // of a large picture gigabytes
    if (exposure.lineWidth > 0) drawOutlines(stages, camera, exposure.lineWidth, image);
    return image;
}

}  // namespace clearway::render
