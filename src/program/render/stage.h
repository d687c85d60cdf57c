// The scene in front of the camera: surfaces, each at one or more places, with their colours.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "program/render/colour.h"
#include "program/render/rays.h"

namespace clearway::render {

/// The colour of a body's outline; it tells the start and the goal from other poses.
enum class Pen : std::uint8_t { kPlain, kStart, kGoal };

struct Body {
    std::size_t shape = 0;  ///< number of the shape in its stage
    Placement placement;
    std::vector<Colour>
        colours;  ///< one for each component of the shape; the last one serves all further components
    bool hasSeams = true;    ///< lines are drawn where two components meet
    bool isOnScale = false;  ///< its colours show clearances, which no other colour may tint
    bool isHatched = false;  ///< black lines are drawn across it
    Pen pen = Pen::kPlain;
};

/// The point at which a ray met a body.
struct SeenPoint {
    Vector3f point;
    Vector3f normal;  ///< smoothed normal on the side of the camera, unit length
    Vector3f facet;   ///< normal of the triangle on the side of the camera, unit length
    Colour colour;
    bool isHatched = false;
};

class Stage {
  public:
    std::size_t addShape(Surface surface);
    void addBody(Body body);
    /// Replaces a body by one of the same shape: at another place, in other colours.
    void changeBody(std::size_t body, Body changed);
    void showBody(std::size_t body, bool isShown) { rays_.showBody(body, isShown); }
    void finish() { rays_.finish(); }  ///< to be called after all changes and before any ray is traced

    bool isEmpty() const { return bodies_.empty(); }
    std::size_t bodyCount() const { return bodies_.size(); }
    Pen penOf(const RayHit& hit) const { return bodies_[hit.body].pen; }
    const RayScene& rays() const { return rays_; }
    SeenPoint seenAt(const Ray& ray, const RayHit& hit) const;
    /// Normal of the triangle, on the side that the order of its corners gives; unit length.
    Vector3f facetOf(const RayHit& hit) const;
    bool isOnScale(const RayHit& hit) const { return hit.isHit && bodies_[hit.body].isOnScale; }
    /// Lines are drawn between different keys: 0 for the background, one key for a body without seams.
    std::uint32_t seamKey(const RayHit& hit) const;

  private:
    std::uint32_t componentOf(const RayHit& hit) const;
    const Surface& shapeOf(const Body& body) const { return shapes_[body.shape]; }

    RayScene rays_;
    std::deque<Surface> shapes_;
    std::vector<Body> bodies_;
};

/// A ghost this close in front of a solid, in coordinates of the stage, is not drawn: poses of one part often
/// overlap, and rounding would choose between them.
constexpr float kGhostGap = 1e-3f;

/// The nearest wall of each ghost that a ray meets; the inside of a ghost plays no part.
struct GhostWalls {
    static constexpr int kMost = 4;  ///< ghosts seen one behind another
    std::array<RayHit, kMost> hits;  ///< the nearest first
    int count = 0;

    const RayHit* begin() const { return hits.data(); }
    const RayHit* end() const { return hits.data() + count; }
    bool hold(std::uint32_t ghost) const {
        return std::any_of(begin(), end(), [&](const RayHit& hit) { return hit.body == ghost; });
    }
};

/// most: walls farther along the ray do not count.
GhostWalls ghostsAlong(const Stage& ghosts, Ray ray, float most);

/// Ghosts are translucent; they neither shade nor hide anything.
struct Stages {
    Stage solids, ghosts;
};

}  // namespace clearway::render
