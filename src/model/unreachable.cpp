// A triangle and a box are as far apart as the widest gap between their shadows on a line, and that gap is
// widest along one of few directions, given by the features that can be nearest: an axis or the triangle's
// normal, the crosses of edges, from a box corner straight to an edge, from the box to a corner. Any gap is a
// true lower bound, so a direction that is off by rounding only keeps a triangle that might have gone.
#include "model/unreachable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/number.h"
#include "mesh/renumber.h"

namespace clearway {
namespace {

/// Of the largest coordinate: 2^-53 times 32 for the rounding of a gap, and to spare.
constexpr double kSlack = 128 * 0x1p-53;

/// A pose's rotation may lengthen the part by 3/2 of its defect, relative to it.
constexpr double kStretch = 1 + 2 * kPoseDefect;

using Corners = std::array<Vector3, 3>;

double largestCoordinate(const Box& box) {
    return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// The same direction with 1/4 as its largest coordinate, so that products neither overflow nor vanish; zero
/// when it has none.
Vector3 scaled(const Vector3& direction) {
    const double largest = direction.cwiseAbs().maxCoeff();
    return largest > 0 && std::isfinite(largest) ? Vector3(direction / largest / 4) : Vector3::Zero();
}

class Surroundings {
  public:
    /// What is farther from the box than the limit is to be left out.
    Surroundings(const Box& box, double limit) : box_(box), limit_(limit) {}

    bool isFarther(const Corners& triangle) const {
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

    bool isFartherAlongOtherLines(const Corners& triangle) const {
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

    bool edgeSeparates(const Vector3& from, const Vector3& edge, const Corners& triangle) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (separates(edge.cross(Vector3::Unit(axis)), triangle)) return true;
        }
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 way = scaled(box_.corner(Box::CornerType(corner)) - from);
            if (separates(way * edge.squaredNorm() - edge * way.dot(edge), triangle)) return true;
        }
        return false;
    }

    bool separates(const Vector3& direction, const Corners& triangle) const {
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

Corners cornersOf(const CleanMesh& mesh, const TriangleIndices& triangle) {
    return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
}

void requireLength(double value, const char* name) {
    if (value >= 0 && std::isfinite(value)) return;
    throw std::invalid_argument(std::string("the reach's ") + name + " is " + formatNumber(value) +
                                ", expected a finite number of at least 0");
}

}  // namespace

void requireReach(const Reach& reach) {
    const Vector3 low = reach.positions.min(), high = reach.positions.max();
    for (int axis = 0; axis < 3; ++axis) {
        if (low[axis] <= high[axis] && std::isfinite(low[axis]) && std::isfinite(high[axis])) continue;
        throw std::invalid_argument(std::string("the reach's positions along ") + "xyz"[axis] + " are " +
                                    formatNumber(low[axis]) + " to " + formatNumber(high[axis]) +
                                    ", expected finite numbers, the first at most the second");
    }
    requireLength(reach.partRadius, "partRadius");
    requireLength(reach.cap, "cap");
}

std::size_t leaveOutUnreachable(CleanMesh& mesh, const Reach& reach) {
    Box all = reach.positions;
    for (const Vector3& vertex : mesh.vertices) all.extend(vertex);
    const double limit = reach.partRadius * kStretch + reach.cap;
    const Surroundings near(reach.positions, limit + kSlack * (largestCoordinate(all) + limit));

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

}  // namespace clearway
