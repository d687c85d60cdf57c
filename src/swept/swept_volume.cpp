// Cuts the surface at half the tolerance from the part's places through tetrahedra.
#include "clearway/swept_volume.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "clearway/model.h"
#include "core/number.h"
#include "isosurface/cut_surface.h"
#include "isosurface/tetrahedra.h"
#include "mesh/renumber.h"
#include "mesh/topology.h"
#include "model/solids.h"

namespace clearway {
namespace {

constexpr std::size_t kMostVertices = 8'000'000;
constexpr std::size_t kBlock = 64;  ///< points between two questions whether to stop

// Shares of the tolerance. A point of the surface is less than kEdge from a corner on either side, whose distance to
// the part is kLevel with an error of kError; kLevel - kEdge - kError is more than 0, kLevel + kEdge + kError less
// than 1, both with an eighth to spare for the error of poses.
constexpr double kLevel = 0.5, kEdge = 0.3, kError = 1.0 / 32;
constexpr double kErrorShare = 0.1;  ///< of a distance: how little need be known of larger ones
constexpr double kMostPoseError = 0.125;

/// Bounds of a point's distance to the part's nearest place.
struct PlaceDistance {
    double lower, upper;
};

/// The part's way along one motion, and a ball that holds it.
struct Motion {
    RigidMotion motion;
    Vector3 centre;
    double radius;
};

Mesh pointAtOrigin() {
    Mesh mesh;
    mesh.vertices = {Vector3::Zero()};
    mesh.triangles = {{0, 0, 0}};
    return mesh;
}

class PlaceDistances {
  public:
    PlaceDistances(const Mesh& part, const std::vector<RigidMotion>& motions, double tolerance,
                   double poseError)
        : part_(Model::build(part)),
          point_(Model::build(pointAtOrigin())),
          tolerance_(tolerance),
          poseError_(poseError) {
        const Vector3 centre = part_.box().center();
        const double radius = 0.5 * part_.box().diagonal().norm();
        for (const RigidMotion& motion : motions) {
            // The centre's way is no longer than the translation and its arc about the origin.
            const double reach = 0.5 * (motion.translation.norm() + motion.turn.norm() * centre.norm());
            const Pose middle = piecesOf(motion, part_)(0, 1).middle;
            motions_.push_back({motion, middle * centre, radius + reach + poseError});
            box_.extend(Box(motions_.back().centre - Vector3::Constant(motions_.back().radius),
                            motions_.back().centre + Vector3::Constant(motions_.back().radius)));
        }
    }

    const Box& box() const { return box_; }  ///< holds all places
    const Model& part() const { return part_; }

    /// first: the number of the motion that is asked first, and then of the nearest one.
    PlaceDistance at(const Vector3& point, std::size_t& first, Workspace& workspace) const {
        PlaceDistance least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        const std::size_t begin = first;
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            const std::size_t k = i == 0 ? begin : i <= begin ? i - 1 : i;
            const Motion& motion = motions_[k];
            if ((point - motion.centre).norm() - motion.radius >= least.lower) continue;
            const PlaceDistance found = along(motion.motion, point, least.upper, workspace);
            if (found.upper < least.upper) first = k;
            least = {std::min(least.lower, found.lower), std::min(least.upper, found.upper)};
        }
        return least;
    }

  private:
    PlaceDistance along(RigidMotion motion, const Vector3& point, double cap, Workspace& workspace) const {
        motion.start.translation -= point;
        LeastDistanceOptions options;
        options.poseError = poseError_;
        options.cap = cap;
        options.resolution = {kErrorShare, kErrorShare, 0, kError * tolerance_};
        const LeastDistance found = leastDistance(part_, point_, piecesOf(motion, part_), options, workspace);
        return {std::max(found.lower, 0.0), found.upper};
    }

    Model part_, point_;
    double tolerance_, poseError_;
    std::vector<Motion> motions_;
    Box box_;
};

class Sweeping {
  public:
    Sweeping(const PlaceDistances& distances, const SweptVolumeOptions& options)
        : distances_(distances), options_(options), tetrahedra_(grown(distances.box(), options.tolerance)) {}

    Mesh run() {
        open_.resize(tetrahedra_.all().size());
        std::iota(open_.begin(), open_.end(), std::size_t(0));
        while (!open_.empty()) {
            refine();
            if (isStopped_) return {};
            open_ = tetrahedra_.makeConforming();
        }
        return cutSurface(tetrahedra_, heights_).mesh;
    }

  private:
    static Box grown(const Box& box, double by) {
        return Box(box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by));
    }

    void refine() {
        while (!open_.empty()) {
            measureNewVertices();
            if (isStopped_) return;
            std::vector<std::size_t> next;
            for (const std::size_t i : open_) {
                if (isSettled(tetrahedra_.all()[i].corners)) continue;
                next.push_back(i);
                next.push_back(tetrahedra_.all().size());
                tetrahedra_.bisect(i);
            }
            open_ = std::move(next);
            if (tetrahedra_.vertices().size() > kMostVertices) {
                throw std::invalid_argument("the tolerance of the swept volume is " +
                                            shortNumber(options_.tolerance) + ", which takes more than " +
                                            std::to_string(kMostVertices) + " points, expected a larger one");
            }
        }
    }

