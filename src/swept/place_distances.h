// How far points and triangles are from all places that a part takes on its way.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"
#include "clearway/sweep.h"
#include "model/solids.h"

namespace clearway {

using SurfaceTriangle = std::array<Vector3, 3>;

/// Bounds of a point's distance to the nearest place of the part's surface, and where that is.
struct PlaceDistance {
    double lower, upper;
    std::size_t motion = 0;  ///< of the place that gives `upper`
    double time = 0;
    std::int64_t partTriangle = -1;
};

/// Answers may be asked for by several threads, each with a workspace of its own.
class PlaceDistances {
  public:
    /// tolerance: distances are known to a 32nd of it, or to a tenth of themselves if that is more.
    PlaceDistances(const Mesh& part, const std::vector<RigidMotion>& motions, double tolerance,
                   double poseError);

    const Box& box() const { return box_; }  ///< holds all places

    /// first: the number of the motion that is asked first, and then of the nearest one.
    PlaceDistance at(const Vector3& point, std::size_t& first, Workspace& workspace) const;

    /// Whether the point, which the part's surface never touches, is in the part's material along some motion. It is
    /// there at all poses of a motion or at none.
    bool isInMaterial(const Vector3& point) const;

    /// Whether the part's surface stays further from the triangle than this, at all poses. False if that is too close
    /// to tell.
    bool areApart(const SurfaceTriangle& triangle, double distance, Workspace& workspace) const;

    /// Whether all points of the triangle are certain to be within this distance of one place of the part. The distance
    /// to one triangle at one pose is largest at a corner, because a triangle is convex.
    bool isWithinOfOnePlace(const SurfaceTriangle& triangle, double distance, const PlaceDistance& place,
                            Workspace& workspace) const;

    /// Whether a chosen point of one of the part's connected pieces is within the ball where a motion begins. Each piece
    /// has one such point.
    bool holdsPiece(const Vector3& centre, double radius, Workspace& workspace) const;

  private:
    /// The part's way along one motion, and a ball that holds it.
    struct Motion {
        RigidMotion motion;
        MotionPieces pieces;
        Vector3 centre;
        double radius;
    };

    LeastDistance along(RigidMotion motion, const Vector3& point, double cap, Workspace& workspace) const;

    Model part_, point_, pieces_;
    std::vector<SurfaceTriangle> partTriangles_;
    std::shared_ptr<const Solids> solids_;
    Solids pointPiece_;  ///< a point at the origin
    double tolerance_, poseError_;
    std::vector<Motion> motions_;
    Box box_;
};

}  // namespace clearway
