// Cuts the part's shrunk surface through tetrahedra, and bisects those in which a bound on depths fails.
#include "clearway/shrink.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/number.h"
#include "isosurface/cut_surface.h"
#include "isosurface/polytope.h"
#include "isosurface/tetrahedra.h"
#include "shrink/left_out.h"
#include "shrink/surface_depth.h"

namespace clearway {
namespace {

constexpr std::size_t kMostVertices = 8'000'000;
constexpr std::size_t kBlock =
    256;  ///< items that one thread takes with one warm start, so that threads change nothing
constexpr double kLevel = 0.2;   ///< of the tolerance, above the overlap: where the surface is meant to be
constexpr int kMostPieces = 24;  ///< in which the outside part of a tetrahedron is looked at
constexpr double kLeastSize = 0.02;    ///< of the tolerance: the edges of tetrahedra
constexpr double kMostShallow = 0.15;  ///< of the tolerance: how far above its level the surface may lie
constexpr double kMostDeep = 0.7;      ///< of the tolerance: how far below

using Outlines = std::vector<std::vector<CutEdge>>;

class Shrinking {
  public:
    Shrinking(const SurfaceDepth& surface, const ShrinkOptions& options)
        : surface_(surface),
          tetrahedra_(surface_.model().box()),
          least_(options.overlap),
          most_(options.overlap + options.tolerance - surface_.slack() - surface_.rounding()),
          level_(options.overlap + kLevel * (options.tolerance - surface_.slack())),
          tolerance_(options.tolerance - surface_.slack()) {}

    Mesh run() {
        open_.resize(tetrahedra_.all().size());
        std::iota(open_.begin(), open_.end(), std::size_t(0));
        for (;;) {
            const std::size_t known = places_.size();
            refine();
            open_ = tetrahedraWithVertices(known);
            isDeep_.resize(tetrahedra_.all().size());
            for (const std::size_t i : open_) isDeep_[i] = false;
            if (!open_.empty()) continue;
            CutSurface cut = cutSurface(tetrahedra_, heights_);
            if (cut.mesh.triangles.empty()) return {};
            if (bisectWhereShallow(cut)) continue;
            return std::move(cut.mesh);
        }
    }

  private:
    /// Bisects open tetrahedra until none is left.
    void refine() {
        std::vector<std::uint8_t> isSettled;
        while (!open_.empty()) {
            measureNewVertices();
            auto& all = tetrahedra_.all();
            isSettled.assign(open_.size(), 0);
            forBlocks(0, open_.size(), [&](std::size_t i, Workspace& workspace) {
                Tetrahedron& tetrahedron = all[open_[i]];
                isSettled[i] = settles(tetrahedron, workspace);
                tetrahedron.isShallow = tetrahedron.isShallow || (isSettled[i] && isOutside(tetrahedron));
            });
            std::vector<std::size_t> next;
            for (std::size_t i = 0; i < open_.size(); ++i) {
                if (!isSettled[i]) bisect(open_[i], next);
            }
            open_ = std::move(next);
            if (tetrahedra_.vertices().size() > kMostVertices) refuseSize();
        }
    }

    /// The tetrahedra with new vertices on their edges or faces, whose numbers begin with `first`.
    std::vector<std::size_t> tetrahedraWithVertices(std::size_t first) {
        if (first == places_.size()) return {};
        const auto& all = tetrahedra_.all();
        std::vector<std::uint8_t> hasNew(all.size());
        forBlocks(0, all.size(), [&](std::size_t i, Workspace&) {
            for (const std::uint32_t v : tetrahedra_.verticesOn(all[i])) hasNew[i] = hasNew[i] || v >= first;
        });
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (hasNew[i]) found.push_back(i);
        }
        return found;
    }

    bool isOutside(const Tetrahedron& tetrahedron) const {
        return std::all_of(tetrahedron.corners.begin(), tetrahedron.corners.end(),
                           [&](std::uint32_t v) { return heights_[v] < 0; });
    }