    void measureNewVertices() {
        const std::size_t first = places_.size();
        const auto& vertices = tetrahedra_.vertices();
        places_.resize(vertices.size());
        heights_.resize(vertices.size());
        tbb::parallel_for(
            std::size_t(0), (vertices.size() - first + kBlock - 1) / kBlock, [&](std::size_t block) {
                if (isStopped_ || (options_.isStopped && options_.isStopped())) {
                    isStopped_ = true;
                    return;
                }
                Workspace& workspace = workspaces_.local();
                workspace.forgetWarmStart();
                std::size_t nearest = 0;
                const std::size_t from = first + block * kBlock,
                                  to = std::min(vertices.size(), from + kBlock);
                for (std::size_t i = from; i < to; ++i) {
                    places_[i] = distances_.at(vertices[i], nearest, workspace);
                    heights_[i] = kLevel * options_.tolerance - 0.5 * (places_[i].lower + places_[i].upper);
                }
            });
    }

    /// Whether the part never comes into the tetrahedron, or it is near the part everywhere, or is small.
    bool isSettled(const std::array<std::uint32_t, 4>& c) const {
        const auto& v = tetrahedra_.vertices();
        double longest = 0;
        for (int i = 0; i < 4; ++i) {
            double reach = 0;
            for (int j = 0; j < 4; ++j) reach = std::max(reach, (v[c[j]] - v[c[i]]).norm());
            const double spare = kMostPoseError * options_.tolerance;
            if (isUncut(c) && (places_[c[i]].lower > reach + spare ||
                               places_[c[i]].upper + reach + spare <= options_.tolerance))
                return true;
            longest = std::max(longest, reach);
        }
        return longest <= kEdge * options_.tolerance;
    }

    bool isUncut(const std::array<std::uint32_t, 4>& c) const {
        const auto inside =
            std::count_if(c.begin(), c.end(), [&](std::uint32_t v) { return heights_[v] >= 0; });
        return inside == 0 || inside == 4;
    }

    const PlaceDistances& distances_;
    const SweptVolumeOptions& options_;
    Tetrahedra tetrahedra_;
    std::vector<std::size_t> open_;
    std::vector<PlaceDistance> places_;  ///< of the vertices
    std::vector<double> heights_;        ///< of the vertices
    std::atomic<bool> isStopped_{false};
    tbb::enumerable_thread_specific<Workspace> workspaces_;
};

/// Leaves out shells that lie in the part's material. The part's surface never touches a shell, so all of the shell is
/// in the material at all poses, or nothing of it at any.
Mesh withoutInnerShells(const Mesh& swept, const Mesh& part, const Pose& X_environmentPart) {
    const Shells shells = findShells(swept.triangles);
    const std::shared_ptr<const Solids> solids = makeSolids(part).solids;
    std::vector<std::optional<bool>> isKept(shells.count);
    Mesh kept;
    for (std::size_t t = 0; t < swept.triangles.size(); ++t) {
        std::optional<bool>& keeps = isKept[shells.ofTriangle[t]];
        if (!keeps) {
            Mesh point;
            point.vertices = {swept.vertices[swept.triangles[t][0]]};
            point.triangles = {{0, 0, 0}};
            keeps = !solids->holding(X_environmentPart, Solids(point), {});
        }
        if (*keeps) kept.triangles.push_back(swept.triangles[t]);
    }
    kept.vertices = takeUsedVertices(swept.vertices, kept.triangles);
    kept.components = {{"swept volume", 0, static_cast<std::uint32_t>(kept.triangles.size())}};
    return kept;
}

void requireOptions(const std::vector<RigidMotion>& motions, const SweptVolumeOptions& options) {
    const auto refuse = [](const std::string& name, double value, const std::string& expected) {
        throw std::invalid_argument("the " + name + " of the swept volume is " + shortNumber(value) +
                                    ", expected " + expected);
    };
    if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
        refuse("tolerance", options.tolerance, "a finite number above 0");
    if (!(options.poseError >= 0) || !(options.poseError < kMostPoseError * options.tolerance))
        refuse("poseError", options.poseError, "0 up to an eighth of the tolerance");
    if (motions.empty()) throw std::invalid_argument("a swept volume has no motion, expected at least one");
}

}  // namespace

Mesh sweptVolume(const Mesh& part, const std::vector<RigidMotion>& motions,
                 const SweptVolumeOptions& options) {
    requireOptions(motions, options);
    const PlaceDistances distances(part, motions, options.tolerance, options.poseError);
    const Mesh swept = Sweeping(distances, options).run();
    if (swept.triangles.empty()) return {};
    return withoutInnerShells(swept, part, motions[0].start);
}

}  // namespace clearway
