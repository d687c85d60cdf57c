#include "shrink/certificate.h"

#include <algorithm>

namespace clearway {
namespace {

constexpr int kMostCuts = 60;                   ///< of one prism
constexpr double kLeastTetrahedron = 1.0 / 60;  ///< of the most move
constexpr double kShorter = 0.7;                ///< a move that is not certified is shortened to this

using PlaceTetrahedron = std::array<Vector3, 4>;

class Certificate {
  public:
    Certificate(const OrientedSurface& surface, NearestTriangle& nearest,
                const OrientedSurface& nearestSurface, double most, const MovedSurface& moved)
        : surface_(surface), nearest_(nearest), nearestSurface_(nearestSurface), most_(most), moved_(moved) {}

    bool holds(const MovedTriangle& triangle) {
        std::array<Vector3, 3> from, to;
        bool isShort = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const MovedVertex& place = moved_.places[triangle.places[k]];
            from[k] = surface_.vertices[place.vertex];
            to[k] = from[k] + place.move;
            isShort = isShort && place.move.norm() <= most_;
        }
        if (isShort || isNearOneFace(triangle, to)) return true;
        const auto isTooFar = [&](const Vector3& point) { return nearest_.of(point).distance > most_; };
        if (isTooFar((to[0] + to[1] + to[2]) / 3) || std::any_of(to.begin(), to.end(), isTooFar))
            return false;
        // Neighbours have to cut the side that they share alike: by the order of the places.
        std::array<std::size_t, 3> order{0, 1, 2};
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return triangle.places[a] < triangle.places[b]; });
        const auto& [a, b, c] = order;
        cuts_ = kMostCuts;
        return isNear({from[a], from[b], from[c], to[c]}) && isNear({from[a], from[b], to[b], to[c]}) &&
               isNear({from[a], to[a], to[b], to[c]});
    }

  private:
    /// Whether one face that has the corners where the triangle came from is near enough to all places.
    bool isNearOneFace(const MovedTriangle& triangle, const std::array<Vector3, 3>& to) const {
        const auto isNearAll = [&](std::uint32_t face) {
            const Corners3 c = surface_.corners(face);
            return std::all_of(to.begin(), to.end(),
                               [&](const Vector3& place) { return distanceToTriangle(place, c) <= most_; });
        };
        const auto vertexOf = [&](std::size_t k) { return moved_.places[triangle.places[k]].vertex; };
        if (isNearAll(OrientedSurface::triangleOf(triangle.side))) return true;
        const bool isPatch = vertexOf(0) == vertexOf(1) && vertexOf(1) == vertexOf(2);
        const bool isStrip = !isPatch && (vertexOf(0) == vertexOf(1) || vertexOf(1) == vertexOf(2) ||
                                          vertexOf(2) == vertexOf(0));
        if (isStrip) return isNearAll(OrientedSurface::triangleOf(surface_.across[triangle.side]));
        if (!isPatch) return false;
        std::uint32_t side = triangle.side;
        do {
            if (isNearAll(OrientedSurface::triangleOf(side))) return true;
            side = surface_.across[OrientedSurface::previousSide(side)];
        } while (side != triangle.side);
        return false;
    }

    bool isNear(const PlaceTetrahedron& t) {
        if (cuts_-- <= 0) return false;
        const std::uint32_t triangle = nearest_.of(0.25 * (t[0] + t[1] + t[2] + t[3])).triangle;
        const Corners3 face = nearestSurface_.corners(triangle);
        std::size_t worst = 0;
        double farthest = -1;
        for (std::size_t k = 0; k < 4; ++k) {
            const double distance = distanceToTriangle(t[k], face);
            if (distance <= farthest) continue;
            farthest = distance;
            worst = k;
        }
        if (farthest <= most_) return true;
        std::size_t one = worst, other = worst;
        double share = 0.5;
        if (!cutBeside(t, face, worst, other, share)) {
            double longest = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t k = i + 1; k < 4; ++k) {
                    const double length = (t[k] - t[i]).norm();
                    if (length <= longest) continue;
                    longest = length;
                    one = i;
                    other = k;
                }
            }
            if (longest < kLeastTetrahedron * most_) return false;
        }
        const Vector3 cut = t[one] + share * (t[other] - t[one]);
        PlaceTetrahedron first = t, second = t;
        first[one] = cut;
        second[other] = cut;
        return isNear(first) && isNear(second);
    }

    /// Cuts an edge from the worst corner where it leaves the prism over the face, if another corner is within that side. Halves alone
    /// would be many, because faces may be a thousand times as large as moves.
    static bool cutBeside(const PlaceTetrahedron& t, const Corners3& face, std::size_t worst,
                          std::size_t& other, double& share) {
        const Vector3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
        double furthest = 0, most = 0;
        bool isCut = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3 beside = (face[(k + 1) % 3] - face[k]).cross(normal).normalized();
            const double beyond = beside.dot(t[worst] - face[k]);
            if (!(beyond > furthest)) continue;
            furthest = beyond;
            most = 0;
            isCut = false;
            for (std::size_t i = 0; i < 4; ++i) {
                const double within = -beside.dot(t[i] - face[k]);
                if (!(within > most)) continue;
                most = within;
                other = i;
                share = beyond / (beyond + within);
                isCut = true;
            }
        }
        constexpr double kLeast = 1e-6;  // a cut at an end cuts nothing
        return isCut && share > kLeast && share < 1 - kLeast;
    }

    const OrientedSurface& surface_;
    NearestTriangle& nearest_;
    const OrientedSurface& nearestSurface_;
    const double most_;
    const MovedSurface& moved_;
    int cuts_ = 0;
};

}  // namespace

std::vector<bool> certifyMoves(const OrientedSurface& surface, NearestTriangle& nearest,
                               const OrientedSurface& nearestSurface, double most, MovedSurface& moved) {
    std::vector<std::vector<std::uint32_t>> trianglesOf(moved.places.size());
    for (std::uint32_t t = 0; t < moved.triangles.size(); ++t) {
        for (const std::uint32_t place : moved.triangles[t].places) trianglesOf[place].push_back(t);
    }
    std::vector<bool> isShortened(moved.places.size(), false), isWaiting(moved.triangles.size(), true);
    std::vector<std::uint32_t> waiting(moved.triangles.size());
    for (std::uint32_t t = 0; t < waiting.size(); ++t) waiting[t] = t;
    Certificate certificate(surface, nearest, nearestSurface, most, moved);
    while (!waiting.empty()) {
        const std::uint32_t t = waiting.back();
        waiting.pop_back();
        isWaiting[t] = false;
        if (certificate.holds(moved.triangles[t])) continue;
        const auto& places = moved.triangles[t].places;
        const std::uint32_t worst =
            *std::max_element(places.begin(), places.end(), [&](std::uint32_t a, std::uint32_t b) {
                return moved.places[a].move.norm() < moved.places[b].move.norm();
            });
        Vector3& move = moved.places[worst].move;
        const double length = move.norm();
        constexpr double kJustWithin = 1 - 1e-12;
        move *= std::max(kShorter, kJustWithin * most / length);
        isShortened[worst] = true;
        for (const std::uint32_t again : trianglesOf[worst]) {
            if (isWaiting[again]) continue;
            isWaiting[again] = true;
            waiting.push_back(again);
        }
    }
    return isShortened;
}

}  // namespace clearway
