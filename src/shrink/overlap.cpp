#include "clearway/overlap.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "mesh/components.h"
#include "model/solids.h"
#include "shrink/nearest_triangle.h"

namespace clearway {
namespace {

constexpr double kShare = 0.01;       ///< how much of the depth may stay open
constexpr double kLeastDepth = 1e-4;  ///< of the part's diagonal: how much may stay open in any case

/// A piece of a triangle, in the part's frame.
struct TrianglePiece {
    Corners3 corners;
    std::uint32_t triangle;
    double most;  ///< no point of it lies deeper

    bool operator<(const TrianglePiece& other) const { return most < other.most; }
};

/// The fastest tree of few triangles: one leaf.
Model smallModel(const Mesh& mesh) {
    BuildOptions options;
    options.generalSplit = "mean";
    options.fit = "covariance";
    options.leafSplit = "none";
    options.leafSize = kLargestLeafSize;
    options.threads = 1;
    return Model::build(mesh, options);
}

class DeepestSearch {
  public:
    DeepestSearch(const Mesh& part, const Model& surface, const std::vector<Solid>& solids,
                  const Pose& X_partEnvironment, double leastDepth)
        : part_(part),
          solids_(solids),
          nearest_(surface),
          X_partEnvironment_(X_partEnvironment),
          leastDepth_(std::max(leastDepth, kLeastDepth * surface.box().diagonal().norm())) {}

    void add(const Corners3& obstacle, std::uint32_t triangle) {
        Corners3 corners;
        Box box;
        for (int k = 0; k < 3; ++k) {
            corners[k] = X_partEnvironment_ * obstacle[k];
            box.extend(corners[k]);
        }
        if (box.intersects(nearest_.model().box())) lookAt(corners, triangle);
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
        const NearestTriangle::Place place = nearest_.of(middle);
        const double depth = isInside(middle) ? place.distance : -place.distance;
        if (depth > best_.lower) {
            best_.lower = depth;
            best_.point = middle;
            best_.obstacleTriangle = triangle;
        }
        const double most = std::min(depth + radius, furthestFrom(place.triangle, corners));
        if (most <= best_.lower) return;
        if (most <= enough()) {
            mostLeft_ = std::max(mostLeft_, most);
        } else if (depth < 0.5 * enough() && isShallow(corners, middle, radius, place.triangle)) {
            if (depth >= 0 || !isApart(corners)) mostLeft_ = std::max(mostLeft_, enough());
        } else {
            open_.push({corners, triangle, most});
        }
    }

    /// Whether no point of the piece lies deeper than enough(). Around a deeper one, all is inside for at least so far. The piece is moved
    /// outwards and scaled, which moves no point so far. If its middle is outside then, and it meets no surface, all of it is outside. This
    /// spares faces that only touch the part from being halved along their borders and its edges.
    bool isShallow(Corners3 corners, const Vector3& middle, double radius, std::uint32_t nearest) {
        const double step = 0.5 * enough();
        const auto& [a, b, c] = part_.triangles[nearest];
        const Vector3 &tip = part_.vertices[a],
                      normal = (part_.vertices[b] - tip).cross(part_.vertices[c] - tip);
        const double length = normal.norm();
        Vector3 to = middle;
        if (length > 0 && std::isfinite(length)) {
            to += step / length * normal;
            if (isInside(to)) to = middle - step / length * normal;
        }
        if (isInside(to)) return false;
        const double share = 1 - step / std::max(step, radius);
        for (Vector3& corner : corners) corner = to + share * (corner - middle);
        return isApart(corners);
    }

    /// No point of the piece lies deeper than this: the distance to one triangle of the surface is convex.
    double furthestFrom(std::uint32_t triangle, const Corners3& corners) const {
        const auto& [a, b, c] = part_.triangles[triangle];
        const Corners3 face = {part_.vertices[a], part_.vertices[b], part_.vertices[c]};
        double most = 0;
        for (const Vector3& corner : corners) most = std::max(most, distanceToTriangle(corner, face));
        return most;
    }

    bool isInside(const Vector3& point) const {
        return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
            return solid.box().contains(point) && solid.winding({}, {}, point) > 0;
        });
    }

    /// Whether the piece has no point of the part's surface; if its middle is outside, then so is all of it.
    bool isApart(const Corners3& corners) {
        Mesh piece;
        piece.vertices.assign(corners.begin(), corners.end());
        piece.triangles = {{0, 1, 2}};
        return !collides(smallModel(piece), nearest_.model(), {}, workspace_);
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

    const Mesh& part_;
    const std::vector<Solid>& solids_;
    NearestTriangle nearest_;
    const Pose& X_partEnvironment_;
    const double leastDepth_;
    std::priority_queue<TrianglePiece> open_;
    DeepestPoint best_;
    double mostLeft_ = 0;  ///< no piece that was left open lies deeper
    Workspace workspace_;
};

}  // namespace

struct OverlapMeter::Surface {
    Mesh mesh;
    Model model;
    std::vector<Solid> solids;  ///< of the components
};

OverlapMeter::OverlapMeter(const Mesh& part) {
    auto surface = std::make_shared<Surface>(Surface{part, Model::build(part), {}});
    const std::vector<Component> components = componentsOf(part);
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (components[i].triangleCount == 0) continue;
        surface->solids.emplace_back(meshOfComponents(part, {i}),
                                     components[i].name.empty() ? "unnamed" : components[i].name);
    }
    surface_ = surface;
}

DeepestPoint OverlapMeter::deepest(const Mesh& obstacle, const Pose& X_environmentPart,
                                   double leastDepth) const {
    requirePose(X_environmentPart);
    const Pose X_partEnvironment = inverse(X_environmentPart);
    DeepestSearch search(surface_->mesh, surface_->model, surface_->solids, X_partEnvironment, leastDepth);
    for (std::uint32_t t = 0; t < obstacle.triangles.size(); ++t) {
        const auto& [a, b, c] = obstacle.triangles[t];
        search.add({obstacle.vertices[a], obstacle.vertices[b], obstacle.vertices[c]}, t);
    }
    return search.find(X_environmentPart);
}

}  // namespace clearway
