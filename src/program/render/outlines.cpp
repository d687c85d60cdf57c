// Shoots 2 x 2 rays through every pixel and draws lines between neighbouring rays that meet different things.
#include "program/render/outlines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway::render {

namespace {

constexpr int kPerPixel = 2;            ///< rays along one side of a pixel
constexpr float kCreaseCosine = 0.80f;  ///< faces that meet at a smaller cosine have a line between them
constexpr float kGapShare = 0.012f;  ///< share of the depth: a larger jump, on a face seen head on, is a line
/// Darkness of each kind of line.
constexpr float kSilhouette = 0.85f, kGap = 0.7f, kSeam = 0.5f, kCrease = 0.6f, kGhost = 0.45f,
                kColoured = 0.95f;
constexpr float kColouredWidth = 2;  ///< width of coloured outlines, in widths of a line
constexpr int kBeside = 3;  ///< places; a ghost's outline this close beside that of the part is left out
const Colour kPens[] = {sRgb(24, 26, 32), sRgb(0, 150, 230), sRgb(0, 125, 50)};
constexpr std::uint32_t kNothing = 0xffffffffu;

struct Look {
    std::uint32_t body = kNothing, seam = 0;
    float depth = 0;
    Vector3f facet = Vector3f::Zero();
    float slope = 0;  ///< cosine of the angle between facet and ray
    Pen pen = Pen::kPlain;
    bool isPart = false;
    GhostWalls ghosts;  ///< in front of the body and behind it
};

/// Values at the places of an area of a fine grid over the picture.
template <class Value>
struct Grid {
    PixelArea area;
    std::vector<Value> values;

    explicit Grid(const PixelArea& places)
        : area(places), values(std::size_t(places.width()) * std::size_t(places.bottom - places.top)) {}
    std::size_t indexOf(int x, int y) const {
        return std::size_t(y - area.top) * std::size_t(area.width()) + std::size_t(x - area.left);
    }
    const Value& at(int x, int y) const { return values[indexOf(x, y)]; }
    template <class Function>
    void fill(const Function& valueAt) {
        tbb::parallel_for(area.top, area.bottom, [&](int y) {
            for (int x = area.left; x < area.right; ++x) values[indexOf(x, y)] = valueAt(x, y);
        });
    }
};

Look lookAlong(const Stages& stages, const Ray& ray) {
    Look look;
    const RayHit hit = stages.solids.rays().nearest(ray);
    if (hit.isHit) {
        look.body = hit.body;
        look.seam = stages.solids.seamKey(hit);
        look.depth = hit.along;
        look.facet = stages.solids.facetOf(hit);
        look.slope = std::abs(look.facet.dot(ray.direction));
        look.pen = stages.solids.penOf(hit);
        look.isPart = stages.solids.isOnScale(hit);
    }
    if (!stages.ghosts.isEmpty())
        look.ghosts = ghostsAlong(stages.ghosts, ray, std::numeric_limits<float>::infinity());
    return look;
}

/// The outline of the nearer of two different bodies, in its pen.
Ink outlineOf(Pen pen, float plain) {
    return {pen == Pen::kPlain ? plain : kColoured, pen};
}

/// The largest difference of the depths at two neighbouring places of one surface.
float mostStep(float depth, float slope) {
    return kGapShare * depth / std::max(0.08f, slope);
}

/// A place and the direction to its neighbour.
struct Step {
    int x, y, dx, dy;

