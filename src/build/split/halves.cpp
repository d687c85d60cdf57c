#include "build/split/halves.h"

#include <algorithm>
#include <utility>

namespace clearway {

std::size_t splitInHalves(const CleanMesh& mesh, TriangleRun run) {
    const Vector3 reference = mesh.vertices[mesh.triangles[*run.first][0]];
    Vector3 lowest = tripleCentroid(mesh, *run.first, reference);
    Vector3 highest = lowest;
    for (const std::uint32_t triangle : run) {
        const Vector3 centroid = tripleCentroid(mesh, triangle, reference);
        lowest = lowest.cwiseMin(centroid);
        highest = highest.cwiseMax(centroid);
    }
    Eigen::Index axis = 0;
    (highest - lowest).maxCoeff(&axis);

    const auto key = [&](std::uint32_t triangle) {
        return std::make_pair(tripleCentroid(mesh, triangle, reference)[axis], triangle);
    };
    std::uint32_t* middle = run.first + run.size() / 2;
    std::nth_element(run.first, middle, run.last,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    return run.size() / 2;
}

}  // namespace clearway
