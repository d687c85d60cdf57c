// Decides on which side of closed surfaces points lie, and finds the solids of a mesh.
#include "model/solids.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "clearway/errors.h"
#include "core/number.h"
#include "exact/ray_crossing.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"

namespace clearway {
namespace {

[[noreturn]] void refuseSolid(const std::string& name, const std::string& why) {
    throw ArgumentError("'" + name + "' encloses nothing: " + why);
}

void requireClosed(const EdgeReport& edges, const std::string& name) {
    if (edges.isClosed()) return;
    refuseSolid(name,
                fmt::format("{} open edges, {} edges where a triangle is turned over and {} edges of more "
                            "than two triangles that do not face in pairs, expected a closed surface",
                            edges.openEdges, edges.twistedEdges, edges.overfullEdges));
}

bool isCollapsed(const TriangleIndices& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// One vertex of each shell.
std::vector<Vector3> verticesOf(const Shells& shells, const std::vector<Vector3>& vertices,
                                const std::vector<TriangleIndices>& triangles) {
    std::vector<Vector3> found;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (shells.ofTriangle[t] == found.size()) found.push_back(vertices[triangles[t][0]]);
    }
    return found;
}

/// How far in front of a triangle its surroundings are looked at, relative to the solid's diagonal. Thinner regions
/// enclose nothing of interest.
constexpr double kInFront = 1e-9;

}  // namespace

/// A mesh's surface with what its solid is made from.
struct WeldedSurface {
    explicit WeldedSurface(CleanMesh mesh)
        : vertices(std::move(mesh.vertices)),
          triangles(std::move(mesh.triangles)),
          topology(findTopology(triangles)) {}

    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
    Topology topology;
};

Solid::Solid(const Mesh& mesh, const std::string& name) : Solid(WeldedSurface(clean(mesh)), name) {}

Solid::Solid(WeldedSurface surface, const std::string& name)
    : vertices_(std::move(surface.vertices)), triangles_(std::move(surface.triangles)) {
    Topology& topology = surface.topology;
    const auto collapsed = std::remove_if(triangles_.begin(), triangles_.end(), isCollapsed);
    if (collapsed != triangles_.end()) {
        triangles_.erase(collapsed, triangles_.end());
        topology = findTopology(triangles_);
    }
    if (triangles_.empty()) refuseSolid(name, "it has no triangle with three corners");
    requireClosed(topology.edges, name);
    boxTriangles();
    orient(topology.shells, name);
    if (topology.edges.touchingEdges > 0) lookInFront(name);
}

Solid Solid::oriented(const Mesh& mesh) {
    Solid solid;
    solid.vertices_ = mesh.vertices;
    solid.triangles_ = mesh.triangles;
    solid.shellVertices_ = verticesOf(findShells(mesh.triangles), mesh.vertices, mesh.triangles);
    solid.boxTriangles();
    return solid;
}

void Solid::boxTriangles() {
    for (const Vector3& vertex : vertices_) box_.extend(vertex);
    std::vector<Box> boxes;
    boxes.reserve(triangles_.size());
    for (const auto& [a, b, c] : triangles_) {
        boxes.emplace_back(vertices_[a]).extend(vertices_[b]).extend(vertices_[c]);
    }
    tree_ = BoxTree(boxes);
}

/// Where surfaces touch along edges, one connected surface may bound pieces that face different ways.
void Solid::lookInFront(const std::string& name) const {
    const double step = (isTurnedOver_ ? -kInFront : kInFront) * box_.diagonal().norm();
    for (const auto& [a, b, c] : triangles_) {
        const Vector3 normal = (vertices_[b] - vertices_[a]).cross(vertices_[c] - vertices_[a]).normalized();
        const Vector3 middle = (vertices_[a] + vertices_[b] + vertices_[c]) / 3;
        if (winding({}, {}, middle + step * normal) < 0) {
            refuseSolid(name, "a part of its surface faces the other way than the rest, near " +
                                  roundedPoint(middle) + ", expected all to face one way");
        }
    }
}

template <class Take>
void Solid::eachCrossing(const ZRay& ray, const Take& take) const {
    Box along = ray.aroundOrigin();
    along.max().z() = std::numeric_limits<double>::infinity();
    tree_.eachMeeting(along, [&](std::uint32_t triangle) {
        const auto& [a, b, c] = triangles_[triangle];
        const int sign = ray.crossing({&vertices_[a], &vertices_[b], &vertices_[c]});
        if (sign != 0) take(triangle, sign);
    });
}

int Solid::winding(const ZRay& fromPoint) const {
    int sum = 0;
    eachCrossing(fromPoint, [&](std::uint32_t, int sign) { sum += sign; });
    return isTurnedOver_ ? -sum : sum;
}

int Solid::winding(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point) const {
    return winding(ZRay(X_aMesh, X_aPoint, point));
}

/// Entry i: whether one of shell i's vertices is inside no other shell. Looks at all vertices, because shells may pierce each other.
std::vector<bool> Solid::findOutermost(const Shells& shells) const {
    if (shells.count == 1) return {true};
    std::vector<std::vector<std::uint32_t>> trianglesOf(shells.count);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) trianglesOf[shells.ofTriangle[t]].push_back(t);
    std::vector<int> windings(shells.count, 0);
    std::vector<std::uint32_t> crossedShells;
    const auto isOutside = [&](std::uint32_t shell, const Vector3& vertex) {
        crossedShells.clear();
        eachCrossing(ZRay({}, {}, vertex), [&](std::uint32_t triangle, int sign) {
            crossedShells.push_back(shells.ofTriangle[triangle]);
            windings[crossedShells.back()] += sign;
        });
        windings[shell] = 0;  // the vertex lies on this shell
        const bool isZero = std::all_of(crossedShells.begin(), crossedShells.end(),
                                        [&](std::uint32_t other) { return windings[other] == 0; });
        for (const std::uint32_t other : crossedShells) windings[other] = 0;
        return isZero;
    };
    std::vector<std::uint32_t> seenBy(vertices_.size(),
                                      shells.count);  // the last shell that looked at the vertex
    const auto isOutermost = [&](std::uint32_t shell) {
        for (const std::uint32_t triangle : trianglesOf[shell]) {
            for (const std::uint32_t corner : triangles_[triangle]) {
                if (seenBy[corner] == shell) continue;
                seenBy[corner] = shell;
                if (isOutside(shell, vertices_[corner])) return true;
            }
        }
        return false;
    };
    std::vector<bool> found(shells.count);
    for (std::uint32_t shell = 0; shell < shells.count; ++shell) found[shell] = isOutermost(shell);
    return found;
}