    Step back() const { return {x + dx, y + dy, -dx, -dy}; }
};

/// Whether the part ends at the place or close before it, at this depth. So does the ghost of a pose close to the
/// part's, whose outline in another colour would show as stripes along that of the part.
bool isBesidePart(const Grid<Look>& looks, const Step& step, float along) {
    const std::uint32_t body = looks.at(step.x + step.dx, step.y + step.dy).body;
    for (int i = 0; i <= kBeside; ++i) {
        const int x = step.x - i * step.dx, y = step.y - i * step.dy;
        if (!looks.area.holds(x, y)) return false;
        const Look& look = looks.at(x, y);
        if (look.isPart && look.body != body && std::abs(look.depth - along) < mostStep(along, look.slope))
            return true;
    }
    return false;
}

/// The outline of the nearest ghost that the place sees and that ends before its neighbour. What lies in front
/// of it there, another ghost or a body, does not end it.
Ink ghostLine(const Stage& ghosts, const Grid<Look>& looks, const Step& step) {
    const Look &a = looks.at(step.x, step.y), &b = looks.at(step.x + step.dx, step.y + step.dy);
    for (const RayHit& ghost : a.ghosts) {
        const bool isCovered = a.body != kNothing && ghost.along > a.depth - kGhostGap;
        if (!isCovered && !b.ghosts.hold(ghost.body) && !isBesidePart(looks, step, ghost.along))
            return outlineOf(ghosts.penOf(ghost), kGhost);
    }
    return {};
}

/// The pen of the nearer body; where both touch, that of the start or the goal, so that its outline is whole.
Pen penBetween(const Look& a, const Look& b) {
    if (a.body == kNothing) return b.pen;
    if (b.body == kNothing) return a.pen;
    const float nearer = std::min(a.depth, b.depth);
    if (std::abs(a.depth - b.depth) < mostStep(nearer, std::min(a.slope, b.slope)))
        return std::max(a.pen, b.pen);
    return a.depth < b.depth ? a.pen : b.pen;
}

/// The line between a place and its neighbour; share 0: no line.
Ink lineAt(const Stages& stages, const Grid<Look>& looks, const Step& step) {
    const Look &a = looks.at(step.x, step.y), &b = looks.at(step.x + step.dx, step.y + step.dy);
    Ink line;
    const auto add = [&](const Ink& other) {
        if (other.share > line.share) line = other;
    };
    add(ghostLine(stages.ghosts, looks, step));
    add(ghostLine(stages.ghosts, looks, step.back()));
    if (a.body != b.body) {
        add(outlineOf(penBetween(a, b), kSilhouette));
        return line;
    }
    if (a.body == kNothing) return line;
    if (std::abs(a.depth - b.depth) > mostStep(std::min(a.depth, b.depth), std::min(a.slope, b.slope))) {
        add({kGap, Pen::kPlain});
    } else if (a.seam != b.seam) {
        add({kSeam, Pen::kPlain});
    } else if (std::abs(a.facet.dot(b.facet)) < kCreaseCosine) {
        add({kCrease, Pen::kPlain});
    }
    return line;
}

/// The darker of the lines to the right of and below each place.
Grid<Ink> linesOf(const Stages& stages, const Grid<Look>& looks) {
    Grid<Ink> lines(looks.area);
    lines.fill([&](int x, int y) {
        Ink line;
        if (x + 1 < looks.area.right) line = lineAt(stages, looks, {x, y, 1, 0});
        if (y + 1 < looks.area.bottom) {
            const Ink below = lineAt(stages, looks, {x, y, 0, 1});
            if (below.share > line.share) line = below;
        }
        return line;
    });
    return lines;
}

/// How far from a pixel, in places of the grid, a line of this width in pixels can lie and still touch the
/// pixel.
int placeReach(float width) {
    return static_cast<int>(std::ceil(0.5f * kColouredWidth * width * kPerPixel + 1));
}

/// Ink of a pixel: that of the lines within half a line width of its middle, with soft borders.
Ink inkAt(const Grid<Ink>& lines, int x, int y, float width) {
    const float plainHalf = 0.5f * width * kPerPixel;
    const PixelArea near = PixelArea{kPerPixel * x, kPerPixel * y, kPerPixel * (x + 1), kPerPixel * (y + 1)}
                               .grownBy(placeReach(width))
                               .within(lines.area);
    const float middleX = (static_cast<float>(x) + 0.5f) * kPerPixel,
                middleY = (static_cast<float>(y) + 0.5f) * kPerPixel;
    Ink most;
    for (int j = near.top; j < near.bottom; ++j) {
        for (int i = near.left; i < near.right; ++i) {
            const Ink& line = lines.at(i, j);
            if (line.share <= most.share) continue;
            const float half = line.pen == Pen::kPlain ? plainHalf : kColouredWidth * plainHalf;
            const float distance =
                std::hypot(static_cast<float>(i) + 1 - middleX, static_cast<float>(j) + 1 - middleY);
            const float share = line.share * std::clamp(half + 0.5f - 0.6f * distance, 0.0f, 1.0f);
            if (share > most.share) most = {share, line.pen};
        }
    }
    return most;
}

}  // namespace

Colour penColour(Pen pen) {
    return kPens[static_cast<std::size_t>(pen)];
}

PixelArea PixelArea::within(const PixelArea& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

int outlineReach(float width) {
    return (placeReach(width) + kBeside) / kPerPixel + 1;
}

std::vector<Ink> outlineInk(const Stages& stages, const Camera& camera, const OutlineOptions& options,
                            const PixelArea& area) {
    const auto places = [](const PixelArea& pixels) {
        return PixelArea{kPerPixel * pixels.left, kPerPixel * pixels.top, kPerPixel * pixels.right,
                         kPerPixel * pixels.bottom};
    };
    const int beside = placeReach(options.width) + kBeside + 1;  // a line lies between two rows
    Grid<Look> looks(places(area).grownBy(beside).within(places(options.picture)));
    looks.fill([&](int x, int y) {
        return lookAlong(stages, camera.rayThrough((static_cast<float>(x) + 0.5f) / kPerPixel,
                                                   (static_cast<float>(y) + 0.5f) / kPerPixel));
    });
    const Grid<Ink> lines = linesOf(stages, looks);
    Grid<Ink> ink(area);
    ink.fill([&](int x, int y) { return inkAt(lines, x, y, options.width); });
    return ink.values;
}

void lay(const Ink& ink, Colour& pixel) {
    pixel += ink.share * (penColour(ink.pen) - pixel);
}

void drawOutlines(const Stages& stages, const Camera& camera, float width, Image& image) {
    const int rows =
        std::max(64, 8 * placeReach(width));  // a grid over a whole large picture would take gigabytes
    const PixelArea picture{0, 0, image.width, image.height};
    for (int top = 0; top < image.height; top += rows) {
        const PixelArea band{0, top, image.width, std::min(top + rows, image.height)};
        const std::vector<Ink> ink = outlineInk(stages, camera, {width, picture}, band);
        for (std::size_t i = 0; i < ink.size(); ++i) lay(ink[i], image.pixels[image.indexOf(0, top) + i]);
    }
}

}  // namespace clearway::render
