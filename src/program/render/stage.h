// What stands before the camera: surfaces, each in one place or several, with their colours.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/colour.h"
#include "program/render/rays.h"

namespace clearway::render {

struct Body {
    std::size_t shape = 0;  ///< of those of its stage
    Placement placement;
    std::vector<Colour> colours;  ///< of each component of the shape, the last one for all that follow
    bool hasSeams = true;         ///< whether lines are drawn where two of its components meet
    bool isOnScale = false;       ///< its colours are places on a scale, that no other colour may tint
};

/// A point that a ray met.
struct SeenPoint {
    Vector3f point;
    Vector3f normal;  ///< smoothed, towards where the ray came from, unit length
    Vector3f facet;   ///< the triangle's own, likewise
    Colour colour;
};

class Stage {
  public:
    std::size_t addShape(Surface surface);
    void addBody(Body body);
    void finish() { rays_.finish(); }  ///< before any ray is shot

    bool isEmpty() const { return bodies_.empty(); }
    const RayScene& rays() const { return rays_; }
    SeenPoint seenAt(const Ray& ray, const RayHit& hit) const;
    /// Of the triangle that was met, in whichever direction its corners give it; unit length.
    Vector3f facetOf(const RayHit& hit) const;
    bool isOnScale(const RayHit& hit) const { return hit.isHit && bodies_[hit.body].isOnScale; }
    /// 0 for nothing; the same for all components of a body without seams.
    std::uint32_t seamKey(const RayHit& hit) const;

  private:
    std::uint32_t componentOf(const RayHit& hit) const;
    const Surface& shapeOf(const Body& body) const { return shapes_[body.shape]; }

    RayScene rays_;
    std::deque<Surface> shapes_;
    std::vector<Body> bodies_;
};

/// A ghost closer before a solid than this, in coordinates of the stage, is not seen: copies of one part
/// often lie in each other, where rounding would choose between them.
constexpr float kGhostGap = 1e-3f;

/// Ghosts are seen through, and neither shade nor hide anything.
struct Stages {
    Stage solids, ghosts;
};

}  // namespace clearway::render
