// Decides on which side of closed surfaces points lie, and finds the solids of a mesh.
#include "model/solids.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
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

constexpr std::uint32_t kLeafSize = 4;
constexpr std::size_t kDeepest = 64;  ///< enough, because a node's halves differ by at most one triangle

[[noreturn]] void refuseSolid(const std::string& name, const std::string& why) {
    throw ArgumentError("'" + name + "' encloses nothing: " + why);
}

EdgeReport requireClosed(const std::vector<TriangleIndices>& triangles, const std::string& name) {
    const EdgeReport edges = checkEdges(triangles);
    if (edges.isClosed()) return edges;
    refuseSolid(name,
                fmt::format("{} open edges, {} edges where a triangle is turned over and {} edges of more "
                            "than two triangles that do not face in pairs, expected a closed surface",
                            edges.openEdges, edges.twistedEdges, edges.overfullEdges));
}

bool hasThreeCorners(const TriangleIndices& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// How far in front of a triangle its surroundings are looked at, relative to the solid's diagonal. Thinner regions
/// enclose nothing of interest.
constexpr double kInFront = 1e-9;

/// Relative to the lengths involved: far more than rounding and a pose's defect. Used only in tests that save
/// time.
constexpr double kEnclosureSlack = 1e-9;

}  // namespace

Solid::Solid(const Mesh& mesh, const std::string& name) {
    CleanMesh cleaned = clean(mesh);
    vertices_ = std::move(cleaned.vertices);
    std::copy_if(cleaned.triangles.begin(), cleaned.triangles.end(), std::back_inserter(triangles_),
                 hasThreeCorners);
    if (triangles_.empty()) refuseSolid(name, "it has no triangle with three corners");
    const EdgeReport edges = requireClosed(triangles_, name);
    for (const Vector3& vertex : vertices_) box_.extend(vertex);
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    addNode(0, std::uint32_t(order_.size()), 0);
    orient(name);
    if (edges.touchingEdges > 0) lookInFront(name);
}

/// Where surfaces touch along edges, one connected surface may bound pieces that face different ways.
void Solid::lookInFront(const std::string& name) {
    const double step = (isTurnedOver_ ? -kInFront : kInFront) * box_.diagonal().norm();
    for (const auto& [a, b, c] : triangles_) {
        const Vector3 normal = (vertices_[b] - vertices_[a]).cross(vertices_[c] - vertices_[a]).normalized();
        const Vector3 middle = (vertices_[a] + vertices_[b] + vertices_[c]) / 3;
        const int inFront = winding({}, {}, middle + step * normal);
        hasWallInside_ = hasWallInside_ || inFront > 0;
        if (inFront < 0) {
            refuseSolid(name, "a part of its surface faces the other way than the rest, near " +
                                  roundedPoint(middle) + ", expected all to face one way");
        }
    }
}

void Solid::addNode(std::uint32_t first, std::uint32_t last, int axis) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Node node{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}, -kInfinity, first, last, 0};
    for (std::uint32_t i = first; i < last; ++i) {
        for (const std::uint32_t corner : triangles_[order_[i]]) {
            const Vector3& v = vertices_[corner];
            for (int k = 0; k < 2; ++k) {
                node.min[k] = std::min(node.min[k], v[k]);
                node.max[k] = std::max(node.max[k], v[k]);
            }
            node.top = std::max(node.top, v.z());
        }
    }
    const std::size_t here = nodes_.size();
    nodes_.push_back(node);
    if (last - first <= kLeafSize) return;
    const std::uint32_t middle = first + (last - first) / 2;
    const auto place = [&](std::uint32_t t) {
        const TriangleIndices& c = triangles_[t];
        return vertices_[c[0]][axis] + vertices_[c[1]][axis] + vertices_[c[2]][axis];
    };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    addNode(first, middle, 1 - axis);
    nodes_[here].right = std::uint32_t(nodes_.size());
    addNode(middle, last, 1 - axis);
}

template <class Take>
void Solid::eachCrossing(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point,
                         const Take& take) const {
    const ZRay ray(X_aMesh, X_aPoint, point);
    const Vector3& p = ray.origin();
    const double slack = ray.originError();
    std::array<std::uint32_t, kDeepest> open;
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
        const std::uint32_t here = open[--count];
        const Node& node = nodes_[here];
        const bool isMissed = p.x() < node.min[0] - slack || p.x() > node.max[0] + slack ||
                              p.y() < node.min[1] - slack || p.y() > node.max[1] + slack ||
                              p.z() > node.top + slack;
        if (isMissed) continue;
        if (node.right != 0) {
            open[count++] = node.right;
            open[count++] = here + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i) {
            const TriangleIndices& c = triangles_[order_[i]];
            const int sign = ray.crossing({&vertices_[c[0]], &vertices_[c[1]], &vertices_[c[2]]});
            if (sign != 0) take(order_[i], sign);
        }
    }
}

