#include "shrink/surface_depth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include "clearway/errors.h"
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

/// The least of a point's barycentric coordinates in a triangle, for the point to count as well within it.
constexpr double kWellWithin = 1e-3;

Mesh meshOf(const Mesh& mesh, const Component& component) {
    Mesh part;
    const auto first = mesh.triangles.begin() + component.firstTriangle;
    part.triangles.assign(first, first + component.triangleCount);
    part.vertices = takeUsedVertices(mesh.vertices, part.triangles);
    return part;
}

/// A mesh of one triangle whose corners are one point, the origin.
Mesh pointMesh() {
    Mesh mesh;
    mesh.vertices = {Vector3::Zero()};
    mesh.triangles = {{0, 0, 0}};
    return mesh;
}

Mesh joinedShells(const std::vector<SurfaceShell>& shells) {
    Mesh all;
    for (const SurfaceShell& shell : shells) {
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), shell.mesh.vertices.begin(), shell.mesh.vertices.end());
        for (const auto& [a, b, c] : shell.mesh.triangles)
            all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

Pose poseAt(const Vector3& point) {
    Pose pose;
    pose.translation = point;
    return pose;
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

SurfaceDepth::SurfaceDepth(const Mesh& mesh, double fineness)
    : mesh_(mesh), distance_(Model::build(mesh)), fineness_(fineness) {
    const Box& box = model().box();
    rounding_ = kRounding * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    outwards_.assign(mesh.triangles.size(), 1);
    std::vector<SurfaceShell> shells;
    for (const Component& component : componentsOf(mesh)) {
        if (component.triangleCount == 0) continue;
        const std::string name = component.name.empty() ? "unnamed" : component.name;
        pieces_.push_back({name, component.firstTriangle, component.triangleCount});
        solids_.emplace_back(meshOf(mesh, component), name);
        if (solids_.back().isTurnedOver())
            std::fill_n(outwards_.begin() + component.firstTriangle, component.triangleCount, -1);
        const auto& vertices = solids_.back().shellVertices();
        shellVertices_.insert(shellVertices_.end(), vertices.begin(), vertices.end());
        for (SurfaceShell& shell : findShellsOf(component, solids_.size() - 1)) {
            requireNoSelfCrossing(shell);
            shells.push_back(std::move(shell));
        }
    }
    findBodies(shells);
    const bool hasWall =
        std::any_of(solids_.begin(), solids_.end(), [](const Solid& solid) { return solid.hasWallInside(); });
    if (hasFlatShell_ || hasWall || doMeet(shells)) join(shells);
}

std::vector<SurfaceShell> SurfaceDepth::findShellsOf(const Component& component, std::size_t number) {
    const CleanMesh cleaned = clean(meshOf(mesh_, component));
    const Shells found = findShells(cleaned.triangles);
    const std::vector<double> volumes = signedVolumes(cleaned.vertices, cleaned.triangles, found);
    std::vector<Mesh> meshes(found.count);
    std::vector<std::vector<std::uint32_t>> triangles(found.count);
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        meshes[found.ofTriangle[t]].triangles.push_back(cleaned.triangles[t]);
        triangles[found.ofTriangle[t]].push_back(component.firstTriangle + cleaned.triangleIds[t]);
    }
    const double outwards = outwards_[component.firstTriangle];
    std::vector<SurfaceShell> shells;
    for (std::uint32_t k = 0; k < found.count; ++k) {
        if (volumes[k] == 0) {  // it encloses nothing, and would be a wall where it lies in the part
            hasFlatShell_ = true;
            continue;
        }
        meshes[k].vertices = takeUsedVertices(cleaned.vertices, meshes[k].triangles);
        shells.push_back({number, volumes[k] * outwards < 0, outwards, meshes[k], triangles[k],
                          Solid(meshes[k], component.name), Model::build(meshes[k])});
    }
    return shells;
}

/// A copy of each triangle, a little smaller and a little in front of it, meets the surface only where the surface
/// comes back to itself.
void SurfaceDepth::requireNoSelfCrossing(const SurfaceShell& shell) const {
    Workspace workspace;
    for (std::size_t t = 0; t < shell.mesh.triangles.size(); ++t) {
        const Corners3 c = corners(shell.triangles[t]);
        const Vector3 normal = outwardNormal(shell.triangles[t]);
        if (isSliver(c, normal)) continue;  // where a sliver meets the surface, the other triangle is found
        const Vector3 middle = (c[0] + c[1] + c[2]) / 3;
        Mesh copy;
        for (const Vector3& corner : c) {
            copy.vertices.push_back(middle + kCopySize * (corner - middle) +
                                    kCopyHeights * rounding_ * normal.normalized());
        }
        copy.triangles = {{0, 1, 2}};
        if (!collides(smallModel(copy), shell.model, {}, workspace)) continue;
        throw ArgumentError(
            "overlap needs a part of which only the outside is surface, and it passes through itself or "
            "touches itself at triangle " +
            std::to_string(shell.triangles[t]) + ", expected a surface that bounds one inside");
    }
}

Box SurfaceDepth::grown(const Box& box) const {
    return Box(box.min() - Vector3::Constant(fineness_), box.max() + Vector3::Constant(fineness_));
}

