#include "clearway/overlap.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "clearway/errors.h"
#include "model/box_tree.h"
#include "model/solids.h"
#include "shrink/nearest_triangle.h"

namespace clearway {
namespace {

constexpr double kShare = 0.01;       ///< how much of the depth may stay open
constexpr double kLeastDepth = 1e-4;  ///< of the part's diagonal: how much may stay open in any case

constexpr std::size_t kFewTriangles = 2;  ///< of a group that is looked at triangle by triangle

/// A piece of a triangle in the part's frame, or a group of triangles.
struct OpenPiece {
    Corners3 corners;
    std::uint32_t triangle;
    std::uint32_t nearest;                   ///< the surface's triangle nearest to its middle
    double most;                             ///< no point of it lies deeper
    std::uint32_t first = 0, groupSize = 0;  ///< a group: its place in the order of triangles; 0 for a piece

    bool operator<(const OpenPiece& other) const { return most < other.most; }
};

/// Whether a plane across the axis has one triangle on each side, by more than rounding. axis: of any length.
bool isBetween(const Vector3& axis, const Corners3& a, const Corners3& b) {
    constexpr double kRounding = 1e-14;  ///< of the largest product; three products are added
    double leastA = axis.dot(a[0]), mostA = leastA, leastB = axis.dot(b[0]), mostB = leastB, largest = 0;
    for (int k = 0; k < 3; ++k) {
        leastA = std::min(leastA, axis.dot(a[k]));
        mostA = std::max(mostA, axis.dot(a[k]));
        leastB = std::min(leastB, axis.dot(b[k]));
        mostB = std::max(mostB, axis.dot(b[k]));
        largest = std::max({largest, a[k].cwiseAbs().maxCoeff(), b[k].cwiseAbs().maxCoeff()});
    }
    return std::max(leastA - mostB, leastB - mostA) > kRounding * largest * axis.cwiseAbs().sum();
}

/// Whether a plane is between two triangles. Two convex bodies that are apart have one along a face of one, or along an edge of each.
bool areSurelyApart(const Corners3& a, const Corners3& b) {
    const auto edge = [](const Corners3& corners, int k) -> Vector3 {
        return corners[(k + 1) % 3] - corners[k];
    };
    const Vector3 acrossA = edge(a, 0).cross(edge(a, 1)), acrossB = edge(b, 0).cross(edge(b, 1));
    if (isBetween(acrossA, a, b) || isBetween(acrossB, a, b)) return true;
    for (int i = 0; i < 3; ++i) {
        // Edges within the plane of their triangle part triangles of one plane.
        if (isBetween(edge(a, i).cross(acrossA), a, b) || isBetween(edge(b, i).cross(acrossB), a, b))
            return true;
        for (int k = 0; k < 3; ++k) {
            if (isBetween(edge(a, i).cross(edge(b, k)), a, b)) return true;
        }
    }
    return false;
}

class DeepestSearch {
  public:
    DeepestSearch(const Mesh& part, const Model& surface, const BoxTree& boxes, const Solids& solids,
                  const Pose& X_partEnvironment, double leastDepth)
        : part_(part),
          boxes_(boxes),
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
        if (box.intersects(nearest_.model().box())) added_.push_back({corners, triangle, box});
    }

    DeepestPoint find(const Pose& X_environmentPart) {
        lookAtGroup(0, added_.size(), 0);
        while (!open_.empty()) {
            const OpenPiece piece = open_.top();
            if (piece.most <= enough()) {
                mostLeft_ = std::max(mostLeft_, piece.most);
                break;
            }
            open_.pop();
            if (piece.groupSize > 0)
                divideGroup(piece);
            else
                halve(piece);
        }
        best_.upper = std::max(best_.lower, mostLeft_);
        if (best_.obstacleTriangle < 0) return best_;
        best_.point = X_environmentPart * best_.point;
        return best_;
    }

  private:
    /// A triangle of the obstacle, in the part's frame.
    struct Added {
        Corners3 corners;
        std::uint32_t triangle;
        Box box;
    };

    double enough() const { return std::max((1 + kShare) * best_.lower, best_.lower + leastDepth_); }

    /// Bounds a group by the depth of the middle of its box, so that triangles far from the part's surface are not looked at one by one.
    /// near: a triangle of the surface that may be near.
    void lookAtGroup(std::size_t first, std::size_t count, std::uint32_t near) {
        if (count <= kFewTriangles) {
            for (std::size_t i = first; i < first + count; ++i)
                lookAt(added_[i].corners, added_[i].triangle, near);
            return;
        }
        Box box;
        for (std::size_t i = first; i < first + count; ++i) box.extend(added_[i].box);
        const Vector3 middle = box.center();
        const NearestTriangle::Place place = nearest_.of(middle);
        const double radius = 0.5 * box.diagonal().norm();
        if (place.distance >= radius && !solids_.hold(middle)) return;
        const double most = place.distance + radius;
        if (most <= best_.lower) return;
        open_.push({{},
                    0,
                    place.triangle,
                    most,
                    static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(count)});
    }

