// Cuts the surface at half the tolerance from the part's places through tetrahedra.
#include "clearway/swept_volume.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/parallel.h"
#include "swept/cut_surface.h"
#include "swept/place_distances.h"
#include "swept/tetrahedra.h"

namespace clearway {
namespace {

constexpr std::size_t kMostPoints = 8'000'000;
constexpr std::size_t kPointsOfBlock = 64;  ///< points between two questions whether to stop

// Shares of the tolerance. In a tetrahedron with edges of at most kEdge, a point of the surface is less than kEdge from
// a corner on either side, whose distance to the part is kSurfaceLevel with an error of a 32nd: it is certain to be off the
// part, and within the tolerance of it, both with an eighth to spare for the error of poses.
constexpr double kSurfaceLevel = 0.5, kEdge = 0.3, kMostPoseError = 0.125;
constexpr double kCoarsest = 16;     ///< larger tetrahedra are halved without a look at the surface in them
constexpr double kRoom = 4;          ///< closed rooms that are narrower may be filled
constexpr double kLeastApart = 0.1;  ///< of the part from the surface in larger tetrahedra
constexpr double kLeastStep = 0.05;  ///< of a search along an edge
constexpr int kMostEdgeSteps = 24;
constexpr int kMostQuarterings = 2;  ///< of a triangle of the surface, to show that it is near the part

using CellCorners = std::array<std::uint32_t, 4>;

/// Marches tetrahedra along the surface. They are halved until each of them is certain to hold no piece of the surface,
/// or a piece that is off the part and near it.
class Sweeping {
  public:
    Sweeping(const PlaceDistances& distances, const SweptVolumeOptions& options)
        : distances_(distances), options_(options), tetrahedra_(grown(distances.box(), options.tolerance)) {}

    Mesh run() {
        open_.resize(tetrahedra_.all().size());
        std::iota(open_.begin(), open_.end(), std::size_t(0));
        while (!open_.empty()) {
            const std::size_t known = places_.size();
            refine();
            if (isStopped_) return {};
            open_ = tetrahedra_.withVerticesFrom(known);
        }
        const auto pointOn = [&](const CutEdge& edge) {
            const auto& [inner, outer] = edge;
            const auto found = cutPoints_.find(keyOf(inner, outer));
            if (found != cutPoints_.end()) return found->second;
            const auto& v = tetrahedra_.vertices();
            return cutPoint(v[inner], heights_[inner], v[outer], heights_[outer]);
        };
        return cutSurface(tetrahedra_, heights_, pointOn).mesh;
    }

  private:
    static Box grown(const Box& box, double by) {
        return Box(box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by));
    }

    static std::uint64_t keyOf(std::uint32_t inner, std::uint32_t outer) {
        return (std::uint64_t(inner) << 32) | outer;
    }

    void refine() {
        while (!open_.empty()) {
            measureNewVertices();
            findCutPoints();
            const std::vector<char> isSettled = judge();
            if (isStopped_) return;
            std::vector<std::size_t> next;
            for (std::size_t i = 0; i < open_.size(); ++i) {
                if (isSettled[i]) continue;
                next.push_back(open_[i]);
                next.push_back(tetrahedra_.all().size());
                tetrahedra_.bisect(open_[i]);
            }
            open_ = std::move(next);
            if (tetrahedra_.vertices().size() > kMostPoints) {
                throw ArgumentError(
                    fmt::format("the tolerance of the swept volume is {}, which takes more than {} points, "
                                "expected a larger one",
                                shortNumber(options_.tolerance), kMostPoints));
            }
        }
    }

    /// Calls work(i, workspace) for i below count, in parallel, until the caller wants it to stop.
    template <class Work>
    void forEach(std::size_t count, const Work& work) {
        forEachRun(count, kPointsOfBlock, [&](std::size_t first, std::size_t last) {
            if (isStopped_ || (options_.isStopped && options_.isStopped())) {
                isStopped_ = true;
                return;
            }
            Workspace& workspace = workspaces_.local();
            workspace.forgetWarmStart();
            for (std::size_t i = first; i < last; ++i) work(i, workspace);
        });
    }

    void measureNewVertices() {
        const std::size_t first = places_.size();
        const auto& vertices = tetrahedra_.vertices();
        places_.resize(vertices.size());
        heights_.resize(vertices.size());
        forEach(vertices.size() - first, [&](std::size_t k, Workspace& workspace) {
            const std::size_t i = first + k;
            places_[i] = placeOf(vertices[i], workspace);
            const double distance = middle(places_[i]);
            const bool isInside = distance > level() && distances_.isInMaterial(vertices[i]);
            heights_[i] = level() - (isInside ? -distance : distance);
        });
    }

