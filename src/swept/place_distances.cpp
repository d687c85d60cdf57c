#include "swept/place_distances.h"

#include <algorithm>
#include <limits>

#include "mesh/clean.h"
#include "mesh/topology.h"

namespace clearway {
namespace {

constexpr double kError = 1.0 / 32;      ///< of the tolerance: how closely small distances are known
constexpr double kErrorShare = 0.1;      ///< of a distance: how closely larger ones are known
constexpr double kLeastInterval = 1e-2;  ///< of the tolerance: pieces of a motion that are too close to tell
constexpr double kTriangleRounding = 1e-9;  ///< of a distance between a triangle and a point

Mesh pointAtOrigin() {
    Mesh mesh;
    mesh.vertices = {Vector3::Zero()};
    mesh.triangles = {{0, 0, 0}};
    return mesh;
}

/// A triangle about its first corner. It is asked about too seldom for a slow build to pay.
Model modelOf(const SurfaceTriangle& triangle) {
    Mesh mesh;
    for (const Vector3& corner : triangle) mesh.vertices.push_back(corner - triangle[0]);
    mesh.triangles = {{0, 1, 2}};
    return Model::build(mesh);
}

/// One vertex of each connected piece of the mesh, as triangles without area.
Mesh pieceVertices(const Mesh& mesh) {
    const CleanMesh cleaned = clean(mesh);
    const Shells shells = findShells(cleaned.triangles);
    std::vector<bool> isTaken(shells.count);
    Mesh points;
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        if (isTaken[shells.ofTriangle[t]]) continue;
        isTaken[shells.ofTriangle[t]] = true;
        const auto number = static_cast<std::uint32_t>(points.vertices.size());
        points.vertices.push_back(cleaned.vertices[cleaned.triangles[t][0]]);
        points.triangles.push_back({number, number, number});
    }
    return points;
}

}  // namespace

PlaceDistances::PlaceDistances(const Mesh& part, const std::vector<RigidMotion>& motions, double tolerance,
                               double poseError)
    : part_(Model::build(part)),
      point_(Model::build(pointAtOrigin())),
      pieces_(Model::build(pieceVertices(part))),
      solids_(makeSolids(part).solids),
      pointPiece_(pointAtOrigin()),
      tolerance_(tolerance),
      poseError_(poseError) {
    for (const auto& [a, b, c] : part.triangles)
        partTriangles_.push_back({part.vertices[a], part.vertices[b], part.vertices[c]});
    const Vector3 centre = part_.box().center();
    const double radius = 0.5 * part_.box().diagonal().norm();
    for (const RigidMotion& motion : motions) {
        // The centre's way is no longer than the translation and its arc about the origin.
        const double reach = 0.5 * (motion.translation.norm() + motion.rotation.norm() * centre.norm());
        const MotionPieces pieces = piecesOf(motion, part_);
        motions_.push_back({motion, pieces, pieces(0, 1).middle * centre, radius + reach + poseError});
        box_.extend(Box(motions_.back().centre - Vector3::Constant(motions_.back().radius),
                        motions_.back().centre + Vector3::Constant(motions_.back().radius)));
    }
}

PlaceDistance PlaceDistances::at(const Vector3& point, std::size_t& first, Workspace& workspace) const {
    PlaceDistance least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const std::size_t begin = first;
    for (std::size_t i = 0; i < motions_.size(); ++i) {
        const std::size_t k = i == 0 ? begin : i <= begin ? i - 1 : i;
        const Motion& motion = motions_[k];
        if ((point - motion.centre).norm() - motion.radius >= least.lower) continue;
        const LeastDistance found = along(motion.motion, point, least.upper, workspace);
        least.lower = std::min(least.lower, std::max(found.lower, 0.0));
        if (found.upper >= least.upper) continue;
        least.upper = found.upper;
        least.motion = first = k;
        least.time = found.nearest->time;
        least.partTriangle = found.nearest->triangles.part;
    }
    return least;
}

LeastDistance PlaceDistances::along(RigidMotion motion, const Vector3& point, double cap,
                                    Workspace& workspace) const {
    motion.start.translation -= point;
    LeastDistanceOptions options;
    options.poseError = poseError_;
    options.cap = cap;
    options.resolution = {kErrorShare, kErrorShare, 0, kError * tolerance_};
    return leastDistance(part_, point_, piecesOf(motion, part_), options, workspace);
}

bool PlaceDistances::isInMaterial(const Vector3& point) const {
    return std::any_of(motions_.begin(), motions_.end(), [&](const Motion& motion) {
        return (point - motion.centre).norm() <= motion.radius &&
               solids_->holding(motion.motion.start, pointPiece_, {Matrix3::Identity(), point});
    });
}

bool PlaceDistances::holdsPiece(const Vector3& centre, double radius, Workspace& workspace) const {
    return std::any_of(motions_.begin(), motions_.end(), [&](const Motion& motion) {
        Pose X_pointPart = motion.motion.start;
        X_pointPart.translation -= centre;
        return (centre - motion.centre).norm() <= motion.radius + radius &&
               isWithin(pieces_, point_, X_pointPart, radius, workspace);
    });
}

bool PlaceDistances::areApart(const SurfaceTriangle& triangle, double distance, Workspace& workspace) const {
    const Vector3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3;
    double radius = 0;
    for (const Vector3& corner : triangle) radius = std::max(radius, (corner - centre).norm());
    const Model model = modelOf(triangle);
    SweepOptions options;
    options.margin = distance;
    options.poseError = poseError_;
    options.leastInterval = kLeastInterval * tolerance_;
    for (const Motion& each : motions_) {
        if ((centre - each.centre).norm() - each.radius - radius > distance) continue;
        RigidMotion motion = each.motion;
        motion.start.translation -= triangle[0];
        if (sweep(part_, model, piecesOf(motion, part_), options, workspace).verdict !=
            SweepVerdict::kCertified)
            return false;
    }
    return true;
}

bool PlaceDistances::isWithinOfOnePlace(const SurfaceTriangle& triangle, double distance,
                                        const PlaceDistance& place, Workspace& workspace) const {
    if (place.partTriangle < 0) return false;
    const Model surface = modelOf(partTriangles_[std::size_t(place.partTriangle)]);
    const Vector3& corner = partTriangles_[std::size_t(place.partTriangle)][0];
    const Pose X_environmentPart = motions_[place.motion].pieces(place.time, place.time).middle;
    const double most = (distance - poseError_) * (1 - kTriangleRounding);
    return std::all_of(triangle.begin(), triangle.end(), [&](const Vector3& point) {
        const Pose X_pointTriangle{X_environmentPart.rotation, X_environmentPart * corner - point};
        return isWithin(surface, point_, X_pointTriangle, most, workspace);
    });
}

}  // namespace clearway
