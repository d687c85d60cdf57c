#include "shrink/left_out.h"

#include <algorithm>

#include "core/number.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"

namespace clearway {
namespace {

/// In depths. A corner of three square faces is 1.7 depths from what is left of it; an edge between faces that
/// meet at 39 degrees is 3.
constexpr double kThin = 3;

std::string placeText(const Vector3& point) {
    const auto rounded = [](double x) { return shortNumber(double(float(x))); };
    return "(" + rounded(point.x()) + ", " + rounded(point.y()) + ", " + rounded(point.z()) + ")";
}

/// The shells of the shrunk mesh by the component in which they lie.
std::vector<std::size_t> piecesByComponent(const SurfaceDepth& surface, const Mesh& shrunk) {
    const CleanMesh cleaned = clean(shrunk);
    const Shells shells = findShells(cleaned.triangles);
    const std::vector<double> volumes = signedVolumes(cleaned.vertices, cleaned.triangles, shells);
    std::vector<std::size_t> counts(surface.pieceCount());
    std::uint32_t next = 0;
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        if (shells.ofTriangle[t] != next) continue;
        if (volumes[next++] <= 0) continue;
        if (const auto piece = surface.pieceHolding(cleaned.vertices[cleaned.triangles[t][0]]))
            ++counts[*piece];
    }
    return counts;
}

struct Far {
    double distance = 0;
    Vector3 point = Vector3::Zero();
};

/// The point of the component furthest from the shrunk mesh, among corners and centres of triangles.
Far furthest(const SurfaceDepth& surface, const SurfaceDepth::Piece& piece, const PointDistance& shrunk) {
    Workspace workspace;
    Far far;
    const auto lookAt = [&](const Vector3& point) {
        const double found = shrunk.at(point, workspace);
        if (found > far.distance) far = {found, point};
    };
    const auto& triangles = surface.mesh().triangles;
    std::vector<bool> isLookedAt(surface.mesh().vertices.size());
    for (std::uint32_t t = piece.firstTriangle; t < piece.firstTriangle + piece.triangleCount; ++t) {
        const Corners3 c = surface.corners(t);
        lookAt((c[0] + c[1] + c[2]) / 3);
        for (int k = 0; k < 3; ++k) {
            if (isLookedAt[triangles[t][k]]) continue;
            isLookedAt[triangles[t][k]] = true;
            lookAt(c[k]);
        }
    }
    return far;
}

}  // namespace

std::vector<std::string> findLeftOut(const SurfaceDepth& surface, const Mesh& shrunk, double depth) {
    const std::vector<std::size_t> left = piecesByComponent(surface, shrunk);
    const PointDistance toShrunk(Model::build(shrunk));
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < surface.pieceCount(); ++i) {
        const SurfaceDepth::Piece& piece = surface.piece(i);
        const std::string name = "'" + piece.name + "'";
        if (left[i] == 0) {
            lines.push_back("nothing is left of " + name);
            continue;
        }
        const std::size_t had = piece.bodies;
        if (left[i] != had) {
            lines.push_back(name + " has " + std::to_string(had) + (had == 1 ? " piece" : " pieces") +
                            " and " + std::to_string(left[i]) + " after shrinking");
        }
        const Far far = furthest(surface, piece, toShrunk);
        if (far.distance > kThin * depth) {
            lines.push_back(name + " is too thin at " + placeText(far.point) + ", which lies " +
                            shortNumber(double(float(far.distance))) + " from what is left");
        }
    }
    return lines;
}

}  // namespace clearway