    /// Halves a group along the longest side of the box around the middles of its triangles.
    void divideGroup(const OpenPiece& group) {
        const std::size_t first = group.first, count = group.groupSize;
        Box middles;
        for (std::size_t i = first; i < first + count; ++i) middles.extend(added_[i].box.center());
        Eigen::Index axis = 0;
        middles.sizes().maxCoeff(&axis);
        const auto begin = added_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto half = static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(
            begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
            [axis](const Added& a, const Added& b) { return a.box.center()[axis] < b.box.center()[axis]; });
        lookAtGroup(first, count / 2, group.nearest);
        lookAtGroup(first + count / 2, count - count / 2, group.nearest);
    }

    void lookAt(const Corners3& corners, std::uint32_t triangle, std::uint32_t near) {
        if (best_.obstacleTriangle >= 0 && isNear(near, corners)) return;
        const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        double radius = 0;
        for (const Vector3& corner : corners) radius = std::max(radius, (corner - middle).norm());
        const NearestTriangle::Place place = nearest_.of(middle);
        const double depth = solids_.hold(middle) ? place.distance : -place.distance;
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
            open_.push({corners, triangle, place.triangle, most});
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
            if (solids_.hold(to)) to = middle - step / length * normal;
        }
        if (solids_.hold(to)) return false;
        const double share = 1 - step / std::max(step, radius);
        for (Vector3& corner : corners) corner = to + share * (corner - middle);
        return isApart(corners);
    }

    /// Whether the distance to one triangle of the surface shows that no point of the piece lies deep enough to be of interest.
    bool isNear(std::uint32_t near, const Corners3& corners) {
        const double most = furthestFrom(near, corners);
        if (most > std::max(best_.lower, leastDepth_)) return false;
        mostLeft_ = std::max(mostLeft_, most);
        return true;
    }

    /// No point of the piece lies deeper than this: the distance to one triangle of the surface is convex.
    double furthestFrom(std::uint32_t triangle, const Corners3& corners) const {
        const Corners3 face = cornersOf(triangle);
        double most = 0;
        for (const Vector3& corner : corners) most = std::max(most, distanceToTriangle(corner, face));
        return most;
    }

    /// Whether the piece has no point of the part's surface; if its middle is outside, then so is all of it. False, too, where rounding
    /// leaves it open.
    bool isApart(const Corners3& corners) const {
        Box box;
        for (const Vector3& corner : corners) box.extend(corner);
        bool isApart = true;
        boxes_.eachMeeting(box, [&](std::uint32_t triangle) {
            isApart = isApart && areSurelyApart(corners, cornersOf(triangle));
        });
        return isApart;
    }

    Corners3 cornersOf(std::uint32_t triangle) const {
        const auto& [a, b, c] = part_.triangles[triangle];
        return {part_.vertices[a], part_.vertices[b], part_.vertices[c]};
    }

    void halve(const OpenPiece& piece) {
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
        lookAt({a, middle, tip}, piece.triangle, piece.nearest);
        lookAt({middle, b, tip}, piece.triangle, piece.nearest);
    }

    const Mesh& part_;
    const BoxTree& boxes_;  ///< of the part's triangles
    const Solids& solids_;
    NearestTriangle nearest_;
    const Pose& X_partEnvironment_;
    const double leastDepth_;
    std::vector<Added> added_;
    std::priority_queue<OpenPiece> open_;
    DeepestPoint best_;
    double mostLeft_ = 0;  ///< no piece that was left open lies deeper
};

}  // namespace

struct OverlapMeter::Surface {
    Mesh mesh;
    Model model;
    BoxTree boxes;  ///< of the triangles
    std::shared_ptr<const Solids> solids;
};

OverlapMeter::OverlapMeter(const Mesh& part) : OverlapMeter(part, Model::build(part)) {}

OverlapMeter::OverlapMeter(const Mesh& part, const Model& model, std::shared_ptr<const Solids> solids) {
    if (!solids) solids = makeSolids(part).solids;
    if (!solids->refusals().empty()) throw ArgumentError(solids->refusals()[0]);
    std::vector<Box> boxes;
    for (const auto& [a, b, c] : part.triangles) {
        boxes.emplace_back(part.vertices[a]);
        boxes.back().extend(part.vertices[b]).extend(part.vertices[c]);
    }
    surface_ = std::make_shared<Surface>(Surface{part, model, BoxTree(boxes), std::move(solids)});
}

DeepestPoint OverlapMeter::deepest(const Mesh& obstacle, const Pose& X_environmentPart,
                                   double leastDepth) const {
    requirePose(X_environmentPart);
    const Pose X_partEnvironment = inverse(X_environmentPart);
    DeepestSearch search(surface_->mesh, surface_->model, surface_->boxes, *surface_->solids,
                         X_partEnvironment, leastDepth);
    for (std::uint32_t t = 0; t < obstacle.triangles.size(); ++t) {
        const auto& [a, b, c] = obstacle.triangles[t];
        search.add({obstacle.vertices[a], obstacle.vertices[b], obstacle.vertices[c]}, t);
    }
    return search.find(X_environmentPart);
}

}  // namespace clearway