int Solid::winding(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point) const {
    int sum = 0;
    eachCrossing(X_aMesh, X_aPoint, point, [&](std::uint32_t, int sign) { sum += sign; });
    return isTurnedOver_ ? -sum : sum;
}

/// Whether a vertex of the shell is inside no other shell. Looks at all vertices, because shells may pierce
/// each other.
bool Solid::isOutermost(const Shells& shells, std::uint32_t shell) const {
    if (shells.count == 1) return true;
    std::vector<bool> isSeen(vertices_.size(), false);
    std::vector<int> windings(shells.count);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (shells.ofTriangle[t] != shell) continue;
        for (const std::uint32_t corner : triangles_[t]) {
            if (isSeen[corner]) continue;
            isSeen[corner] = true;
            std::fill(windings.begin(), windings.end(), 0);
            eachCrossing({}, {}, vertices_[corner], [&](std::uint32_t crossed, int sign) {
                windings[shells.ofTriangle[crossed]] += sign;
            });
            windings[shell] = 0;  // the vertex lies on this shell
            const auto isZero = [](int winding) { return winding == 0; };
            if (std::all_of(windings.begin(), windings.end(), isZero)) return true;
        }
    }
    return false;
}

void Solid::orient(const std::string& name) {
    const Shells shells = findShells(triangles_);
    const std::vector<double> volumes = signedVolumes(vertices_, triangles_, shells);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (shells.ofTriangle[t] == shellVertices_.size()) {
            shellVertices_.push_back(vertices_[triangles_[t][0]]);
        }
    }
    std::size_t outward = 0, inward = 0;
    for (std::uint32_t shell = 0; shell < shells.count; ++shell) {
        if (volumes[shell] != 0 && isOutermost(shells, shell)) ++(volumes[shell] > 0 ? outward : inward);
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
    for (std::size_t i = 0; i < components.size(); ++i) {
        names_.push_back(components[i].name.empty() ? "unnamed" : components[i].name);
        if (components[i].triangleCount == 0) continue;
        const Mesh component = meshOfComponents(mesh, {i});
        addPieces(component, i);
        try {
            Solid solid(component, names_[i]);
            if (solid.isTurnedOver()) turnedOver_.push_back(names_[i]);
            solids_.push_back({std::move(solid), i});
        } catch (const std::invalid_argument& refusal) {
            refusals_.push_back(refusal.what());
        }
    }
    Box box;
    for (const Piece& piece : pieces_) box.extend(piece.vertex);
    if (box.isEmpty()) return;
    centre_ = box.center();
    for (const Piece& piece : pieces_) radius_ = std::max(radius_, (piece.vertex - centre_).norm());
}

void Solids::addPieces(const Mesh& component, std::size_t number) {
    const CleanMesh cleaned = clean(component);
    const Shells shells = findShells(cleaned.triangles);
    std::uint32_t next = 0;
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        if (shells.ofTriangle[t] != next) continue;
        pieces_.push_back({cleaned.vertices[cleaned.triangles[t][0]], number});
        ++next;
    }
}

std::optional<Solids::Enclosure> Solids::holding(const Pose& X_aThis, const Solids& inner,
                                                 const Pose& X_aInner) const {
    const Pose X_thisInner = inverse(X_aThis) * X_aInner;
    const Vector3 centre = X_thisInner * inner.centre_;
    const double sizes = centre.norm() + inner.centre_.norm() + inner.radius_ + X_aThis.translation.norm() +
                         X_aInner.translation.norm();
    const double slack = kEnclosureSlack * sizes, reach = inner.radius_ + slack;
    for (const NamedSolid& outer : solids_) {
        const Box& box = outer.solid.box();
        if (box.squaredExteriorDistance(centre) > reach * reach) continue;
        const Box near(box.min().array() - slack, box.max().array() + slack);
        for (const Piece& piece : inner.pieces_) {
            if (!near.contains(X_thisInner * piece.vertex)) continue;
            if (outer.solid.winding(X_aThis, X_aInner, piece.vertex) <= 0) continue;
            return Enclosure{&names_[outer.component], &inner.names_[piece.component]};
        }
    }
    return std::nullopt;
}

MadeSolids makeSolids(const Mesh& mesh) {
    auto solids = std::make_shared<const Solids>(mesh);
    return {solids, solids->refusals(), solids->turnedOver()};
}

}  // namespace clearway