    [[noreturn]] void refuseSize() const {
        throw std::invalid_argument("overlap is " + roundedNumber(least_) + " with the tolerance " +
                                    roundedNumber(tolerance_) + ", which takes more than " +
                                    std::to_string(kMostVertices) +
                                    " points in the part, expected a larger overlap or overlap.tolerance");
    }

    template <class Work>
    void forBlocks(std::size_t first, std::size_t end, const Work& work) {
        tbb::parallel_for(std::size_t(0), (end - first + kBlock - 1) / kBlock, [&](std::size_t block) {
            Workspace& workspace = workspaces_.local();
            workspace.forgetWarmStart();
            const std::size_t from = first + block * kBlock, to = std::min(end, from + kBlock);
            for (std::size_t i = from; i < to; ++i) work(i, workspace);
        });
    }

    void measureNewVertices() {
        const std::size_t first = places_.size();
        const auto& vertices = tetrahedra_.vertices();
        places_.resize(vertices.size());
        heights_.resize(vertices.size());
        forBlocks(first, vertices.size(), [&](std::size_t i, Workspace& workspace) {
            places_[i] = surface_.at(vertices[i], workspace);
            heights_[i] = places_[i].depth - level_;
        });
    }

    /// Whether no point of the tetrahedron outside the cut surface is too deep, and whether the cut is near its
    /// level.
    bool settles(const Tetrahedron& tetrahedron, Workspace& workspace) const {
        const auto& c = tetrahedron.corners;
        requireContinuity(c);
        const std::vector<std::uint32_t> others = tetrahedra_.verticesOn(tetrahedron);
        const auto isInside = [&](std::uint32_t v) { return heights_[v] >= 0; };
        const bool hasInside =
            std::any_of(c.begin(), c.end(), isInside) || std::any_of(others.begin(), others.end(), isInside);
        const bool isAllInside =
            std::all_of(c.begin(), c.end(), isInside) && std::all_of(others.begin(), others.end(), isInside);
        if (isAllInside) return true;
        const bool isCut = hasInside;
        const auto outlines = isCut ? outlinesIn(tetrahedra_, tetrahedron, heights_) : Outlines{};
        if (isCut && (outlines.size() > 1 || !isCutNearLevel(outlines[0], workspace))) return false;
        if (tetrahedron.isShallow || isShallowBySize(c)) return true;
        const Polytope whole({vertex(c[0]), vertex(c[1]), vertex(c[2]), vertex(c[3])});
        const Polytope outside = isCut ? whole.cut(below(c, outlines[0], others)) : whole;
        if (isCovered(outside, workspace)) return true;
        const bool mayBeOutside =
            std::any_of(c.begin(), c.end(), [&](std::uint32_t v) { return places_[v].depth < 0; });
        if (!mayBeOutside) return false;
        if (!isCut && isOutsideIn(
                          whole, c, [](const Vector3&) { return 1.0; }, workspace))
            return true;
        std::uint32_t last = ~0u;
        for (const std::uint32_t v : c) {
            const std::uint32_t triangle = places_[v].triangle;
            if (triangle == last) continue;
            last = triangle;
            if (isShallowBelowPlane(whole, outside, c, triangle, workspace)) return true;
        }
        return false;
    }

    const Vector3& vertex(std::uint32_t number) const { return tetrahedra_.vertices()[number]; }

    Vector3 pointOf(const CutEdge& edge) const {
        return cutPoint(vertex(edge.inner), heights_[edge.inner], vertex(edge.outer), heights_[edge.outer]);
    }

    bool isCutNearLevel(const std::vector<CutEdge>& outline, Workspace& workspace) const {
        Vector3 sum = Vector3::Zero();
        for (const CutEdge& edge : outline) sum += pointOf(edge);
        const double depth = surface_.at(sum / double(outline.size()), workspace).depth;
        return depth >= level_ - kMostShallow * tolerance_ && depth <= level_ + kMostDeep * tolerance_;
    }

