// Shrinks a part: moves its faces inwards, and certifies how far its surface moved.
#include "clearway/shrink.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "clearway/errors.h"
#include "core/number.h"
#include "mesh/components.h"
#include "model/solids.h"
#include "shrink/certificate.h"
#include "shrink/mitres.h"
#include "shrink/oriented_surface.h"
#include "shrink/thin_places.h"

namespace clearway {
namespace {

constexpr double kFaceDepth =
    0.75;  ///< of the overlap: how far faces move, which leaves the rest for corners
constexpr double kRounding =
    1e-11;  ///< of the largest coordinate: more than moves and distances are rounded by
constexpr double kCornerReach = 6;   ///< face depths around a vertex whose move was shortened
constexpr double kMitreReach = 1.5;  ///< of its move, if that is more
constexpr double kThin = 0.6;        ///< of the overlap: where less is allowed, the place counts as thin

void requireOverlap(double overlap) {
    if (overlap > 0 && std::isfinite(overlap)) return;
    throw ArgumentError("overlap is " + shortNumber(overlap) + ", expected a finite number above 0");
}

double largestCoordinate(const std::vector<Vector3>& vertices) {
    double largest = 0;
    for (const Vector3& vertex : vertices) largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
    return largest;
}

Mesh meshOf(const OrientedSurface& surface) {
    Mesh mesh;
    mesh.vertices = surface.vertices;
    mesh.triangles = surface.triangles;
    return mesh;
}

class Shrinking {
  public:
    Shrinking(const Mesh& part, const ShrinkOptions& options)
        : options_(options), whole_(orientedSurface(part)), nearest_(Model::build(meshOf(whole_))) {
        const double rounding = kRounding * largestCoordinate(whole_.vertices);
        const double most = 0.5 * nearest_.model().box().diagonal().norm();
        if (options.overlap > most) {
            throw ArgumentError("overlap is " + shortNumber(options.overlap) + ", expected at most " +
                                roundedNumber(most) + ", half of the mesh's size");
        }
        depths_ = {kFaceDepth * options.overlap, options.overlap - rounding};
        if (!(depths_.most > depths_.face)) {
            throw ArgumentError("overlap is " + shortNumber(options.overlap) + ", expected more than " +
                                shortNumber(awayFromZero(rounding / (1 - kFaceDepth), 2)) +
                                ", which coordinates are rounded by");
        }
    }

    /// Faces around a vertex whose move is shortened would tilt as a whole. So their corners there are cut off, and all is done again.
    void run() {
        requireGoingOn();
        moved_ = mitred(whole_, depths_);
        const std::vector<double> reach = shortened(whole_);
        if (std::all_of(reach.begin(), reach.end(), [](double r) { return r == 0; })) {
            surface_ = whole_;
            return;
        }
        surface_ = withCutCorners(whole_, reach);
        moved_ = mitred(surface_, depths_);
        shortened(surface_);
    }

    ShrunkPart result(const Mesh& part) {
        ShrunkPart shrunk;
        shrunk.options.overlap = options_.overlap;
        shrunk.mesh.origin = part.origin;
        for (const MovedVertex& place : moved_.places) {
            shrunk.mesh.vertices.push_back(surface_.vertices[place.vertex] + place.move);
        }
        // Each component stays one, since each winds around its own inside.
        const std::vector<Component> components = componentsOf(part);
        std::vector<std::vector<const MovedTriangle*>> trianglesOf(components.size());
        for (const MovedTriangle& triangle : moved_.triangles)
            trianglesOf[componentOf(components, givenOf(triangle))].push_back(&triangle);
        for (std::size_t i = 0; i < components.size(); ++i) {
            shrunk.mesh.components.push_back({components[i].name,
                                              static_cast<std::uint32_t>(shrunk.mesh.triangles.size()),
                                              static_cast<std::uint32_t>(trianglesOf[i].size())});
            for (const MovedTriangle* triangle : trianglesOf[i]) {
                shrunk.mesh.triangles.push_back(triangle->places);
                shrunk.partTriangles.push_back(givenOf(*triangle));
            }
        }
        findThinPlaces(shrunk);
        return shrunk;
    }

  private:
    void requireGoingOn() const {
        if (options_.isStopped && options_.isStopped()) throw ShrinkStopped("shrinking was stopped");
    }

    std::uint32_t givenOf(const MovedTriangle& triangle) const {
        return surface_.given[OrientedSurface::triangleOf(triangle.side)];
    }

    /// Shortens moves. Returns how far around each vertex with a shortened move its faces' corners should be cut off.
    std::vector<double> shortened(const OrientedSurface& surface) {
        std::vector<double> lengths;
        for (const MovedVertex& place : moved_.places) lengths.push_back(place.move.norm());
        requireGoingOn();
        const std::vector<bool> thin = keepBeforeMiddles(surface, nearest_, whole_, depths_.face, moved_);
        requireGoingOn();
        const std::vector<bool> deep = certifyMoves(surface, nearest_, whole_, depths_.most, moved_);
        std::vector<double> reach(surface.vertices.size(), 0);
        isShortened_.assign(moved_.places.size(), false);
        for (std::size_t i = 0; i < moved_.places.size(); ++i) {
            isShortened_[i] = thin[i] || deep[i];
            if (!isShortened_[i]) continue;
            double& around = reach[moved_.places[i].vertex];
            around = std::max({around, kCornerReach * depths_.face, kMitreReach * lengths[i]});
        }
        return reach;
    }

    /// A place counts once, however many vertices of the shrunk part are there. Where no move was shortened, none is thin.
    void findThinPlaces(ShrunkPart& shrunk) {
        ThinPlaces& thin = shrunk.thin;
        thin.leastOverlap = options_.overlap;
        std::vector<bool> isThin(surface_.vertices.size(), false);
        for (std::size_t i = 0; i < moved_.places.size(); ++i) {
            if (!isShortened_[i]) continue;
            const double depth = depthOf(shrunk.mesh.vertices[i], nearest_, whole_);
            if (depth >= kThin * options_.overlap) continue;
            isThin[moved_.places[i].vertex] = true;
            if (depth >= thin.leastOverlap) continue;
            thin.leastOverlap = std::max(0.0, depth);
            thin.at = surface_.vertices[moved_.places[i].vertex];
        }
        thin.count = static_cast<std::size_t>(std::count(isThin.begin(), isThin.end(), true));
    }

    const ShrinkOptions& options_;
    const OrientedSurface whole_;
    NearestTriangle nearest_;  ///< of whole_, which covers the same points as surface_
    MitreDepths depths_{};
    OrientedSurface surface_;
    MovedSurface moved_;
    std::vector<bool> isShortened_;  ///< for each place
};

}  // namespace

ShrunkPart shrink(const Mesh& part, const ShrinkOptions& options) {
    requireOverlap(options.overlap);
    Shrinking shrinking(part, options);
    shrinking.run();
    return shrinking.result(part);
}

std::shared_ptr<const ShrunkModel> shrunkModel(const ShrunkPart& shrunk, Model model) {
    return std::make_shared<const ShrunkModel>(
        ShrunkModel{std::move(model), std::make_shared<const Solids>(Solids::oriented(shrunk.mesh)),
                    shrunk.options.overlap, shrunk.partTriangles});
}

}  // namespace clearway
