#include "support/hard_triangles.h"

#include "support/hard_triangle_draws.h"

namespace clearway::testing {
namespace {

TrianglePair pqpIssue4(Random&) {
    const KnownPair known = knownTrianglePairs().front();
    return {known.pair.a, known.pair.b, known.distance, 1e-27};
}

}  // namespace

// The numbers are those of tests/properties/hard_cases.md.
std::vector<TriangleFamily> hardTriangleFamilies() {
    return {{0, "random", randomPair},
            {1, "edges that lie on each other but for a roundoff", pqpIssue4},
            {2, "one edge of each along x", edgesAlongX},
            {3, "vertex over a small cell", smallCells},
            {4, "parallel plates", parallelPlates},
            {5, "crossing plates", crossingPlates},
            {6, "axis-aligned piercing", axisAlignedPiercing},
            {7, "standing plate", standingPlate},
            {8, "vertex over face", vertexOverFace},
            {9, "crossing edges", crossingEdges},
            {10, "vertex to vertex", vertexToVertex},
            {11, "vertex to edge", vertexToEdge},
            {12, "nearly parallel edges", nearlyParallelEdges},
            {13, "exactly parallel edges", exactlyParallelEdges},
            {14, "coplanar apart", coplanarApart},
            {15, "coplanar nested", coplanarNested},
            {16, "coplanar edge touch", coplanarEdgeTouch},
            {17, "coplanar turned", coplanarTurned},
            {18, "identical", identical},
            {19, "shared vertex", sharedVertex},
            {20, "shared edge", sharedEdge},
            {21, "T-junction", tJunction},
            {22, "needles", needles},
            {23, "caps", caps},
            {24, "zero-area segments", segments},
            {25, "points", points},
            {26, "one zero-length edge", zeroLengthEdges},
            {27, "integer grid", integerGrid},
            {28, "far from the origin", farFromOrigin},
            {29, "scales", scaledGrid},
            {30, "mixed sizes", mixedSizes},
            {31, "signed zeros and denormals", zerosAndDenormals},
            {31, "denormals", wholeDenormals},
            {33, "corner in the other's plane", cornerInPlane},
            {35, "nearly coplanar", nearlyCoplanar}};
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