    /// The values at a tetrahedron's corners of a linear function that is at least 0 at all its points outside the cut
    /// surface. Those lie in the convex hull of the outer vertices on it and of the surface's outline.
    std::vector<double> below(const std::array<std::uint32_t, 4>& c, const std::vector<CutEdge>& outline,
                              const std::vector<std::uint32_t>& others) const {
        Matrix3 edges;
        Vector3 rises;
        for (int k = 0; k < 3; ++k) {
            edges.row(k) = vertex(c[k + 1]) - vertex(c[0]);
            rises[k] = heights_[c[k + 1]] - heights_[c[0]];
        }
        const Vector3 slope = edges.inverse() * rises;
        double most = 0;
        const auto include = [&](const Vector3& point) {
            most = std::max(most, heights_[c[0]] + slope.dot(point - vertex(c[0])));
        };
        for (const CutEdge& edge : outline) include(pointOf(edge));
        for (const std::uint32_t v : others) {
            if (heights_[v] < 0) include(vertex(v));
        }
        const double rounding = 1e-9 * rises.cwiseAbs().sum();
        std::vector<double> values;
        for (const std::uint32_t v : c) values.push_back(most + rounding - heights_[v]);
        return values;
    }

    /// Depths change no faster than places.
    bool isShallowBySize(const std::array<std::uint32_t, 4>& c) const {
        for (int i = 0; i < 4; ++i) {
            double reach = 0;
            for (int j = 0; j < 4; ++j) reach = std::max(reach, (vertex(c[j]) - vertex(c[i])).norm());
            if (places_[c[i]].depth + reach <= most_) return true;
        }
        return false;
    }

    /// Whether each point is near enough to some triangle. The distance to one triangle is convex, so corners
    /// decide. Cuts off what is beside the triangle nearest to the centre and looks at it apart.
    bool isCovered(Polytope piece, Workspace& workspace) const {
        int pieces = kMostPieces;
        return isCovered(std::move(piece), workspace, pieces);
    }

    bool isCovered(Polytope piece, Workspace& workspace, int& pieces) const {
        if (pieces-- == 0 || !piece.isSimple()) return false;
        const std::uint32_t triangle = surface_.nearest(piece.centre(), workspace);
        const Corners3 corners = surface_.corners(triangle);
        if (distanceToTriangle(piece.centre(), corners) > most_) return false;
        const auto isNear = [&] {
            return std::all_of(piece.corners().begin(), piece.corners().end(),
                               [&](const Polytope::Corner& corner) {
                                   return distanceToTriangle(corner.point, corners) <= most_;
                               });
        };
        if (isNear()) return true;
        const Vector3 normal = surface_.outwardNormal(triangle);
        const double turned =
            normal.dot((corners[1] - corners[0]).cross(corners[2] - corners[0])) < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) {
            const Vector3 across = turned * (corners[(k + 1) % 3] - corners[k]).cross(normal).normalized();
            const auto height = [&](const Vector3& p) {
                const double exact = across.dot(p - corners[k]);
                return std::abs(exact) <= surface_.rounding() ? 0.0 : exact;
            };
            Polytope beside = piece.above(height);
            if (beside.isFlat(height)) continue;
            piece = piece.above([&](const Vector3& p) { return -height(p); });
            if (piece.isEmpty() || !isCovered(std::move(beside), workspace, pieces)) return false;
        }
        return isNear();
    }