    PlaceDistance placeOf(const Vector3& point, Workspace& workspace) const {
        std::size_t& nearest = nearestMotion_.local();
        return distances_.at(point, nearest, workspace);
    }

    static double middle(const PlaceDistance& place) { return 0.5 * (place.lower + place.upper); }
    double level() const { return kSurfaceLevel * options_.tolerance; }

    /// Finds where the surface crosses the edges of open tetrahedra that it may cross without being halved.
    void findCutPoints() {
        std::vector<std::uint64_t> edges;
        for (const std::size_t i : open_) {
            const Tetrahedron& tetrahedron = tetrahedra_.all()[i];
            if (isSmall(tetrahedron.corners) || isLarge(tetrahedron.corners)) continue;
            for (const auto& outline : outlinesIn(tetrahedra_, tetrahedron, heights_)) {
                for (const auto& [inner, outer] : outline) {
                    if (!cutPoints_.count(keyOf(inner, outer))) edges.push_back(keyOf(inner, outer));
                }
            }
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        std::vector<Vector3> points(edges.size());
        forEach(edges.size(), [&](std::size_t i, Workspace& workspace) {
            points[i] = crossing(static_cast<std::uint32_t>(edges[i] >> 32),
                                 static_cast<std::uint32_t>(edges[i]), workspace);
        });
        for (std::size_t i = 0; i < edges.size(); ++i) cutPoints_.emplace(edges[i], points[i]);
    }

    /// Goes from the outer end as far as the distance to the part allows, until that is the surface's.
    Vector3 crossing(std::uint32_t inner, std::uint32_t outer, Workspace& workspace) const {
        const Vector3 &from = tetrahedra_.vertices()[outer], &to = tetrahedra_.vertices()[inner];
        const double length = (to - from).norm(), step = kLeastStep * options_.tolerance;
        double way = -heights_[outer];
        for (int i = 0; i < kMostEdgeSteps && way < length; ++i) {
            const double slack = middle(placeOf(from + way / length * (to - from), workspace)) - level();
            if (slack <= step) break;
            way += slack;
        }
        return pointOnEdge(from, to, way / length);
    }

    std::vector<char> judge() {
        std::vector<char> isDone(open_.size());
        forEach(open_.size(), [&](std::size_t i, Workspace& workspace) {
            isDone[i] = isSettled(tetrahedra_.all()[open_[i]], workspace);
        });
        return isDone;
    }

    bool isSettled(const Tetrahedron& tetrahedron, Workspace& workspace) const {
        const CellCorners& c = tetrahedron.corners;
        const auto outlines = outlinesIn(tetrahedra_, tetrahedron, heights_);
        if (outlines.size() > 1) return false;  // their fillings might cross
        if (isSmall(c)) return true;
        if (outlines.empty()) return isSettledWithoutSurface(c);
        return !isLarge(c) && isSurfaceGood(tetrahedron, outlines[0], workspace);
    }

    double longestEdge(const CellCorners& c) const {
        const auto& v = tetrahedra_.vertices();
        double longest = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j) longest = std::max(longest, (v[c[i]] - v[c[j]]).norm());
        return longest;
    }

    bool isSmall(const CellCorners& c) const { return longestEdge(c) <= kEdge * options_.tolerance; }
    bool isLarge(const CellCorners& c) const { return longestEdge(c) > kCoarsest * options_.tolerance; }

    /// Whether the part's surface never comes into the tetrahedron, or the tetrahedron is all inside and either near the
    /// part or too narrow to hold a room that counts.
    bool isSettledWithoutSurface(const CellCorners& c) const {
        const auto& v = tetrahedra_.vertices();
        const double slack = kMostPoseError * options_.tolerance;
        const bool isInside = heights_[c[0]] >= 0;
        for (int i = 0; i < 4; ++i) {
            double reach = 0;
            for (int j = 0; j < 4; ++j) reach = std::max(reach, (v[c[j]] - v[c[i]]).norm());
            if (places_[c[i]].lower > reach + slack) return true;
            if (isInside && places_[c[i]].upper + reach + slack <= options_.tolerance) return true;
        }
        return isInside && longestEdge(c) <= kRoom * options_.tolerance;
    }