/// Whether two shells have less than the fineness between them, or one is neither a cavity right inside another one
/// nor apart from all others.
bool SurfaceDepth::doMeet(const std::vector<SurfaceShell>& shells) const {
    Workspace workspace;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        int around = 0;  // how often the others wind around this one
        for (std::size_t j = 0; j < shells.size(); ++j) {
            const SurfaceShell& other = shells[j];
            if (i == j || !grown(other.solid.box()).intersects(shells[i].solid.box())) continue;
            if (j < i && isWithin(shells[i].model, other.model, {}, fineness_, workspace)) return true;
            if (other.solid.winding({}, {}, shells[i].solid.shellVertices()[0]) <= 0) continue;
            around += other.isCavity ? -1 : 1;
        }
        if (around != (shells[i].isCavity ? 1 : 0)) return true;
    }
    return false;
}

void SurfaceDepth::join(const std::vector<SurfaceShell>& shells) {
    const OuterSurface outer = outerSurface(
        shells, [&](const Vector3& point) { return isInComponent(point); }, fineness_);
    everything_ = hasFlatShell_ ? PointDistance(Model::build(joinedShells(shells))) : std::move(distance_);
    distance_ = PointDistance(Model::build(outer.mesh));
    partTriangles_ = outer.triangles;
    std::vector<double> outwards;
    for (const std::uint32_t t : partTriangles_) outwards.push_back(outwards_[t]);
    outwards_ = std::move(outwards);
    mesh_ = outer.mesh;
    pieces_ = {{"part", 0, static_cast<std::uint32_t>(mesh_.triangles.size())}};
}

/// The smallest shell of a component around shell i, if the component has material there.
std::optional<std::size_t> SurfaceDepth::shellAround(const std::vector<SurfaceShell>& shells, std::size_t i,
                                                     std::size_t component) {
    const Vector3& vertex = shells[i].solid.shellVertices()[0];
    int around = 0;
    std::optional<std::size_t> smallest;
    for (std::size_t j = 0; j < shells.size(); ++j) {
        const SurfaceShell& other = shells[j];
        if (i == j || other.component != component || !other.solid.box().contains(vertex)) continue;
        if (other.solid.winding({}, {}, vertex) <= 0) continue;
        around += other.isCavity ? -1 : 1;
        const bool isSmallest =
            !smallest || other.solid.box().volume() < shells[*smallest].solid.box().volume();
        if (!other.isCavity && isSmallest) smallest = j;
    }
    return around > 0 ? smallest : std::nullopt;
}

void SurfaceDepth::findBodies(const std::vector<SurfaceShell>& shells) {
    std::vector<std::size_t> group(shells.size());
    std::iota(group.begin(), group.end(), std::size_t(0));
    const auto join = [&](std::size_t i, std::size_t j) {
        std::replace(group.begin(), group.end(), std::size_t(group[j]), std::size_t(group[i]));
    };
    Workspace workspace;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        for (std::size_t component = 0; component < solids_.size(); ++component) {
            if (const auto around = shellAround(shells, i, component)) join(*around, i);
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (group[i] == group[j] || !grown(shells[i].solid.box()).intersects(shells[j].solid.box()))
                continue;
            if (isWithin(shells[i].model, shells[j].model, {}, fineness_, workspace)) join(j, i);
        }
    }
    bodyOfTriangle_.assign(mesh_.triangles.size(), 0);
    std::map<std::size_t, std::size_t> bodies;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        const std::size_t body = bodies.emplace(group[i], bodies.size()).first->second;
        if (body == bodyNames_.size()) bodyNames_.push_back(pieces_[shells[i].component].name);
        for (const std::uint32_t t : shells[i].triangles) bodyOfTriangle_[t] = body;
    }
}

std::size_t SurfaceDepth::bodyNear(const Vector3& point, Workspace& workspace) const {
    return bodyOfTriangle_[partTriangle(nearest(point, workspace))];
}

SurfaceDepth::Place SurfaceDepth::at(const Vector3& point, Workspace& workspace) const {
    const DistanceResult found = distance_.find(point, workspace);
    const auto triangle = static_cast<std::uint32_t>(found.witness->environmentTriangle);
    if (everything_) {
        const bool isIn = isInComponent(point) || isInGap(point, found.distance, workspace);
        return {isIn ? found.distance : -found.distance, triangle, found.witness->pointOnEnvironment};
    }
    const std::optional<bool> isBehind = isBehindFace(point, triangle);
    const bool isIn = isBehind ? *isBehind : isInside(point);
    return {isIn ? found.distance : -found.distance, triangle, found.witness->pointOnEnvironment};
}

bool SurfaceDepth::isInComponent(const Vector3& point) const {
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
        return solid.box().contains(point) && solid.winding({}, {}, point) > 0;
    });
}

/// Whether a point outside of all components lies in a gap that counts as filled: near a surface, but at the
/// given distance from the outside.
bool SurfaceDepth::isInGap(const Vector3& point, double distance, Workspace& workspace) const {
    if (distance <= 2 * fineness_) return false;
    return everything_->at(point, workspace) <= fineness_;
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
    return static_cast<std::uint32_t>(distance_.find(point, workspace).witness->environmentTriangle);
}

bool SurfaceDepth::isInside(const Vector3& point) const {
    if (!everything_) return isInComponent(point);
    Workspace workspace;
    return at(point, workspace).depth >= 0;
}

std::vector<Vector3> SurfaceDepth::surfacePoints() const {
    if (!everything_) return shellVertices_;
    std::vector<Vector3> points;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        const bool isNext = t == 0 || partTriangles_[t] != partTriangles_[t - 1];
        if (isNext) points.push_back(mesh_.vertices[mesh_.triangles[t][0]]);
    }
    return points;
}

Corners3 SurfaceDepth::corners(std::uint32_t triangle) const {
    const TriangleIndices& t = mesh_.triangles[triangle];
    return {mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
}

}  // namespace clearway