    /// Whether all points of the outside part are near enough to triangles, except for those in front of the
    /// triangle's plane, which lie outside the part.
    bool isShallowBelowPlane(const Polytope& whole, const Polytope& outside,
                             const std::array<std::uint32_t, 4>& c, std::uint32_t triangle,
                             Workspace& workspace) const {
        const Vector3 normal = surface_.outwardNormal(triangle).normalized();
        if (!(normal.squaredNorm() > 0)) return false;
        const Vector3 base = surface_.corners(triangle)[0];
        const double front = 0.5 * least_;  // any height from 0 to most_ is right
        const auto height = [&](const Vector3& p) { return normal.dot(p - base) - front; };
        Polytope low = outside.above([&](const Vector3& p) { return -height(p); });
        if (!low.isEmpty() && !isCovered(std::move(low), workspace)) return false;
        const Polytope high = whole.above(height);
        return high.isEmpty() || isOutsideIn(high, c, height, workspace);
    }

    /// Whether a piece of a tetrahedron with the corners c, the one with height >= 0, lies outside the part: some
    /// corner does, and the surface has no point in the piece.
    template <class Height>
    bool isOutsideIn(const Polytope& piece, const std::array<std::uint32_t, 4>& c, const Height& height,
                     Workspace& workspace) const {
        const bool hasOutside = std::any_of(c.begin(), c.end(), [&](std::uint32_t v) {
            return places_[v].depth < 0 && height(vertex(v)) >= 0;
        });
        if (!hasOutside) return false;
        const Mesh mesh = piece.surface();
        if (mesh.triangles.empty()) return false;
        const Box box = boundingBox(mesh);
        for (const Vector3& v : surface_.shellVertices()) {
            if (box.contains(v)) return false;
        }
        return !isWithin(Model::build(mesh), surface_.model(), {}, surface_.rounding(), workspace);
    }

    /// Bisects the tetrahedra in which the cut surface is too near the part's surface. Only triangles in
    /// tetrahedra that are new since the last call are looked at.
    bool bisectWhereShallow(const CutSurface& cut) {
        isDeep_.resize(tetrahedra_.all().size());
        std::vector<std::size_t> unknown;
        for (std::size_t i = 0; i < cut.tetrahedra.size(); ++i) {
            if (!isDeep_[cut.tetrahedra[i]]) unknown.push_back(i);
        }
        std::vector<std::uint8_t> isTooNear(unknown.size());
        forBlocks(0, unknown.size(), [&](std::size_t i, Workspace& workspace) {
            Mesh triangle;
            for (const std::uint32_t v : cut.mesh.triangles[unknown[i]])
                triangle.vertices.push_back(cut.mesh.vertices[v]);
            triangle.triangles = {{0, 1, 2}};
            isTooNear[i] = isWithin(Model::build(triangle), surface_.model(), {}, least_, workspace);
        });
        for (const std::size_t i : unknown) isDeep_[cut.tetrahedra[i]] = true;
        for (std::size_t i = 0; i < unknown.size(); ++i) {
            const std::uint32_t t = cut.tetrahedra[unknown[i]];
            if (!isTooNear[i] || !isDeep_[t]) continue;
            isDeep_[t] = false;
            bisect(t, open_);
        }
        return !open_.empty();
    }

    /// Depths change no faster than places, except in gaps that count as filled. So tetrahedra need not be smaller
    /// than a tenth of the tolerance either.
    void requireContinuity(const std::array<std::uint32_t, 4>& c) const {
        const double most = 2 * surface_.slack() + 100 * surface_.rounding();
        double longest = 0;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                const double length = (vertex(c[i]) - vertex(c[j])).norm();
                longest = std::max(longest, length);
                if (std::abs(heights_[c[i]] - heights_[c[j]]) > length + most) refusePlace(vertex(c[i]));
            }
        }
        if (longest < kLeastSize * tolerance_) refusePlace(vertex(c[0]));
    }

    [[noreturn]] void refusePlace(const Vector3& place) const {
        throw std::invalid_argument("overlap is " + roundedNumber(least_) + " with the tolerance " +
                                    roundedNumber(tolerance_) + ", and near " + roundedPoint(place) +
                                    " it is unclear what is inside the part, expected surfaces that do not "
                                    "run into themselves there, or another overlap.tolerance");
    }

    void bisect(std::size_t tetrahedron, std::vector<std::size_t>& halves) {
        halves.push_back(tetrahedron);
        halves.push_back(tetrahedra_.all().size());
        tetrahedra_.bisect(tetrahedron);
    }

    const SurfaceDepth& surface_;
    Tetrahedra tetrahedra_;
    double least_, most_, level_, tolerance_;
    std::vector<std::size_t> open_;  ///< tetrahedra to look at
    std::vector<bool> isDeep_;       ///< of tetrahedra: the cut in it is deep enough, by exact queries
    std::vector<SurfaceDepth::Place> places_;  ///< of the vertices
    std::vector<double> heights_;              ///< of the vertices: depth above the level
    mutable tbb::enumerable_thread_specific<Workspace> workspaces_;
};

