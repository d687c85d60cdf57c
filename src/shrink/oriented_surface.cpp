#include "shrink/oriented_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "mesh/clean.h"
#include "mesh/components.h"
#include "model/solids.h"

namespace clearway {
namespace {

constexpr double kTurn = 6.283185307179586;

/// The sides of one edge, half of which lead one way and half the other way.
class EdgeSides {
  public:
    EdgeSides(const OrientedSurface& surface, const std::vector<std::uint32_t>& sides) : sides_(sides) {
        const Vector3& origin = surface.vertices[surface.from(sides[0])];
        const Vector3 along = (surface.vertices[surface.to(sides[0])] - origin).normalized();
        const Vector3 x = along.unitOrthogonal(), y = along.cross(x);
        for (const std::uint32_t side : sides) {
            const Vector3 apex = surface.vertices[surface.to(OrientedSurface::nextSide(side))] - origin;
            angles_.push_back(std::atan2(y.dot(apex), x.dot(apex)));
            isAlong_.push_back(surface.from(side) == surface.from(sides[0]));
        }
    }

    /// Pairs the sides with the least wedge of material first: it begins, in the sense of the first side's direction, at a triangle
    /// whose side leads back.
    void pair(std::vector<std::uint32_t>& across) const {
        std::vector<std::tuple<double, std::size_t, std::size_t>> wedges;
        for (std::size_t back = 0; back < sides_.size(); ++back) {
            for (std::size_t along = 0; along < sides_.size(); ++along) {
                if (isAlong_[back] || !isAlong_[along]) continue;
                const double wedge = angles_[along] - angles_[back];
                wedges.emplace_back(wedge < 0 ? wedge + kTurn : wedge, back, along);
            }
        }
        std::sort(wedges.begin(), wedges.end());
        std::vector<bool> isPaired(sides_.size(), false);
        for (const auto& [wedge, back, along] : wedges) {
            if (isPaired[back] || isPaired[along]) continue;
            isPaired[back] = isPaired[along] = true;
            across[sides_[back]] = sides_[along];
            across[sides_[along]] = sides_[back];
        }
    }

  private:
    const std::vector<std::uint32_t>& sides_;
    std::vector<double> angles_;  ///< of the triangles about the edge
    std::vector<bool> isAlong_;
};

/// Divides a face whose edges have more vertices on them. Cuts off the corner with the least area again and again; corners on an edge
/// have none.
class FaceDivision {
  public:
    FaceDivision(const std::vector<Vector3>& vertices, std::vector<std::uint32_t> around)
        : vertices_(vertices), around_(std::move(around)) {}

    template <class Take>
    void run(const Take& take) {
        while (around_.size() > 3) {
            std::size_t best = 0;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < around_.size(); ++i) {
                const double area = areaAt(i);
                if (area >= least) continue;
                least = area;
                best = i;
            }
            take(TriangleIndices{at(best + around_.size() - 1), at(best), at(best + 1)});
            around_.erase(around_.begin() + static_cast<std::ptrdiff_t>(best));
        }
        take(TriangleIndices{at(0), at(1), at(2)});
    }

  private:
    std::uint32_t at(std::size_t i) const { return around_[i % around_.size()]; }

    /// Infinite for a corner on an edge.
    double areaAt(std::size_t i) const {
        constexpr double kStraight = 1e-9;
        const Vector3 &a = vertices_[at(i + around_.size() - 1)], &b = vertices_[at(i)],
                      &c = vertices_[at(i + 1)];
        const Vector3 one = b - a, two = c - b;
        const double area = one.cross(two).norm();
        return area > kStraight * one.norm() * two.norm() ? area : std::numeric_limits<double>::infinity();
    }

    const std::vector<Vector3>& vertices_;
    std::vector<std::uint32_t> around_;
};

}  // namespace

void OrientedSurface::findNeighbours() {
    across.assign(3 * triangles.size(), 0);
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    const auto edgeOf = [&](std::uint32_t side) { return Edge(std::minmax({from(side), to(side)})); };
    std::vector<std::uint32_t> order(across.size());
    for (std::uint32_t side = 0; side < order.size(); ++side) order[side] = side;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(edgeOf(a), a) < std::pair(edgeOf(b), b);
    });
    std::vector<std::uint32_t> sides;
    for (std::size_t first = 0; first < order.size();) {
        sides.clear();
        const Edge edge = edgeOf(order[first]);
        while (first < order.size() && edgeOf(order[first]) == edge) sides.push_back(order[first++]);
        if (sides.size() == 2) {
            across[sides[0]] = sides[1];
            across[sides[1]] = sides[0];
        } else {
            EdgeSides(*this, sides).pair(across);
        }
    }
}

OrientedSurface withCutCorners(const OrientedSurface& surface, const std::vector<double>& reach) {
    OrientedSurface cut;
    cut.vertices = surface.vertices;
    constexpr std::uint32_t kNone = 0;
    std::vector<std::uint32_t> beside(surface.across.size(),
                                      kNone);  // the vertex near the beginning of a side
    for (std::uint32_t side = 0; side < beside.size(); ++side) {
        const std::uint32_t back = surface.across[side];
        for (const auto& [one, other] : {std::pair(side, back), std::pair(back, side)}) {
            if (side > back) break;
            const std::uint32_t vertex = surface.from(one);
            const Vector3 edge = surface.vertices[surface.to(one)] - surface.vertices[vertex];
            if (reach[vertex] == 0 || !(edge.norm() >= 2 * reach[vertex])) continue;
            beside[one] = static_cast<std::uint32_t>(cut.vertices.size());
            cut.vertices.push_back(surface.vertices[vertex] + reach[vertex] / edge.norm() * edge);
        }
    }
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const auto take = [&](const TriangleIndices& triangle) {
            cut.triangles.push_back(triangle);
            cut.given.push_back(surface.given[t]);
        };
        std::vector<std::uint32_t> around;
        for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
            const std::uint32_t after = beside[side],
                                before = beside[surface.across[OrientedSurface::previousSide(side)]];
            // Sides that meet at a vertex have both their new vertices named by the side that leaves it.
            if (after != kNone && before != kNone) {
                take({before, surface.from(side), after});
                around.insert(around.end(), {before, after});
                continue;
            }
            if (before != kNone) around.push_back(before);
            around.push_back(surface.from(side));
            if (after != kNone) around.push_back(after);
        }
        FaceDivision(cut.vertices, around).run(take);
    }
    cut.findNeighbours();
    return cut;
}

OrientedSurface orientedSurface(const Mesh& part) {
    OrientedSurface surface;
    const std::vector<Component> components = componentsOf(part);
    std::vector<CleanMesh> cleaned = cleanComponents(part);
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (components[i].triangleCount == 0) continue;
        Mesh mesh;
        mesh.vertices = std::move(cleaned[i].vertices);
        mesh.triangles = std::move(cleaned[i].triangles);
        const Solid solid(mesh, components[i].name.empty() ? "unnamed" : components[i].name);
        const auto base = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.insert(surface.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            auto [a, b, c] = mesh.triangles[t];
            if (a == b || b == c || c == a) continue;
            if (solid.isTurnedOver()) std::swap(b, c);
            surface.triangles.push_back({base + a, base + b, base + c});
            surface.given.push_back(cleaned[i].triangleIds[t] + components[i].firstTriangle);
        }
    }
    surface.findNeighbours();
    return surface;
}

}  // namespace clearway
