// Shoots 2 x 2 rays through every pixel and draws lines between neighbouring rays that meet different things.
#include "program/render/outlines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace clearway::render {

namespace {

constexpr int kPerPixel = 2;            ///< rays along one side of a pixel
constexpr float kCreaseCosine = 0.80f;  ///< faces that meet at a smaller cosine have a line between them
constexpr float kGapShare = 0.012f;  ///< share of the depth: a larger jump, on a face seen head on, is a line
/// Darkness of each kind of line.
constexpr float kSilhouette = 0.85f, kGap = 0.6f, kSeam = 0.4f, kCrease = 0.3f, kGhost = 0.45f;
const Colour kInk = sRgb(24, 26, 32);
constexpr std::uint32_t kNothing = 0xffffffffu;

struct Look {
    std::uint32_t body = kNothing, seam = 0;
    std::uint32_t ghost = kNothing;  ///< nearest ghost in front of the body
    float depth = 0;
    Vector3f facet = Vector3f::Zero();
    float slope = 0;  ///< cosine of the angle between facet and ray
};

/// Values at a band of rows of a fine grid over the picture.
template <class Value>
struct Grid {
    int width, top, bottom;  ///< rows [top, bottom)
    std::vector<Value> values;

    Grid(int w, int from, int to)
        : width(w), top(from), bottom(to), values(std::size_t(w) * std::size_t(to - from)) {}
    std::size_t indexOf(int x, int y) const {
        return std::size_t(y - top) * std::size_t(width) + std::size_t(x);
    }
    const Value& at(int x, int y) const { return values[indexOf(x, y)]; }
    template <class Function>
    void fill(const Function& valueAt) {
        tbb::parallel_for(top, bottom, [&](int y) {
            for (int x = 0; x < width; ++x) values[indexOf(x, y)] = valueAt(x, y);
        });
    }
};

Look lookAlong(const Stages& stages, const Ray& ray) {
    Look look;
    const RayHit hit = stages.solids.rays().nearest(ray);
    if (hit.isHit) {
        const Vector3f facet = stages.solids.facetOf(hit);
        look = {hit.body, stages.solids.seamKey(hit),        kNothing, hit.along,
                facet,    std::abs(facet.dot(ray.direction))};
    }
    if (stages.ghosts.isEmpty()) return look;
    const RayHit ghost = stages.ghosts.rays().nearest(ray);
    if (ghost.isHit && (!hit.isHit || ghost.along < hit.along - kGhostGap)) look.ghost = ghost.body;
    return look;
}

/// Darkness of the line between two neighbours; 0: no line.
float lineBetween(const Look& a, const Look& b) {
    if (a.body != b.body) return kSilhouette;
    const float ghostLine = a.ghost != b.ghost ? kGhost : 0;
    if (a.body == kNothing) return ghostLine;
    const float nearer = std::min(a.depth, b.depth);
    const float slope = std::max(0.08f, std::min(a.slope, b.slope));
    if (std::abs(a.depth - b.depth) > kGapShare * nearer / slope) return kGap;
    if (a.seam != b.seam) return std::max(ghostLine, kSeam);
    return std::max(ghostLine, std::abs(a.facet.dot(b.facet)) < kCreaseCosine ? kCrease : 0);
}

/// The darker of the lines to the right of and below each place.
Grid<float> linesOf(const Grid<Look>& looks) {
    Grid<float> lines(looks.width, looks.top, looks.bottom);
    lines.fill([&](int x, int y) {
        float line = 0;
        if (x + 1 < looks.width) line = lineBetween(looks.at(x, y), looks.at(x + 1, y));
        if (y + 1 < looks.bottom) line = std::max(line, lineBetween(looks.at(x, y), looks.at(x, y + 1)));
        return line;
    });
    return lines;
}

/// How far from a pixel, in places of the grid, a line of this width in pixels can lie and still touch the
/// pixel.
int reachOf(float width) {
    return static_cast<int>(std::ceil(0.5f * width * kPerPixel + 1));
}

/// Darkness of a pixel: that of the lines within half a line width of its middle, with soft borders.
float inkAt(const Grid<float>& lines, int x, int y, float width) {
    const float half = 0.5f * width * kPerPixel;
    const int reach = reachOf(width);
    const int left = std::max(0, kPerPixel * x - reach), top = std::max(lines.top, kPerPixel * y - reach);
    const int right = std::min(lines.width, kPerPixel * (x + 1) + reach);
    const int bottom = std::min(lines.bottom, kPerPixel * (y + 1) + reach);
    const float middleX = (static_cast<float>(x) + 0.5f) * kPerPixel,
                middleY = (static_cast<float>(y) + 0.5f) * kPerPixel;
    float most = 0;
    for (int j = top; j < bottom; ++j) {
        for (int i = left; i < right; ++i) {
            const float line = lines.at(i, j);
            if (line <= most) continue;
            const float distance =
                std::hypot(static_cast<float>(i) + 1 - middleX, static_cast<float>(j) + 1 - middleY);
            most = std::max(most, line * std::clamp(half + 0.5f - 0.6f * distance, 0.0f, 1.0f));
        }
    }
    return most;
}

/// Draws the lines in the rows [top, bottom) of pixels.
void drawBand(const Stages& stages, const Camera& camera, float width, int top, int bottom, Image& image) {
    const int beside = reachOf(width) + 1;  // a line lies between two rows
    Grid<Look> looks(kPerPixel * image.width, std::max(0, kPerPixel * top - beside),
                     std::min(kPerPixel * image.height, kPerPixel * bottom + beside));
    looks.fill([&](int x, int y) {
        return lookAlong(stages, camera.rayThrough((static_cast<float>(x) + 0.5f) / kPerPixel,
                                                   (static_cast<float>(y) + 0.5f) / kPerPixel));
    });
    const Grid<float> lines = linesOf(looks);
    tbb::parallel_for(top, bottom, [&](int y) {
        for (int x = 0; x < image.width; ++x) {
            const float ink = inkAt(lines, x, y, width);
            image.at(x, y) = (1 - ink) * image.at(x, y) + ink * kInk;
        }
    });
}

}  // namespace

void drawOutlines(const Stages& stages, const Camera& camera, float width, Image& image) {
    const int rows = std::max(64, 8 * reachOf(width));  // a grid over the whole picture would take gigabytes
    for (int top = 0; top < image.height; top += rows)
        drawBand(stages, camera, width, top, std::min(top + rows, image.height), image);
}

}  // namespace clearway::render