void requirePositive(double value, const char* name) {
    if (value > 0 && std::isfinite(value)) return;
    throw std::invalid_argument(std::string(name) + " is " + shortNumber(value) +
                                ", expected a finite number above 0");
}

/// The cut surface keeps its distance from the part's surface. So one vertex tells whether a whole shell of
/// it is inside, and one vertex of the part's shell whether that shell is outside the shrunk part.
void requireInside(const Mesh& shrunk, const SurfaceDepth& surface) {
    const Solid solid(shrunk, "the shrunk part");
    const auto& cut = solid.shellVertices();
    const std::vector<Vector3> part = surface.surfacePoints();
    const bool isInside = !solid.isTurnedOver() && std::all_of(cut.begin(), cut.end(), [&](const Vector3& v) {
        return surface.isInside(v);
    }) && std::all_of(part.begin(), part.end(), [&](const Vector3& v) {
        return solid.winding({}, {}, v) == 0;
    });
    if (!isInside) {
        throw std::invalid_argument(
            "the shrunk part is not inside the part, whose surface may pass through itself");
    }
}

std::vector<std::uint32_t> nearestTriangles(const SurfaceDepth& surface, const Mesh& shrunk) {
    std::vector<std::uint32_t> nearest;
    Workspace workspace;
    for (const auto& [a, b, c] : shrunk.triangles) {
        const Vector3 sum = shrunk.vertices[a] + shrunk.vertices[b] + shrunk.vertices[c];
        nearest.push_back(surface.partTriangle(surface.nearest(sum / 3, workspace)));
    }
    return nearest;
}

}  // namespace

ShrunkPart shrink(const Mesh& part, const ShrinkOptions& options) {
    requirePositive(options.overlap, "overlap");
    requirePositive(options.tolerance, "overlap.tolerance");
    const SurfaceDepth surface(part, kJoinFineness * options.tolerance);
    ShrunkPart shrunk;
    shrunk.options = options;
    shrunk.mesh = Shrinking(surface, options).run();
    if (shrunk.mesh.triangles.empty()) {
        throw std::invalid_argument("overlap is " + roundedNumber(options.overlap) + " with the tolerance " +
                                    roundedNumber(options.tolerance) +
                                    ", which leaves nothing of the part, expected smaller ones");
    }
    shrunk.mesh.origin = part.origin;
    shrunk.mesh.components = {{surface.pieceCount() == 1 ? surface.piece(0).name : "part", 0,
                               static_cast<std::uint32_t>(shrunk.mesh.triangles.size())}};
    requireInside(shrunk.mesh, surface);
    shrunk.partTriangles = nearestTriangles(surface, shrunk.mesh);
    shrunk.leftOut = findLeftOut(surface, shrunk.mesh, options.overlap + options.tolerance);
    return shrunk;
}

std::shared_ptr<const ShrunkModel> shrunkModel(const ShrunkPart& shrunk, Model model) {
    return std::make_shared<const ShrunkModel>(ShrunkModel{std::move(model), makeSolids(shrunk.mesh).solids,
                                                           shrunk.options.overlap, shrunk.options.tolerance,
                                                           shrunk.partTriangles});
}

}  // namespace clearway
