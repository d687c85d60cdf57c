#include "shrink/concave_edges.h"

#include <cmath>
#include <map>

#include "mesh/clean.h"

namespace clearway {
namespace {

struct EdgeSide {
    int faces = 0;
    Vector3 normal;  ///< of the first face
};

}  // namespace

double concaveLength(const SurfaceDepth& surface, double depth, double tolerance) {
    const CleanMesh cleaned = clean(surface.mesh());
    std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeSide> edges;
    double sum = 0;
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        const TriangleIndices& triangle = cleaned.triangles[t];
        const auto corner = [&](int k) { return cleaned.vertices[triangle[k % 3]]; };
        const Vector3 normal = surface.outwardNormal(cleaned.triangleIds[t]).normalized();
        for (int k = 0; k < 3; ++k) {
            EdgeSide& side = edges[std::minmax(triangle[k], triangle[(k + 1) % 3])];
            if (++side.faces == 1) {
                side.normal = normal;
                continue;
            }
            const Vector3 along = corner(k + 1) - corner(k);
            const double turn = std::atan2(side.normal.cross(normal).norm(), side.normal.dot(normal));
            const bool isConcave = side.faces == 2 && side.normal.dot(corner(k + 2) - corner(k)) > 0;
            if (isConcave && depth * (1 - std::cos(0.5 * turn)) > tolerance) sum += along.norm() * turn;
        }
    }
    return sum;
}

}  // namespace clearway