void Solid::orient(const Shells& shells, const std::string& name) {
    const std::vector<double> volumes = signedVolumes(vertices_, triangles_, shells);
    const std::vector<bool> isOutermost = findOutermost(shells);
    shellVertices_ = verticesOf(shells, vertices_, triangles_);
    std::size_t outward = 0, inward = 0;
    for (std::uint32_t shell = 0; shell < shells.count; ++shell) {
        if (volumes[shell] != 0 && isOutermost[shell]) ++(volumes[shell] > 0 ? outward : inward);
    }
    if (outward > 0 && inward > 0) {
        refuseSolid(
            name, fmt::format(
                      "{} of its outermost shells face outwards and {} inwards, expected all to face one way",
                      outward, inward));
    }
    isTurnedOver_ = inward > 0;
}

Solids::Solids(const Mesh& mesh) {
    const std::vector<Component> components = componentsOf(mesh);
    std::vector<CleanMesh> cleaned = cleanComponents(mesh);
    solids_.reserve(components.size());
    for (std::size_t i = 0; i < components.size(); ++i) {
        names_.push_back(components[i].name.empty() ? "unnamed" : components[i].name);
        if (components[i].triangleCount == 0) continue;
        WeldedSurface surface(std::move(cleaned[i]));
        const Shells& shells = surface.topology.shells;
        for (const Vector3& vertex : verticesOf(shells, surface.vertices, surface.triangles)) {
            pieces_.push_back({vertex, i});
        }
        try {
            Solid solid(std::move(surface), names_[i]);
            if (solid.isTurnedOver()) turnedOver_.push_back(names_[i]);
            solids_.push_back({std::move(solid), i});
        } catch (const std::invalid_argument& refusal) {
            refusals_.push_back(refusal.what());
        }
    }
    findTrees();
}