    /// Whether the surface in the tetrahedron is off the part at all poses, and near it everywhere. So each connected
    /// piece of the part stays on one side of the surface, and that is the inside: the point of the piece that
    /// holdsPiece() knows is in a small or an uncut tetrahedron.
    bool isSurfaceGood(const Tetrahedron& tetrahedron, const std::vector<CutEdge>& outline,
                       Workspace& workspace) const {
        const auto& v = tetrahedra_.vertices();
        const CellCorners& corners = tetrahedron.corners;
        const Vector3 centre = 0.25 * (v[corners[0]] + v[corners[1]] + v[corners[2]] + v[corners[3]]);
        double radius = 0;
        for (const std::uint32_t c : corners) radius = std::max(radius, (v[c] - centre).norm());
        if (distances_.holdsPiece(centre, radius, workspace)) return false;
        std::vector<Vector3> points;
        Vector3 sum = Vector3::Zero();
        for (const auto& [inner, outer] : outline) {
            points.push_back(cutPoints_.at(keyOf(inner, outer)));
            sum += points.back();
        }
        points.push_back(sum / double(outline.size()));
        for (const auto& [a, b, c] : filling(int(outline.size()), tetrahedra_.hasWholeEdges(tetrahedron))) {
            const SurfaceTriangle triangle{points[a], points[b], points[c]};
            if (!isNear(triangle, kMostQuarterings, workspace) ||
                !distances_.areApart(triangle, kLeastApart * options_.tolerance, workspace))
                return false;
        }
        return true;
    }

    bool isNear(const SurfaceTriangle& triangle, int quarterings, Workspace& workspace) const {
        const double most = (1 - kMostPoseError) * options_.tolerance;
        const Vector3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3;
        const PlaceDistance place = placeOf(centre, workspace);
        if (place.upper > most) return false;
        double radius = 0;
        for (const Vector3& corner : triangle) radius = std::max(radius, (corner - centre).norm());
        if (place.upper + radius <= most) return true;
        if (distances_.isWithinOfOnePlace(triangle, most, place, workspace)) return true;
        if (quarterings == 0) return false;
        const Vector3 ab = 0.5 * (triangle[0] + triangle[1]), bc = 0.5 * (triangle[1] + triangle[2]),
                      ca = 0.5 * (triangle[2] + triangle[0]);
        for (const SurfaceTriangle& quarter :
             {SurfaceTriangle{triangle[0], ab, ca}, SurfaceTriangle{triangle[1], bc, ab},
              SurfaceTriangle{triangle[2], ca, bc}, SurfaceTriangle{ab, bc, ca}}) {
            if (!isNear(quarter, quarterings - 1, workspace)) return false;
        }
        return true;
    }

    const PlaceDistances& distances_;
    const SweptVolumeOptions& options_;
    Tetrahedra tetrahedra_;
    std::vector<std::size_t> open_;
    std::vector<PlaceDistance> places_;  ///< of the vertices
    std::vector<double> heights_;        ///< of the vertices
    std::unordered_map<std::uint64_t, Vector3> cutPoints_;
    std::atomic<bool> isStopped_{false};
    tbb::enumerable_thread_specific<Workspace> workspaces_;
    mutable tbb::enumerable_thread_specific<std::size_t> nearestMotion_{std::size_t(0)};
};

void requireOptions(const std::vector<RigidMotion>& motions, const SweptVolumeOptions& options) {
    const auto refuse = [](const std::string& name, double value, const std::string& expected) {
        throw ArgumentError("the " + name + " of the swept volume is " + shortNumber(value) + ", expected " +
                            expected);
    };
    if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
        refuse("tolerance", options.tolerance, "a finite number above 0");
    if (!(options.poseError >= 0) || !(options.poseError < kMostPoseError * options.tolerance))
        refuse("poseError", options.poseError, "0 up to an eighth of the tolerance");
    if (motions.empty()) throw ArgumentError("a swept volume has no motion, expected at least one");
}

}  // namespace

Mesh sweptVolume(const Mesh& part, const std::vector<RigidMotion>& motions,
                 const SweptVolumeOptions& options) {
    requireOptions(motions, options);
    const PlaceDistances distances(part, motions, options.tolerance, options.poseError);
    Mesh swept = Sweeping(distances, options).run();
    swept.components = {{"swept volume", 0, static_cast<std::uint32_t>(swept.triangles.size())}};
    return swept.triangles.empty() ? Mesh() : swept;
}

}  // namespace clearway
