#include "shrink/left_out.h"

#include <algorithm>
#include <map>

#include "core/number.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"

namespace clearway {
namespace {

/// In depths. A corner of three square faces is 1.7 depths from what is left of it; an edge between faces that
/// meet at 39 degrees is 3.
constexpr double kThin = 3;
constexpr double kFineness = 0.25;  ///< in depths: no smaller pieces are looked at

/// How many shells of the shrunk mesh lie in each body.
std::vector<std::size_t> shellsByBody(const SurfaceDepth& surface, const Mesh& shrunk) {
    const CleanMesh cleaned = clean(shrunk);
    const Shells shells = findShells(cleaned.triangles);
    const std::vector<double> volumes = signedVolumes(cleaned.vertices, cleaned.triangles, shells);
    std::vector<std::size_t> counts(surface.bodyNames().size());
    Workspace workspace;
    std::uint32_t next = 0;
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        if (shells.ofTriangle[t] != next) continue;
        if (volumes[next++] <= 0) continue;
        ++counts[surface.bodyNear(cleaned.vertices[cleaned.triangles[t][0]], workspace)];
    }
    return counts;
}

/// Lines for bodies of which nothing is left or that fall apart.
std::vector<std::string> findLostBodies(const SurfaceDepth& surface, const Mesh& shrunk) {
    struct Bodies {
        std::size_t all = 0, lost = 0, apart = 0;
    };
    const std::vector<std::size_t> counts = shellsByBody(surface, shrunk);
    std::map<std::string, Bodies> byName;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        Bodies& bodies = byName[surface.bodyNames()[i]];
        ++bodies.all;
        bodies.lost += counts[i] == 0;
        bodies.apart += counts[i] > 1;
    }
    std::vector<std::string> lines;
    const auto add = [&](const std::string& what, std::size_t count, std::size_t all,
                         const std::string& name) {
        const std::string share =
            count == all ? "" : std::to_string(count) + " of the " + std::to_string(all) + " pieces of ";
        if (count > 0) lines.push_back(what + share + "'" + name + "'");
    };
    for (const auto& [name, bodies] : byName) {
        add("nothing is left of ", bodies.lost, bodies.all, name);
        add("shrinking cuts through ", bodies.apart, bodies.all, name);
    }
    return lines;
}

struct Far {
    double distance = 0;
    Vector3 point = Vector3::Zero();
};

/// A point of a component that is further from the shrunk mesh than `most`, the furthest of those looked at.
/// Looks at the middles of triangles and of their pieces, which are halved until they are near enough to one
/// triangle of the shrunk mesh (the distance to a triangle is convex, so corners decide) or smaller than `fineness`.
class FarSearch {
  public:
    FarSearch(const Mesh& shrunk, double most, double fineness)
        : shrunk_(shrunk), toShrunk_(Model::build(shrunk)), most_(most), fineness_(fineness) {}

    Far find(const SurfaceDepth& surface, const SurfaceDepth::Piece& piece) {
        far_ = {};
        for (std::uint32_t t = piece.firstTriangle; t < piece.firstTriangle + piece.triangleCount; ++t)
            look(surface.corners(t));
        return far_;
    }

  private:
    void look(const Corners3& c) {
        const Vector3 middle = (c[0] + c[1] + c[2]) / 3;
        const DistanceResult found = toShrunk_.find(middle, workspace_);
        if (found.distance > far_.distance) far_ = {found.distance, middle};
        if (found.distance > most_) return;
        double radius = 0;
        for (const Vector3& corner : c) radius = std::max(radius, (corner - middle).norm());
        if (found.distance + radius <= most_ || radius <= fineness_) return;
        const auto& [p, q, r] = shrunk_.triangles[found.witness->environmentTriangle];
        const Corners3 nearest = {shrunk_.vertices[p], shrunk_.vertices[q], shrunk_.vertices[r]};
        if (std::all_of(c.begin(), c.end(),
                        [&](const Vector3& corner) { return distanceToTriangle(corner, nearest) <= most_; }))
            return;
        int longest = 0;
        const auto length = [&](int k) { return (c[(k + 1) % 3] - c[k]).squaredNorm(); };
        for (int k = 1; k < 3; ++k) {
            if (length(k) > length(longest)) longest = k;
        }
        const Vector3 &a = c[longest], &b = c[(longest + 1) % 3], &tip = c[(longest + 2) % 3];
        const Vector3 between = 0.5 * (a + b);
        look({a, between, tip});
        look({between, b, tip});
    }

    const Mesh& shrunk_;
    const PointDistance toShrunk_;
    const double most_, fineness_;
    Far far_;
    Workspace workspace_;
};

}  // namespace

std::vector<std::string> findLeftOut(const SurfaceDepth& surface, const Mesh& shrunk, double depth) {
    std::vector<std::string> lines = findLostBodies(surface, shrunk);
    FarSearch search(shrunk, kThin * depth, kFineness * depth);
    for (std::size_t i = 0; i < surface.pieceCount(); ++i) {
        const SurfaceDepth::Piece& piece = surface.piece(i);
        if (std::find(lines.begin(), lines.end(), "nothing is left of '" + piece.name + "'") != lines.end())
            continue;
        const Far far = search.find(surface, piece);
        if (far.distance > kThin * depth) {
            lines.push_back("'" + piece.name + "' is too thin at " + roundedPoint(far.point) +
                            ", which lies " + roundedNumber(far.distance) + " from what is left");
        }
    }
    return lines;
}

}  // namespace clearway
