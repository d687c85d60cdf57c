// Shrinks a part, checks what is left and tells what is not.
#include "clearway/shrink.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "clearway/errors.h"
#include "core/number.h"
#include "shrink/left_out.h"
#include "shrink/level_cut.h"
#include "shrink/surface_depth.h"

namespace clearway {
namespace {

void requirePositive(double value, const char* name) {
    if (value > 0 && std::isfinite(value)) return;
    throw ArgumentError(std::string(name) + " is " + shortNumber(value) +
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
        throw ArgumentError("the shrunk part is not inside the part, whose surface may pass through itself");
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
    shrunk.options = {options.overlap, options.tolerance};
    shrunk.mesh = cutAtDepth(surface, options);
    if (shrunk.mesh.triangles.empty()) {
        throw ArgumentError("overlap is " + roundedNumber(options.overlap) + " with the tolerance " +
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