Solids Solids::oriented(const Mesh& mesh) {
    Solids made;
    const std::vector<Component> components = componentsOf(mesh);
    for (std::size_t i = 0; i < components.size(); ++i) {
        made.names_.push_back(components[i].name.empty() ? "unnamed" : components[i].name);
        if (components[i].triangleCount == 0) continue;
        made.solids_.push_back({Solid::oriented(meshOfComponents(mesh, {i})), i});
        for (const Vector3& vertex : made.solids_.back().solid.shellVertices())
            made.pieces_.push_back({vertex, i});
    }
    made.findTrees();
    return made;
}

Solids Solids::ofComponent(std::size_t component) const {
    Solids made;
    made.names_ = names_;
    const auto isOfIt = [&](const auto& each) { return each.component == component; };
    std::copy_if(solids_.begin(), solids_.end(), std::back_inserter(made.solids_), isOfIt);
    std::copy_if(pieces_.begin(), pieces_.end(), std::back_inserter(made.pieces_), isOfIt);
    made.findTrees();
    return made;
}

bool Solids::hold(const Vector3& point) const {
    return std::any_of(solids_.begin(), solids_.end(), [&](const NamedSolid& named) {
        return named.solid.box().contains(point) && named.solid.winding({}, {}, point) > 0;
    });
}

void Solids::findTrees() {
    std::vector<Box> boxes, points;
    for (const NamedSolid& named : solids_) {
        boxes.push_back(named.solid.box());
        box_.extend(boxes.back());
    }
    for (const Piece& piece : pieces_) points.emplace_back(piece.vertex);
    solidTree_ = BoxTree(boxes);
    pieceTree_ = BoxTree(points);
}

/// A box in the other mesh's coordinates around all solids of this one. The slack exceeds rounding and the poses' defects by far.
Box Solids::boxIn(const Pose& X_aOther, const Pose& X_aThis) const {
    constexpr double kSlack = 1e-9;
    const Pose X_otherThis = inverse(X_aOther) * X_aThis;
    const Vector3 centre = X_otherThis * box_.center(), half = 0.5 * box_.sizes();
    const double lengths = box_.min().lpNorm<1>() + box_.max().lpNorm<1>() +
                           X_aOther.translation.lpNorm<1>() + X_aThis.translation.lpNorm<1>();
    const Vector3 reach = X_otherThis.rotation.cwiseAbs() * half + Vector3::Constant(kSlack * lengths);
    return {centre - reach, centre + reach};
}

std::optional<Solids::Enclosure> Solids::holding(const Pose& X_aThis, const Solids& inner,
                                                 const Pose& X_aInner) const {
    if (solids_.empty()) return std::nullopt;
    std::size_t first = solids_.size(), held = 0;  // the first solid that holds a piece, and its first piece
    inner.pieceTree_.eachMeeting(boxIn(X_aInner, X_aThis), [&](std::uint32_t piece) {
        const ZRay ray(X_aThis, X_aInner, inner.pieces_[piece].vertex);
        solidTree_.eachMeeting(ray.aroundOrigin(), [&](std::uint32_t outer) {
            if (outer > first || (outer == first && piece > held)) return;
            if (solids_[outer].solid.winding(ray) <= 0) return;
            first = outer;
            held = piece;
        });
    });
    if (first == solids_.size()) return std::nullopt;
    return Enclosure{&names_[solids_[first].component], &inner.names_[inner.pieces_[held].component]};
}

MadeSolids makeSolids(const Mesh& mesh) {
    auto solids = std::make_shared<const Solids>(mesh);
    return {solids, solids->refusals(), solids->turnedOver()};
}

}  // namespace clearway
