#include "shrink/surface_depth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/renumber.h"
#include "mesh/topology.h"

namespace clearway {
namespace {

constexpr double kRounding = 1e-11;  ///< of the largest coordinate

/// The copies of triangles with which self-crossings are sought: their size in the triangle's, and how many
/// roundings they stand in front of it.
constexpr double kCopySize = 0.999, kCopyHeights = 100;

/// A triangle with less height over its longest edge, as a share of that edge, is a sliver: its normal is too inexact.
constexpr double kSliver = 1e-4;

/// The least of a point's barycentric coordinates in a triangle, for the point to count as well within it.
constexpr double kWellWithin = 1e-3;

/// A mesh of one triangle whose corners are one point, the origin.
Mesh pointMesh() {
    Mesh mesh;
    mesh.vertices = {Vector3::Zero()};
    mesh.triangles = {{0, 0, 0}};
    return mesh;
}

Pose poseAt(const Vector3& point) {
    Pose pose;
    pose.translation = point;
    return pose;
}

/// Whether the computed normal of a triangle, whose length is twice its area, can be relied on.
bool isSliver(const Corners3& triangle, const Vector3& normal) {
    const auto& [a, b, c] = triangle;
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !(normal.norm() > kSliver * longest);
}

double distanceToSegment(const Vector3& point, const Vector3& a, const Vector3& b) {
    const Vector3 along = b - a;
    const double lengthSquared = along.squaredNorm();
    const double s = lengthSquared > 0 ? std::clamp(along.dot(point - a) / lengthSquared, 0.0, 1.0) : 0.0;
    return (point - (a + s * along)).norm();
}

}  // namespace

double distanceToTriangle(const Vector3& point, const Corners3& triangle) {
    const auto& [a, b, c] = triangle;
    const Vector3 normal = (b - a).cross(c - a);
    const double lengthSquared = normal.squaredNorm();
    bool isAbove = !isSliver(triangle, normal);  // the distance to the edges is never less
    for (int k = 0; k < 3 && isAbove; ++k) {
        const Vector3 &from = triangle[k], &to = triangle[(k + 1) % 3];
        isAbove = normal.dot((to - from).cross(point - from)) >= 0;
    }
    if (isAbove) return std::abs(normal.dot(point - a)) / std::sqrt(lengthSquared);
    return std::min(
        {distanceToSegment(point, a, b), distanceToSegment(point, b, c), distanceToSegment(point, c, a)});
}

PointDistance::PointDistance(Model mesh) : mesh_(std::move(mesh)), point_(Model::build(pointMesh())) {}

DistanceResult PointDistance::find(const Vector3& point, Workspace& workspace) const {
    return distance(point_, mesh_, poseAt(point), {}, workspace);
}

SurfaceDepth::SurfaceDepth(const Mesh& mesh) : mesh_(mesh), distance_(Model::build(mesh)) {
    const std::vector<Component> components = componentsOf(mesh);
    outwards_.assign(mesh.triangles.size(), 1);
    for (const Component& component : components) {
        if (component.triangleCount == 0) continue;
        const std::string name = component.name.empty() ? "unnamed" : component.name;
        pieces_.push_back({name, component.firstTriangle, component.triangleCount, 1});
        solids_.emplace_back(meshOf(pieces_.size() - 1), name);
        if (solids_.back().isTurnedOver()) {
            pieces_.back().outwards = -1;
            std::fill_n(outwards_.begin() + component.firstTriangle, component.triangleCount, -1);
        }
        const auto& vertices = solids_.back().shellVertices();
        shellVertices_.insert(shellVertices_.end(), vertices.begin(), vertices.end());
    }
    const Box& box = model().box();
    rounding_ = kRounding * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    requireSimple();
}

Mesh SurfaceDepth::meshOf(std::size_t piece) const {
    Mesh part;
    part.vertices = mesh_.vertices;
    const auto first = mesh_.triangles.begin() + pieces_[piece].firstTriangle;
    part.triangles.assign(first, first + pieces_[piece].triangleCount);
    part.vertices = takeUsedVertices(mesh_.vertices, part.triangles);
    return part;
}

/// Each connected piece of the surface must keep apart from the others and from itself, with the part on its
/// one side and none on its other.
void SurfaceDepth::requireSimple() const {
    std::vector<Shell> shells;
    for (std::size_t i = 0; i < pieces_.size(); ++i) addShells(i, shells);
    Workspace workspace;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        const Shell& shell = shells[i];
        int around = 0;  // how often the others wind around this one
        std::size_t holder = shell.piece;
        for (std::size_t j = 0; j < shells.size(); ++j) {
            const Shell& other = shells[j];
            if (i == j || !other.solid.box().intersects(shell.solid.box())) continue;
            if (j < i && collides(shell.model, other.model, {}, workspace))
                refuseMeeting(other.piece, shell.piece);
            if (other.solid.winding({}, {}, shell.solid.shellVertices()[0]) <= 0) continue;
            around += other.isCavity ? -1 : 1;
            if (!other.isCavity) holder = other.piece;
        }
        if (around != (shell.isCavity ? 1 : 0)) refuseMeeting(holder, shell.piece);
    }
    requireNoSelfCrossing();
}

