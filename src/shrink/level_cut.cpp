// Cuts the surface through tetrahedra, and bisects those in which a bound on depths fails.
#include "shrink/level_cut.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/parallel.h"
#include "isosurface/cut_surface.h"
#include "isosurface/polytope.h"
#include "isosurface/tetrahedra.h"
#include "shrink/concave_edges.h"
#include "shrink/depth_limit.h"
#include "shrink/level_points.h"

namespace clearway {
namespace {

constexpr std::size_t kMostVertices = 8'000'000;
constexpr double kMostEstimated = 1e6;  ///< points: minutes of work
constexpr double kPointsPerTurn = 0.5;  ///< per radian and tolerance of concave edge; 0.6 were counted
constexpr std::size_t kCellBlock =
    256;  ///< items that one thread takes with one warm start, so that threads change nothing
constexpr double kLevel = 0.2;  ///< of the tolerance, above the overlap: where the surface is meant to be
constexpr double kLeastSize = 0.02;    ///< of the tolerance: the edges of tetrahedra
constexpr double kLevelError = 0.02;   ///< of the tolerance: how far from the level crossings may lie
constexpr double kMostShallow = 0.15;  ///< of the tolerance: how far above its level the surface may lie
constexpr double kMostDeep = 0.7;      ///< of the tolerance: how far below

using CutOutline = std::vector<CutEdge>;
using CellCorners = std::array<std::uint32_t, 4>;

class LevelCut {
  public:
    LevelCut(const SurfaceDepth& surface, const ShrinkOptions& options)
        : surface_(surface),
          tetrahedra_(surface_.model().box()),
          least_(options.overlap),
          tolerance_(options.tolerance - surface_.slack()),
          level_(options.overlap + kLevel * tolerance_),
          limit_(surface, options.overlap + tolerance_ - surface_.rounding(), 0.5 * options.overlap),
          points_(surface, level_, kLevelError * tolerance_),
          isStopped_(options.isStopped) {
        requireFewPoints();
        Workspace workspace;
        for (const Vector3& vertex : surface.shellVertices()) {
            if (surface.at(vertex, workspace).depth < level_) shellPoints_.push_back(vertex);
        }
    }

    Mesh run() {
        open_.resize(tetrahedra_.all().size());
        std::iota(open_.begin(), open_.end(), std::size_t(0));
        for (;;) {
            const std::size_t known = places_.size();
            refine();
            open_ = tetrahedra_.withVerticesFrom(known);
            if (open_.empty()) return std::move(cutThroughLevel().mesh);
        }
    }

  private:
    /// Bisects open tetrahedra until none is left.
    void refine() {
        std::vector<std::uint8_t> isSettled;
        while (!open_.empty()) {
            measureNewVertices();
            findOutlines();
            auto& all = tetrahedra_.all();
            amid_.resize(all.size());
            isSettled.assign(open_.size(), 0);
            forBlocks(0, open_.size(), [&](std::size_t i, Workspace& workspace) {
                Tetrahedron& tetrahedron = all[open_[i]];
                isSettled[i] = settles(open_[i], outlines_[i], workspace);
                const bool isShallow =
                    isSettled[i] && outlines_[i].empty() && heights_[tetrahedron.corners[0]] < 0;
                tetrahedron.isShallow = tetrahedron.isShallow || isShallow;
            });
            std::vector<std::size_t> next;
            for (std::size_t i = 0; i < open_.size(); ++i) {
                if (!isSettled[i]) bisect(open_[i], next);
            }
            open_ = std::move(next);
            if (tetrahedra_.vertices().size() > kMostVertices)
                refuseSize("more than " + std::to_string(kMostVertices),
                           "a larger overlap or overlap.tolerance");
        }
    }

    /// Refuses before the work what concave edges alone make too much of.
    void requireFewPoints() const {
        if (surface_.slack() > 0) return;  // edges of a component may lie within another one
        const double points =
            kPointsPerTurn * concaveLength(surface_, least_, kMostDeep * tolerance_) / tolerance_;
        if (points <= kMostEstimated) return;
        refuseSize("about " + roundedNumber(std::round(points / kMostEstimated)) + " million",
                   "an overlap.tolerance of at least " + roundedNumber(tolerance_ * points / kMostEstimated));
    }

