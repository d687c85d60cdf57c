#include "shrink/level_points.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway {
namespace {

constexpr double kLeastEdgeShare = 1e-3;  ///< of an edge: its points keep so far from its ends
constexpr int kMostSteps = 12;            ///< of the search along an edge
constexpr int kMostPlaneSteps = 6;        ///< of them along planes, before the interval is halved
constexpr double kParallel = 0.999;       ///< cosine; planes nearer to each other than this have no crease
constexpr double kLeastDeterminant =
    0.02;                         ///< of three directions of length 1 whose planes meet in a good point
constexpr double kWithin = 1e-3;  ///< the least barycentric coordinate of a point within
constexpr double kLeastEigenvalue = 0.02;  ///< of the greatest one: others' directions are left as they are

}  // namespace

Vector3 LevelPoints::inwardAt(const Vector3& point, const SurfaceDepth::Place& place) const {
    const Vector3 way = place.depth < 0 ? Vector3(place.nearest - point) : Vector3(point - place.nearest);
    const double length = way.norm();
    return length > surface_.rounding() ? Vector3(way / length) : Vector3::Zero();
}

/// Depths change evenly as long as one face stays the nearest. So each step goes to where the plane of one end's face
/// meets the level.
LevelPoint LevelPoints::crossing(const End& outer, const End& inner, Workspace& workspace) const {
    const Vector3 way = inner.point - outer.point;
    const double length = way.norm();
    struct Bound {
        double share, height, slope;
    };
    const auto boundAt = [&](double share, const Vector3& point, const SurfaceDepth::Place& place) {
        return Bound{share, place.depth - level_, inwardAt(point, place).dot(way)};
    };
    Bound low = boundAt(0, outer.point, outer.place), high = boundAt(1, inner.point, inner.place);
    LevelPoint best;
    double bestHeight = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step) {
        double share = 0.5 * (low.share + high.share);
        if (step < kMostPlaneSteps) {
            for (const Bound& end : {high, low}) {
                const double met = end.share - end.height / end.slope;
                if (met > low.share && met < high.share) share = met;
            }
        }
        share = std::clamp(share, kLeastEdgeShare, 1 - kLeastEdgeShare);
        const Vector3 point = outer.point + share * way;
        const SurfaceDepth::Place place = surface_.at(point, workspace);
        const Bound found = boundAt(share, point, place);
        if (std::abs(found.height) < bestHeight) {
            bestHeight = std::abs(found.height);
            best.point = point;
            best.inward = inwardAt(point, place);
            best.triangle = place.triangle;
            best.onLevel = point - found.height * best.inward;
        }
        if (bestHeight <= fineness_ || (high.share - low.share) * length <= fineness_) break;
        (found.height < 0 ? low : high) = found;
    }
    return best;
}

std::optional<Vector3> LevelPoints::crease(const LevelPoint& a, const LevelPoint& b,
                                           const Corners3& triangle) const {
    if (a.inward.dot(b.inward) > kParallel || a.inward.isZero() || b.inward.isZero()) return std::nullopt;
    const auto& [p, q, r] = triangle;
    const Vector3 across = (q - p).cross(r - p);
    const double doubleArea = across.norm();
    const Vector3 normal = across / doubleArea;
    Matrix3 planes;
    planes << a.inward.transpose(), b.inward.transpose(), normal.transpose();
    if (!(std::abs(planes.determinant()) > kLeastDeterminant)) return std::nullopt;
    const Vector3 heights(a.inward.dot(a.onLevel - p), b.inward.dot(b.onLevel - p), 0);
    const Vector3 point = p + planes.inverse() * heights;
    for (int k = 0; k < 3; ++k) {
        const Vector3 &from = triangle[k], &to = triangle[(k + 1) % 3];
        if (!(normal.dot((to - from).cross(point - from)) > kWithin * doubleArea)) return std::nullopt;
    }
    return point;
}

/// Minimises the squared distances to the planes ("dual contouring"; Ju, Losasso, Schaefer and Warren, ACM Trans.
/// Graphics 21, 2002), from the mean and only in the directions that the planes tell.
Vector3 LevelPoints::amid(const std::vector<LevelPoint>& outline,
                          const std::array<Vector3, 4>& tetrahedron) const {
    Vector3 mean = Vector3::Zero();
    for (const LevelPoint& point : outline) mean += point.point;
    mean /= double(outline.size());
    Matrix3 squares = Matrix3::Zero();
    Vector3 pull = Vector3::Zero();
    for (const LevelPoint& point : outline) {
        squares += point.inward * point.inward.transpose();
        pull += point.inward * point.inward.dot(point.onLevel - mean);
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(squares);
    Vector3 found = mean;
    for (int k = 0; k < 3; ++k) {
        if (!(eigen.eigenvalues()[k] > kLeastEigenvalue * eigen.eigenvalues()[2])) continue;
        const Vector3 axis = eigen.eigenvectors().col(k);
        found += axis.dot(pull) / eigen.eigenvalues()[k] * axis;
    }
    Matrix3 edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = tetrahedron[k + 1] - tetrahedron[0];
    const Vector3 shares = edges.inverse() * (found - tetrahedron[0]);
    const bool isWithin = shares.minCoeff() > kWithin && shares.sum() < 1 - kWithin;
    return isWithin ? found : mean;
}

}  // namespace clearway
