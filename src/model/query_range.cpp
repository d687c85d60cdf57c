// Finds unreachable triangles and refuses queries beyond a range.
//
// A triangle and a box are as far apart as the widest gap between their shadows on a line. The features that
// can be nearest give the few directions along which this gap can be widest: the axes, the triangle's normal,
// cross products of edges, from a box corner perpendicularly to an edge, and from the box to a corner. Any
// gap is a true lower bound, so rounding of a direction can only keep a triangle that might have gone.
#include "model/query_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "clearway/errors.h"
#include "core/number.h"
#include "mesh/renumber.h"

namespace clearway {
namespace {

/// Relative to the largest coordinate: the rounding of a gap is at most 32 * 2^-53; the rest is reserve.
constexpr double kSlack = 128 * 0x1p-53;

/// A pose's rotation may lengthen the part by a share of 3/2 of the rotation's defect.
constexpr double kStretch = 1 + 2 * kPoseDefect;

using CornerPoints = std::array<Vector3, 3>;

double largestCoordinate(const Box& box) {
    return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// The direction scaled so that its largest coordinate is 1/4: products then neither overflow nor vanish.
/// Zero for a direction that is zero or not finite.
Vector3 scaled(const Vector3& direction) {
    const double largest = direction.cwiseAbs().maxCoeff();
    return largest > 0 && std::isfinite(largest) ? Vector3(direction / largest / 4) : Vector3::Zero();
}

/// The surroundings of a box up to a distance.
class Surroundings {
  public:
    Surroundings(const Box& box, double limit) : box_(box), limit_(limit) {}

    /// Whether the triangle is surely farther from the box than the limit.
    bool isFarther(const CornerPoints& triangle) const {
        Box around;
        for (const Vector3& corner : triangle) around.extend(corner);
        const Vector3 below = box_.min() - around.max(), above = around.min() - box_.max();
        if (below.cwiseMax(above).cwiseMax(0.0).stableNorm() > limit_) return true;
        return isFartherAlongOtherLines(triangle);
    }

  private:
    Vector3 nearestInBox(const Vector3& point) const {
        return point.cwiseMax(box_.min()).cwiseMin(box_.max());
    }

    bool isFartherAlongOtherLines(const CornerPoints& triangle) const {
        for (const Vector3& corner : triangle) {
            const Vector3 away = corner - nearestInBox(corner);
            if (away.stableNorm() <= limit_) return false;
            if (separates(away, triangle)) return true;
        }
        std::array<Vector3, 3> edges;
        for (int i = 0; i < 3; ++i) edges[i] = scaled(triangle[(i + 1) % 3] - triangle[i]);
        if (separates(edges[0].cross(edges[1]), triangle)) return true;
        for (int i = 0; i < 3; ++i) {
            if (edgeSeparates(triangle[i], edges[i], triangle)) return true;
        }
        return false;
    }

    bool edgeSeparates(const Vector3& from, const Vector3& edge, const CornerPoints& triangle) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (separates(edge.cross(Vector3::Unit(axis)), triangle)) return true;
        }
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 way = scaled(box_.corner(Box::CornerType(corner)) - from);
            if (separates(way * edge.squaredNorm() - edge * way.dot(edge), triangle)) return true;
        }
        return false;
    }

    bool separates(const Vector3& direction, const CornerPoints& triangle) const {
        const Vector3 v = scaled(direction);
        const Vector3 toLow = v.cwiseProduct(box_.min()), toHigh = v.cwiseProduct(box_.max());
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Vector3& corner : triangle) {
            least = std::min(least, v.dot(corner));
            most = std::max(most, v.dot(corner));
        }
        const double gap =
            std::max(least - toLow.cwiseMax(toHigh).sum(), toLow.cwiseMin(toHigh).sum() - most);
        return gap > limit_ * v.norm();
    }

    const Box box_;
    const double limit_;
};

CornerPoints cornersOf(const CleanMesh& mesh, const TriangleIndices& triangle) {
    return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
}

[[noreturn]] void refuseBeyondRange(const std::string& what, double value, const std::string& expected) {
    throw ArgumentError(what + " is " + shortNumber(value) + ", expected " + expected +
                        ": the environment was built without the triangles beyond that range");
}

}  // namespace

void requireRange(const QueryRange& range) {
    const Vector3 low = range.positions.min(), high = range.positions.max();
    for (int axis = 0; axis < 3; ++axis) {
        if (low[axis] <= high[axis] && std::isfinite(low[axis]) && std::isfinite(high[axis])) continue;
        throw ArgumentError(std::string("the range's positions along ") + "xyz"[axis] + " are " +
                            formatNumber(low[axis]) + " to " + formatNumber(high[axis]) +
                            ", expected finite numbers, the first at most the second");
    }
    requireNotNegative("the range's partRadius", range.partRadius);
    requireNotNegative("the range's cap", range.cap);
}

std::size_t leaveOutUnreachable(CleanMesh& mesh, const QueryRange& range) {
    Box all = range.positions;
    for (const Vector3& vertex : mesh.vertices) all.extend(vertex);
    const double limit = range.partRadius * kStretch + range.cap;
    const Surroundings near(range.positions, limit + kSlack * (largestCoordinate(all) + limit));

    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!near.isFarther(cornersOf(mesh, mesh.triangles[i]))) kept.push_back(i);
    }
    if (kept.empty()) kept.push_back(0);
    const std::size_t leftOut = mesh.triangles.size() - kept.size();
    if (leftOut == 0) return 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        mesh.triangles[i] = mesh.triangles[kept[i]];
        mesh.triangleIds[i] = mesh.triangleIds[kept[i]];
    }
    mesh.triangles.resize(kept.size());
    mesh.triangleIds.resize(kept.size());
    mesh.vertices = takeUsedVertices(mesh.vertices, mesh.triangles);
    return leftOut;
}

void requireWithinRange(const Model& part, const Model& environment, const Pose& X_environmentPart) {
    if (part.range()) {
        throw ArgumentError(
            "the part was built with a range and lacks triangles, expected one built without");
    }
    if (!environment.range()) return;
    const QueryRange& range = *environment.range();
    if (part.radiusAboutOrigin() > range.partRadius) {
        refuseBeyondRange("the part's radius about its origin", part.radiusAboutOrigin(),
                          "at most " + shortNumber(range.partRadius));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double low = range.positions.min()[axis], high = range.positions.max()[axis];
        const double position = X_environmentPart.translation[axis];
        if (position >= low && position <= high) continue;
        refuseBeyondRange(std::string("the pose's translation along ") + "xyz"[axis], position,
                          shortNumber(low) + " to " + shortNumber(high));
    }
}

void requireWithinCap(const Model& environment, double d) {
    if (!environment.range() || d <= environment.range()->cap) return;
    refuseBeyondRange("d", d, "at most " + shortNumber(environment.range()->cap));
}

double cappedByRange(const Model& environment, double cap) {
    return environment.range() ? std::min(cap, environment.range()->cap) : cap;
}

}  // namespace clearway