    [[noreturn]] void refuseSize(const std::string& points, const std::string& expected) const {
        throw ArgumentError("overlap is " + roundedNumber(least_) + " with the tolerance " +
                            roundedNumber(tolerance_) + ", which takes " + points +
                            " points in the part, expected " + expected);
    }

    template <class Work>
    void forBlocks(std::size_t first, std::size_t end, const Work& work) {
        forEachInParallel((end - first + kCellBlock - 1) / kCellBlock, [&](std::size_t block) {
            if (isStopped_ && isStopped_()) throw ShrinkStopped("shrinking the part was stopped");
            Workspace& workspace = workspaces_.local();
            workspace.forgetWarmStart();
            const std::size_t from = first + block * kCellBlock, to = std::min(end, from + kCellBlock);
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

    /// Finds the outlines in open tetrahedra, and where they lie.
    void findOutlines() {
        outlines_.assign(open_.size(), {});
        forBlocks(0, open_.size(), [&](std::size_t i, Workspace&) {
            outlines_[i] = outlinesIn(tetrahedra_, tetrahedra_.all()[open_[i]], heights_);
        });
        std::vector<CutEdge> edges;
        std::vector<std::array<CutEdge, 2>> pairs;
        for (const auto& found : outlines_) {
            for (const CutOutline& outline : found) {
                for (std::size_t k = 0; k < outline.size(); ++k) {
                    const CutEdge &edge = outline[k], &next = outline[(k + 1) % outline.size()];
                    if (crossings_.try_emplace(keyOf(edge)).second) edges.push_back(edge);
                    if (creases_.try_emplace(keyOf(edge, next)).second) pairs.push_back({edge, next});
                }
            }
        }
        forBlocks(0, edges.size(), [&](std::size_t i, Workspace& workspace) {
            const auto end = [&](std::uint32_t v) { return LevelPoints::End{vertex(v), places_[v]}; };
            crossings_.at(keyOf(edges[i])) =
                points_.crossing(end(edges[i].outer), end(edges[i].inner), workspace);
        });
        forBlocks(0, pairs.size(), [&](std::size_t i, Workspace&) {
            const auto& [a, b] = pairs[i];
            creases_.at(keyOf(a, b)) = points_.crease(crossing(a), crossing(b), triangleOf(a, b));
        });
    }

    static std::uint64_t keyOf(const CutEdge& edge) { return (std::uint64_t(edge.inner) << 32) | edge.outer; }
    static std::pair<std::uint64_t, std::uint64_t> keyOf(const CutEdge& a, const CutEdge& b) {
        return std::minmax(keyOf(a), keyOf(b));
    }

    const LevelPoint& crossing(const CutEdge& edge) const { return crossings_.at(keyOf(edge)); }

    /// The triangle that has both edges.
    Corners3 triangleOf(const CutEdge& a, const CutEdge& b) const {
        return {vertex(a.inner), vertex(a.outer), vertex(a.inner == b.inner ? b.outer : b.inner)};
    }

    /// Whether certainly no point of the tetrahedron outside the cut surface is too deep, and the surface is near its
    /// level and nowhere too shallow.
    bool settles(std::size_t number, const std::vector<CutOutline>& outlines, Workspace& workspace) {
        const Tetrahedron& tetrahedron = tetrahedra_.all()[number];
        const CellCorners& c = tetrahedron.corners;
        requireContinuity(c);
        if (outlines.empty() && heights_[c[0]] >= 0) return !mayHoldShell(c);
        if (outlines.size() > 1) return false;  // their fillings might cross
        if (outlines.empty())
            return isShallow(tetrahedron, {Polytope(cornersOf(c))}, nearestTo(c), workspace);
        const CutOutline& outline = outlines[0];
        std::vector<LevelPoint> points;
        for (const CutEdge& edge : outline) points.push_back(crossing(edge));
        amid_[number] = points_.amid(points, cornersOf(c));
        if (!isNearLevel(amid_[number], workspace)) return false;
        const Mesh surface = surfaceIn(tetrahedron, outline, amid_[number]);
        std::vector<std::uint32_t> nearest = nearestTo(c);
        for (const LevelPoint& point : points) nearest.push_back(point.triangle);
        return isShallow(tetrahedron, outsideOf(tetrahedron, outline, amid_[number]), nearest, workspace) &&
               !isWithin(smallModel(surface), surface_.model(), {}, least_, workspace);
    }

    bool isShallow(const Tetrahedron& tetrahedron, const std::vector<Polytope>& pieces,
                   const std::vector<std::uint32_t>& nearest, Workspace& workspace) const {
        const CellCorners& c = tetrahedron.corners;
        if (tetrahedron.isShallow || isShallowBySize(c)) return true;
        const bool mayBeOutside =
            std::any_of(c.begin(), c.end(), [&](std::uint32_t v) { return places_[v].depth < 0; });
        const auto planes = mayBeOutside ? limit_.differentPlanes(nearest) : std::vector<std::uint32_t>();
        return std::all_of(pieces.begin(), pieces.end(),
                           [&](const Polytope& piece) { return limit_.holdsIn(piece, planes, workspace); });
    }

    std::vector<std::uint32_t> nearestTo(const CellCorners& c) const {
        return {places_[c[0]].triangle, places_[c[1]].triangle, places_[c[2]].triangle,
                places_[c[3]].triangle};
    }

    /// The cut surface in a tetrahedron, as cutThroughLevel() makes it.
    Mesh surfaceIn(const Tetrahedron& tetrahedron, const CutOutline& outline, const Vector3& amid) const {
        Mesh mesh;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            mesh.vertices.push_back(crossing(outline[k]).point);
            if (const auto& crease = creaseAfter(outline, k)) mesh.vertices.push_back(*crease);
        }
        const auto fill = filling(int(mesh.vertices.size()), isPlain(tetrahedron, outline));
        mesh.vertices.push_back(amid);
        for (const auto& [a, b, c] : fill)
            mesh.triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
        return mesh;
    }

    const std::optional<Vector3>& creaseAfter(const CutOutline& outline, std::size_t k) const {
        return creases_.at(keyOf(outline[k], outline[(k + 1) % outline.size()]));
    }

    bool isPlain(const Tetrahedron& tetrahedron, const CutOutline& outline) const {
        for (std::size_t k = 0; k < outline.size(); ++k) {
            if (creaseAfter(outline, k)) return false;
        }
        return tetrahedra_.hasWholeEdges(tetrahedron);
    }

    const Vector3& vertex(std::uint32_t number) const { return tetrahedra_.vertices()[number]; }

    std::array<Vector3, 4> cornersOf(const CellCorners& c) const {
        return {vertex(c[0]), vertex(c[1]), vertex(c[2]), vertex(c[3])};
    }

    /// Whether a vertex of a shell of the part is near, so that the tetrahedron may hold all of a cavity.
    bool mayHoldShell(const CellCorners& c) const {
        Box box;
        for (const std::uint32_t v : c) box.extend(vertex(v));
        return std::any_of(shellPoints_.begin(), shellPoints_.end(),
                           [&](const Vector3& v) { return box.contains(v); });
    }

    bool isNearLevel(const Vector3& point, Workspace& workspace) const {
        const double depth = surface_.at(point, workspace).depth;
        return depth >= level_ - kMostShallow * tolerance_ && depth <= level_ + kMostDeep * tolerance_;
    }

    /// The values at a tetrahedron's corners of a linear function that is at least 0 at all its points outside the cut
    /// surface: those lie in the convex hull of its outer corners and of the surface's outline.
    std::vector<double> below(const CellCorners& c, const CutOutline& outline) const {
        Matrix3 edges;
        Vector3 rises;
        for (int k = 0; k < 3; ++k) {
            edges.row(k) = vertex(c[k + 1]) - vertex(c[0]);
            rises[k] = heights_[c[k + 1]] - heights_[c[0]];
        }
        const Vector3 slope = edges.inverse() * rises;
        double most = 0;
        for (const CutEdge& edge : outline)
            most = std::max(most, heights_[c[0]] + slope.dot(crossing(edge).point - vertex(c[0])));
        const double rounding = 1e-9 * rises.cwiseAbs().sum();
        std::vector<double> values;
        for (const std::uint32_t v : c) values.push_back(most + rounding - heights_[v]);
        return values;
    }

    /// Convex pieces that cover what is outside the cut surface in a tetrahedron. If that consists of triangles around
    /// one point: the cones from that point over the outside of the tetrahedron's faces.
    std::vector<Polytope> outsideOf(const Tetrahedron& tetrahedron, const CutOutline& outline,
                                    const Vector3& amid) const {
        if (isPlain(tetrahedron, outline))
            return {Polytope(cornersOf(tetrahedron.corners)).cut(below(tetrahedron.corners, outline))};
        std::vector<Polytope> cones;
        tetrahedra_.eachPiece(tetrahedron, [&](const TriangleIndices& piece) {
            const std::vector<Vector3> polygon = outsideOf(piece);
            for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
                cones.emplace_back(std::array<Vector3, 4>{amid, polygon[0], polygon[k], polygon[k + 1]});
        });
        return cones;
    }

    /// The outside of a triangle: a polygon of which triangles around its first corner make up all.
    std::vector<Vector3> outsideOf(const TriangleIndices& triangle) const {
        std::vector<Vector3> polygon;
        std::size_t first = 0;
        CutEdge leaving{}, entering{};
        bool isCut = false;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
            const bool isInner = heights_[from] >= 0, isNextInner = heights_[to] >= 0;
            if (!isInner) polygon.push_back(vertex(from));
            if (isInner == isNextInner) continue;
            isCut = true;
            if (isInner) first = polygon.size();
            (isInner ? leaving : entering) = isInner ? CutEdge{from, to} : CutEdge{to, from};
            polygon.push_back(crossing(isInner ? leaving : entering).point);
        }
        std::rotate(polygon.begin(), polygon.begin() + first, polygon.end());
        if (!isCut) return polygon;
        if (const auto& crease = creases_.at(keyOf(leaving, entering)))
            polygon.insert(polygon.begin(), *crease);
        return polygon;
    }

    /// Depths change no faster than places.
    bool isShallowBySize(const CellCorners& c) const {
        for (int i = 0; i < 4; ++i) {
            double reach = 0;
            for (int j = 0; j < 4; ++j) reach = std::max(reach, (vertex(c[j]) - vertex(c[i])).norm());
            if (places_[c[i]].depth + reach <= limit_.limit()) return true;
        }
        return false;
    }

    CutSurface cutThroughLevel() const {
        SurfacePoints points;
        points.onEdge = [&](const CutEdge& edge) { return crossing(edge).point; };
        points.between = [&](const CutEdge& from, const CutEdge& to) { return creases_.at(keyOf(from, to)); };
        points.amid = [&](std::uint32_t tetrahedron) { return amid_[tetrahedron]; };
        return cutSurface(tetrahedra_, heights_, points);
    }

    /// Depths change no faster than places, except in gaps that count as filled. So tetrahedra need not be smaller
    /// than a tenth of the tolerance either.
    void requireContinuity(const CellCorners& c) const {
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
        throw ArgumentError("overlap is " + roundedNumber(least_) + " with the tolerance " +
                            roundedNumber(tolerance_) + ", and near " + roundedPoint(place) +
                            " it is unclear what is inside the part, expected surfaces that do not "
                            "run into themselves there, or another overlap.tolerance");
    }

    void bisect(std::size_t tetrahedron, std::vector<std::size_t>& halves) {
        halves.push_back(tetrahedron);
        halves.push_back(tetrahedra_.all().size());
        tetrahedra_.bisect(tetrahedron);
    }

    using EdgePair = std::pair<std::uint64_t, std::uint64_t>;

    const SurfaceDepth& surface_;
    Tetrahedra tetrahedra_;
    double least_, tolerance_, level_;
    DepthLimit limit_;
    LevelPoints points_;
    const std::function<bool()>& isStopped_;
    std::vector<Vector3> shellPoints_;               ///< one of each shell of the surface
    std::vector<std::size_t> open_;                  ///< tetrahedra to look at
    std::vector<std::vector<CutOutline>> outlines_;  ///< in the open ones
    std::vector<bool> isDeep_;   ///< of tetrahedra: the cut in it is deep enough, by exact queries
    std::vector<Vector3> amid_;  ///< of tetrahedra: the point amid the cut surface in it
    std::vector<SurfaceDepth::Place> places_;                  ///< of the vertices
    std::vector<double> heights_;                              ///< of the vertices: depth above the level
    std::unordered_map<std::uint64_t, LevelPoint> crossings_;  ///< of cut edges
    std::map<EdgePair, std::optional<Vector3>> creases_;       ///< of pairs of cut edges of one triangle
    mutable tbb::enumerable_thread_specific<Workspace> workspaces_;
};

}  // namespace

Mesh cutAtDepth(const SurfaceDepth& surface, const ShrinkOptions& options) {
    return LevelCut(surface, options).run();
}

}  // namespace clearway
