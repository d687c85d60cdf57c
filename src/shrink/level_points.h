// Points at which a part has one depth: where edges cross that surface, and where its creases lie between them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "shrink/surface_depth.h"

namespace clearway {

/// A point at about the level, and the plane through the level near it.
struct LevelPoint {
    Vector3 point;
    Vector3 inward;          ///< of length 1, the way in which depths grow; 0 if there is none
    Vector3 onLevel;         ///< moved along it to the level
    std::uint32_t triangle;  ///< the nearest one of the surface
};

class LevelPoints {
  public:
    /// fineness: how far a point's depth may be from the level.
    LevelPoints(const SurfaceDepth& surface, double level, double fineness)
        : surface_(surface), level_(level), fineness_(fineness) {}

    /// A vertex and its place.
    struct End {
        const Vector3& point;
        const SurfaceDepth::Place& place;
    };

    /// The point between an outer end, above the level, and an inner one that is not. It keeps a small distance from
    /// both, so that points on different edges differ.
    LevelPoint crossing(const End& outer, const End& inner, Workspace& workspace) const;

    /// The point of a triangle at which the level's planes at two of its edges meet, if it lies within.
    std::optional<Vector3> crease(const LevelPoint& a, const LevelPoint& b, const Corners3& triangle) const;

    /// The point of a tetrahedron that is nearest to the level's planes, or else the mean of the points.
    Vector3 amid(const std::vector<LevelPoint>& outline, const std::array<Vector3, 4>& tetrahedron) const;

  private:
    Vector3 inwardAt(const Vector3& point, const SurfaceDepth::Place& place) const;

    const SurfaceDepth& surface_;
    double level_, fineness_;
};

}  // namespace clearway
