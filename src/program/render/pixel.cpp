#include "program/render/pixel.h"

#include <cmath>

namespace clearway::render {

namespace {

constexpr float kHatchShare = 0.3f;  ///< share of a hatched surface that its lines cover
const Colour kHatch = Colour::Constant(0.01f);

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

}  // namespace

Pixel::Pixel(const Stages& stages, const Light& light, const Exposure& exposure, int x, int y)
    : Pixel(stages, light, exposure, {static_cast<float>(x), static_cast<float>(y)},
            mixed(static_cast<std::uint32_t>(y) * 0x9e3779b9u + static_cast<std::uint32_t>(x)),
            maskFor(exposure.samples)) {}

Pixel::Pixel(const Stages& stages, const Light& light, const Exposure& exposure, Place corner,
             std::uint32_t seed, std::uint32_t mask)
    : stages_(stages),
      light_(light),
      exposure_(exposure),
      corner_(corner),
      place_(seed, mask),
      sky_(seed + 1, mask),
      key_(seed + 2, mask) {}

Pixel::Place Pixel::placeOf(std::uint32_t sample) const {
    const auto [dx, dy] = place_(sample);
    return {corner_.x + dx, corner_.y + dy};
}

Colour Pixel::colour(const Camera& camera, PixelLight& met, KeptRay* kept) const {
    Colour sum = Colour::Zero();
    Mean mean;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(exposure_.samples); ++i) {
        const Place place = placeOf(i);
        const Ray ray = camera.rayThrough(place.x, place.y);
        const RayHit hit = stages_.solids.rays().nearest(ray);
        Colour colour = exposure_.background;
        if (hit.isHit) {
            const SeenPoint seen = stages_.solids.seenAt(ray, hit);
            const Lit lit = light_.at(seen, sky_(i), key_(i));
            colour = lit.light * shown(seen, place);
            mean.add(hit, seen, lit.light);
            if (kept != nullptr) kept[i] = {lit.start, lit.sky, hit.along, lit.isSkyOpen, lit.isKeyOpen};
        }
        sum += stages_.ghosts.isEmpty() ? colour : throughGhosts(ray, place, hit, colour, mean.isPlain);
    }
    met = mean.over(exposure_.samples, camera.focal);
    return sum / static_cast<float>(exposure_.samples);
}

bool Pixel::isChangedBy(const RayScene& added, const Camera& camera, const KeptRay* kept,
                        bool mayHide) const {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(exposure_.samples); ++i) {
        const KeptRay& ray = kept[i];
        if (mayHide) {
            const Place place = placeOf(i);
            const RayHit hit = added.nearest(camera.rayThrough(place.x, place.y));
            if (hit.isHit && hit.along <= ray.along) return true;
        }
        if (ray.isSkyOpen && added.isBlocked({ray.start, ray.sky}, light_.reach())) return true;
        if (ray.isKeyOpen && added.isBlocked({ray.start, light_.towardsKey(key_(i))}, kKeyReach)) return true;
    }
    return false;
}

/// Hatching is drawn in the picture, not on the surface: its lines are equally far apart on every face.
Colour Pixel::shown(const SeenPoint& seen, const Place& place) const {
    if (!seen.isHatched) return seen.colour;
    const float across = (place.x + place.y) * static_cast<float>(M_SQRT1_2) / exposure_.hatching;
    return across - std::floor(across) < kHatchShare ? kHatch : seen.colour;
}

Colour Pixel::throughGhosts(const Ray& ray, const Place& place, const RayHit& end, Colour behind,
                            bool& isPlain) const {
    const float most = end.isHit ? end.along - kGhostGap : std::numeric_limits<float>::infinity();
    const GhostWalls walls = ghostsAlong(stages_.ghosts, ray, most);
    isPlain &= walls.count == 0;
    // A blue ghost over orange would read as the red of the scale, so it only pales.
    const bool isVeil = stages_.solids.isOnScale(end);
    for (int i = walls.count - 1; i >= 0; --i) {
        const SeenPoint seen = stages_.ghosts.seenAt(ray, walls.hits[i]);
        const Colour ghost =
            light_.unshaded(seen) * (isVeil && !seen.isHatched ? Colour(Colour::Ones()) : shown(seen, place));
        behind += (isVeil ? exposure_.veilShare : exposure_.ghostShare) * (ghost - behind);
    }
    return behind;
}

}  // namespace clearway::render
