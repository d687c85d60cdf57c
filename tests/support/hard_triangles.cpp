#include "support/hard_triangles.h"

#include <algorithm>

#include "support/hard_triangle_draws.h"

namespace clearway::testing {
namespace {

TrianglePair pqpIssue4(Random&) {
    const KnownPair known = knownTrianglePairs().front();
    return {known.pair.a, known.pair.b, known.distance, 1e-27};
}

}  // namespace

std::vector<TriangleFamily> hardTriangleFamilies() {
    std::vector<TriangleFamily> all = statedFamilies();
    const std::vector<TriangleFamily> drawn = drawnFamilies();
    all.insert(all.end(), drawn.begin(), drawn.end());
    all.push_back({1, "edges that lie on each other but for a roundoff", pqpIssue4});
    std::stable_sort(all.begin(), all.end(),
                     [](const TriangleFamily& a, const TriangleFamily& b) { return a.number < b.number; });
    return all;
}

Pose poseFor(Random& random, const TrianglePair& pair) {
    Box box;
    for (int k = 0; k < 3; ++k) box.extend(pair.a[k]).extend(pair.b[k]);
    return random.pose(box.sizes().maxCoeff());
}

Mesh meshOf(const Triangle& triangle) {
    Mesh mesh;
    mesh.vertices.assign(triangle.begin(), triangle.end());
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

}  // namespace clearway::testing