void SurfaceDepth::addShells(std::size_t piece, std::vector<Shell>& shells) const {
    const CleanMesh cleaned = clean(meshOf(piece));
    const Shells found = findShells(cleaned.triangles);
    const std::vector<double> volumes = signedVolumes(cleaned.vertices, cleaned.triangles, found);
    std::vector<Mesh> meshes(found.count);
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        meshes[found.ofTriangle[t]].triangles.push_back(cleaned.triangles[t]);
    }
    for (std::uint32_t k = 0; k < found.count; ++k) {
        if (volumes[k] == 0) continue;  // it encloses nothing
        meshes[k].vertices = takeUsedVertices(cleaned.vertices, meshes[k].triangles);
        shells.push_back({piece, volumes[k] * pieces_[piece].outwards < 0,
                          Solid(meshes[k], pieces_[piece].name), Model::build(meshes[k])});
    }
}

void SurfaceDepth::refuseMeeting(std::size_t a, std::size_t b) const {
    const std::string which = a == b
                                  ? "two pieces of '" + pieces_[a].name + "'"
                                  : "the components '" + pieces_[a].name + "' and '" + pieces_[b].name + "'";
    throw std::invalid_argument("overlap needs a part of which only the outside is surface, and " + which +
                                " touch or lie in each other, expected pieces that are apart");
}

/// A copy of each triangle, a little smaller and a little in front of it, meets the surface only where the surface
/// comes back to itself.
void SurfaceDepth::requireNoSelfCrossing() const {
    Workspace workspace;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const Vector3 normal = outwardNormal(t);
        const Corners3 c = corners(t);
        if (isSliver(c, normal)) continue;  // where a sliver meets the surface, the other triangle is found
        const Vector3 middle = (c[0] + c[1] + c[2]) / 3;
        Mesh copy;
        for (const Vector3& corner : c) {
            copy.vertices.push_back(middle + kCopySize * (corner - middle) +
                                    kCopyHeights * rounding_ * normal.normalized());
        }
        copy.triangles = {{0, 1, 2}};
        if (!collides(Model::build(copy), model(), {}, workspace)) continue;
        throw std::invalid_argument(
            "overlap needs a part of which only the outside is surface, and it passes through itself or "
            "touches "
            "itself at triangle " +
            std::to_string(t) + ", expected a surface that bounds one inside");
    }
}

SurfaceDepth::Place SurfaceDepth::at(const Vector3& point, Workspace& workspace) const {
    const DistanceResult found = distance_.find(point, workspace);
    const auto triangle = static_cast<std::uint32_t>(found.environmentTriangle);
    const std::optional<bool> isBehind = isBehindFace(point, triangle);
    return {(isBehind ? *isBehind : isInside(point)) ? found.distance : -found.distance, triangle};
}

/// The straight way to the nearest point of the surface crosses no surface. So if that point is well within a
/// face, the point's side of the face tells whether it is inside.
std::optional<bool> SurfaceDepth::isBehindFace(const Vector3& point, std::uint32_t triangle) const {
    const Corners3 c = corners(triangle);
    const Vector3 normal = outwardNormal(triangle);
    const double lengthSquared = normal.squaredNorm();
    const double height = normal.dot(point - c[0]);
    if (isSliver(c, normal)) return std::nullopt;
    if (!(std::abs(height) > rounding_ * std::sqrt(lengthSquared))) return std::nullopt;
    const Vector3 turned = outwards_[triangle] * normal;
    for (int k = 0; k < 3; ++k) {
        const double share = turned.dot((c[(k + 1) % 3] - c[k]).cross(point - c[k])) / lengthSquared;
        if (!(share > kWellWithin)) return std::nullopt;
    }
    return height < 0;
}

Vector3 SurfaceDepth::outwardNormal(std::uint32_t triangle) const {
    const Corners3 c = corners(triangle);
    return outwards_[triangle] * (c[1] - c[0]).cross(c[2] - c[0]);
}

std::uint32_t SurfaceDepth::nearest(const Vector3& point, Workspace& workspace) const {
    return static_cast<std::uint32_t>(distance_.find(point, workspace).environmentTriangle);
}

std::optional<std::size_t> SurfaceDepth::pieceHolding(const Vector3& point) const {
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        if (solids_[i].box().contains(point) && solids_[i].winding({}, {}, point) > 0) return i;
    }
    return std::nullopt;
}

Corners3 SurfaceDepth::corners(std::uint32_t triangle) const {
    const TriangleIndices& t = mesh_.triangles[triangle];
    return {mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
}

}  // namespace clearway
