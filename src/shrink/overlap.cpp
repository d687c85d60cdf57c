#include "clearway/overlap.h"

#include <algorithm>
#include <queue>

#include "shrink/surface_depth.h"

namespace clearway {
namespace {

constexpr double kShare = 0.01;       ///< how much of the depth may stay open
constexpr double kLeastDepth = 1e-4;  ///< of the part's diagonal: how much may stay open in any case

constexpr double kMeterTolerance = 16e-4;  ///< of the part's diagonal

/// A piece of a triangle, in the part's frame.
struct TrianglePiece {
    Corners3 corners;
    std::uint32_t triangle;
    double most;  ///< no point of it lies deeper

    bool operator<(const TrianglePiece& other) const { return most < other.most; }
};

class DeepestSearch {
  public:
    DeepestSearch(const SurfaceDepth& surface, const Pose& X_partEnvironment, double leastDepth)
        : surface_(surface),
          X_partEnvironment_(X_partEnvironment),
          leastDepth_(std::max(leastDepth, kLeastDepth * surface.model().box().diagonal().norm())) {}

    void add(const Corners3& obstacle, std::uint32_t triangle) {
        Corners3 corners;
        Box box;
        for (int k = 0; k < 3; ++k) {
            corners[k] = X_partEnvironment_ * obstacle[k];
            box.extend(corners[k]);
        }
        if (box.intersects(surface_.model().box())) lookAt(corners, triangle);
    }

    DeepestPoint find(const Pose& X_environmentPart) {
        while (!open_.empty()) {
            const TrianglePiece piece = open_.top();
            if (piece.most <= enough()) {
                mostLeft_ = std::max(mostLeft_, piece.most);
                break;
            }
            open_.pop();
            halve(piece);
        }
        best_.upper = std::max(best_.lower, mostLeft_);
        if (best_.obstacleTriangle < 0) return best_;
        best_.point = X_environmentPart * best_.point;
        return best_;
    }

  private:
    double enough() const { return std::max((1 + kShare) * best_.lower, best_.lower + leastDepth_); }

    void lookAt(const Corners3& corners, std::uint32_t triangle) {
        const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        double radius = 0;
        for (const Vector3& corner : corners) radius = std::max(radius, (corner - middle).norm());
        const SurfaceDepth::Place place = surface_.at(middle, workspace_);
        const double depth = place.depth;
        if (depth > best_.lower) {
            best_.lower = depth;
            best_.point = middle;
            best_.obstacleTriangle = triangle;
        }
        const double most = std::min(depth + radius, furthestFrom(place.triangle, corners));
        if (most <= best_.lower || (depth < 0 && isApart(corners))) return;
        if (most <= enough()) {
            mostLeft_ = std::max(mostLeft_, most);
            return;
        }
        open_.push({corners, triangle, most});
    }

    /// No point of the piece lies deeper than this: the distance to one triangle of the surface is convex.
    double furthestFrom(std::uint32_t triangle, const Corners3& corners) const {
        const Corners3 face = surface_.corners(triangle);
        double most = 0;
        for (const Vector3& corner : corners) most = std::max(most, distanceToTriangle(corner, face));
        return most;
    }

    /// Whether the piece has no point of the part's surface; if its middle is outside, then so is all of it.
    bool isApart(const Corners3& corners) {
        Mesh piece;
        piece.vertices.assign(corners.begin(), corners.end());
        piece.triangles = {{0, 1, 2}};
        return !collides(smallModel(piece), surface_.model(), {}, workspace_);
    }

    void halve(const TrianglePiece& piece) {
        const Corners3& c = piece.corners;
        int longest = 0;
        double most = -1;
        for (int k = 0; k < 3; ++k) {
            const double length = (c[(k + 1) % 3] - c[k]).squaredNorm();
            if (length <= most) continue;
            most = length;
            longest = k;
        }
        const Vector3 &a = c[longest], &b = c[(longest + 1) % 3], &tip = c[(longest + 2) % 3];
        const Vector3 middle = 0.5 * (a + b);
        lookAt({a, middle, tip}, piece.triangle);
        lookAt({middle, b, tip}, piece.triangle);
    }

    const SurfaceDepth& surface_;
    const Pose& X_partEnvironment_;
    const double leastDepth_;
    std::priority_queue<TrianglePiece> open_;
    DeepestPoint best_;
    double mostLeft_ = 0;  ///< no piece that was left open lies deeper
    Workspace workspace_;
};

}  // namespace

OverlapMeter::OverlapMeter(const Mesh& part)
    : OverlapMeter(part, kMeterTolerance * boundingBox(part).diagonal().norm()) {}

OverlapMeter::OverlapMeter(const Mesh& part, double tolerance)
    : surface_(std::make_shared<const SurfaceDepth>(part, kJoinFineness * tolerance)) {}

DeepestPoint OverlapMeter::deepest(const Mesh& obstacle, const Pose& X_environmentPart,
                                   double leastDepth) const {
    requirePose(X_environmentPart);
    const Pose X_partEnvironment = inverse(X_environmentPart);
    DeepestSearch search(*surface_, X_partEnvironment, leastDepth);
    for (std::uint32_t t = 0; t < obstacle.triangles.size(); ++t) {
        const auto& [a, b, c] = obstacle.triangles[t];
        search.add({obstacle.vertices[a], obstacle.vertices[b], obstacle.vertices[c]}, t);
    }
    return search.find(X_environmentPart);
}

}  // namespace clearway
