#include "support/hard_triangles.h"

#include <cmath>

namespace clearway::testing {
namespace {

constexpr double kSize = 500;

Triangle randomTriangle(Random& random, double halfSide = kSize) {
    const Vector3 a = random.inBox(halfSide), b = random.inBox(halfSide);
    return {a, b, random.inBox(halfSide)};
}

/// 10^-low .. 10^-high
double powerOfTen(Random& random, int low, int high) {
    return std::pow(10.0, -(low + random.below(high - low + 1)));
}

Triangle movedBy(const Triangle& triangle, const Pose& pose) {
    return {pose * triangle[0], pose * triangle[1], pose * triangle[2]};
}

TrianglePair movedBy(const TrianglePair& pair, const Pose& pose) {
    return {movedBy(pair.a, pose), movedBy(pair.b, pose)};
}

// Half of the draws keep their round coordinates (ties, exact parallels), half are turned (the same up to
// rounding).
TrianglePair sometimesTurned(Random& random, const TrianglePair& pair) {
    return random.below(2) == 0 ? pair : movedBy(pair, random.pose(kSize));
}

Triangle flatTriangle(Random& random, double z) {
    Triangle triangle = randomTriangle(random);
    for (Vector3& p : triangle) p.z() = z;
    return triangle;
}

TrianglePair parallelEdges(Random& random) {
    TrianglePair pair{randomTriangle(random), randomTriangle(random)};
    pair.a[1] = pair.a[0] + Vector3(random.uniform(-kSize, kSize), 0, 0);
    pair.b[1] = pair.b[0] + Vector3(random.uniform(-kSize, kSize), 0, 0);
    return pair;
}

TrianglePair parallelPlates(Random& random) {
    return sometimesTurned(random, {flatTriangle(random, 0), flatTriangle(random, powerOfTen(random, 0, 9))});
}

TrianglePair standingPlate(Random& random) {
    Triangle standing = randomTriangle(random);
    for (Vector3& p : standing) p.x() = 20;
    const double height = powerOfTen(random, 0, 9);
    standing[0].z() = standing[1].z() = height;
    standing[2].z() = height + 100;
    return sometimesTurned(random, {flatTriangle(random, 0), standing});
}

TrianglePair crossingPlates(Random& random) {
    const Triangle lying = {Vector3(-100, -100, 0), Vector3(100, -100, 0), Vector3(0, 200, 0)};
    const double x = random.uniform(-50, 50);
    return sometimesTurned(random, {lying, {Vector3(x, 0, -10), Vector3(x, 0, 10), Vector3(x, 20, 5)}});
}

TrianglePair vertexOverFace(Random& random) {
    const double height = powerOfTen(random, 1, 9);
    const Triangle lying = {Vector3(-100, -100, 0), Vector3(100, -100, 0), Vector3(0, 200, 0)};
    const double x = random.uniform(-20, 20);
    return sometimesTurned(random,
                           {lying, {Vector3(x, 3, height), Vector3(x + 40, 0, 60), Vector3(x - 9, 50, 80)}});
}

TrianglePair smallCells(Random& random) {
    const double cell = std::array<double, 3>{1.7e-4, 1e-5, 1e-6}[random.below(3)];
    const Triangle lying = {Vector3(0, 0, 0), Vector3(cell, 0, 0), Vector3(0, cell, 0)};
    const double x = 0.3 * cell;
    return {lying, {Vector3(x, x, 0.1 * cell), Vector3(2 * cell, 0, cell), Vector3(0, 2 * cell, cell)}};
}

TrianglePair crossingEdges(Random& random) {
    const double height = powerOfTen(random, 0, 9);
    const double x = random.uniform(-50, 50), y = random.uniform(-50, 50);
    return sometimesTurned(random,
                           {{Vector3(-100, y, 0), Vector3(100, y, 0), Vector3(0, y + 3, -50)},
                            {Vector3(x, -90, height), Vector3(x, 120, height), Vector3(x + 9, 0, 70)}});
}

TrianglePair nearlyParallelEdges(Random& random) {
    const double angle = powerOfTen(random, 2, 10);
    const double height = random.below(2) == 0 ? 0 : powerOfTen(random, 0, 6);
    const double turn = 300 * angle;
    return sometimesTurned(
        random, {{Vector3(-200, 0, 0), Vector3(250, 0, 0), Vector3(0, 30, -90)},
                 {Vector3(-300, -turn, height), Vector3(300, turn, height), Vector3(20, -70, 80)}});
}

TrianglePair exactlyParallelEdges(Random& random) {
    const double offset = random.uniform(-600, 600);
    const double height = random.below(2) == 0 ? 0 : random.uniform(0, 5);
    return sometimesTurned(
        random, {{Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, -30, -90)},
                 {Vector3(offset - 80, height, 0), Vector3(offset + 90, height, 0), Vector3(20, 70, 80)}});
}

TrianglePair coplanar(Random& random) {
    TrianglePair pair{flatTriangle(random, 0), flatTriangle(random, 0)};
    const double shift = random.uniform(0, 900);
    for (Vector3& p : pair.b) p.x() += shift;
    return sometimesTurned(random, pair);
}

TrianglePair nearlyCoplanar(Random& random) {
    TrianglePair pair = coplanar(random);
    for (Vector3& p : pair.b) p.z() += random.uniform(-1e-9, 1e-9);
    return pair;
}

TrianglePair identical(Random& random) {
    const Triangle triangle = randomTriangle(random);
    return {triangle, triangle};
}

TrianglePair sharedVertex(Random& random) {
    TrianglePair pair{randomTriangle(random), randomTriangle(random)};
    pair.b[random.below(3)] = pair.a[random.below(3)];
    return pair;
}

TrianglePair sharedEdge(Random& random) {
    const double fold = random.below(2) == 0 ? powerOfTen(random, 0, 5) : random.uniform(0, 3.1415);
    const Vector3 tip(10, 80 * std::cos(fold), 80 * std::sin(fold));
    return sometimesTurned(random, {{Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, 90, 0)},
                                    {Vector3(100, 0, 0), Vector3(-100, 0, 0), tip}});
}

TrianglePair needles(Random& random) {
    const auto needle = [&] {
        Triangle triangle = randomTriangle(random);
        const Vector3 side =
            random.direction() * (triangle[1] - triangle[0]).norm() * powerOfTen(random, 1, 9);
        triangle[2] = triangle[0] + random.uniform(0, 1) * (triangle[1] - triangle[0]) + side;
        return triangle;
    };
    TrianglePair pair{needle(), needle()};
    if (random.below(2) == 0) {  // and near each other
        const Vector3 shift = pair.a[0] - pair.b[0] + random.direction() * powerOfTen(random, 0, 6);
        for (Vector3& p : pair.b) p += shift;
    }
    return pair;
}

TrianglePair segmentsAndPoints(Random& random) {
    TrianglePair pair{randomTriangle(random), randomTriangle(random)};
    for (Triangle* triangle : {&pair.a, &pair.b}) {
        const int kind = random.below(4);
        if (kind >= 1) (*triangle)[2] = (*triangle)[1];                                 // an edge of length 0
        if (kind == 2) (*triangle)[2] = 0.25 * (*triangle)[0] + 0.75 * (*triangle)[1];  // corners in a row
        if (kind == 3) (*triangle)[1] = (*triangle)[2] = (*triangle)[0];                // a point
    }
    return pair;
}

TrianglePair integerGrid(Random& random) {
    TrianglePair pair;
    for (Vector3& p : pair.a) p = Vector3(random.below(3), random.below(3), random.below(3));
    for (Vector3& p : pair.b) p = Vector3(random.below(3), random.below(3), random.below(3));
    return pair;
}

TrianglePair farFromOrigin(Random& random) {
    const double offset = 1 / powerOfTen(random, 3, 9);
    return movedBy({randomTriangle(random, 5), randomTriangle(random, 5)},
                   Pose{Matrix3::Identity(), offset * random.direction()});
}

TrianglePair mixedSizes(Random& random) {
    return {randomTriangle(random, 1e6 * random.uniform(0.5, 1)), randomTriangle(random, 1)};
}

TrianglePair tinyNumbers(Random& random) {
    TrianglePair pair = integerGrid(random);
    for (Vector3& p : pair.a) p = p * 5e-324 - Vector3(0.0, 1e-310, 0.0) * random.below(2);
    pair.b[0] = -0.0 * pair.b[0];
    return pair;
}

TrianglePair randomPair(Random& random) {
    return {randomTriangle(random), randomTriangle(random)};
}

}  // namespace

std::vector<TriangleFamily> hardTriangleFamilies() {
    return {{"random", randomPair},
            {"one edge of each along x", parallelEdges},
            {"parallel plates", parallelPlates},
            {"standing plate", standingPlate},
            {"crossing plates", crossingPlates},
            {"vertex over face", vertexOverFace},
            {"vertex over a small cell", smallCells},
            {"crossing edges", crossingEdges},
            {"nearly parallel edges", nearlyParallelEdges},
            {"exactly parallel edges", exactlyParallelEdges},
            {"coplanar", coplanar},
            {"nearly coplanar", nearlyCoplanar},
            {"identical", identical},
            {"shared vertex", sharedVertex},
            {"shared edge", sharedEdge},
            {"needles", needles},
            {"segments and points", segmentsAndPoints},
            {"integer grid", integerGrid},
            {"far from the origin", farFromOrigin},
            {"mixed sizes", mixedSizes},
            {"denormals", tinyNumbers}};
}

std::vector<KnownPair> knownTrianglePairs() {
    std::vector<KnownPair> pairs;
    const auto add = [&](const char* name, const Triangle& a, const Triangle& b, double distance) {
        pairs.push_back({name, {a, b}, distance});
    };
    add("PQP issue 4",
        {Vector3(8000.0000000000036, 6817.7672478170962, 571.00166381103077),
         Vector3(7500.0000000000009, 6817.7672478170962, 571.00166381103077),
         Vector3(7500.0000000000009, 6327.6345143037688, 571.00166381103077)},
        {Vector3(8000.0000000000009, 6327.6345143037670, 88.336618780016408),
         Vector3(7500.0, 6327.6345143037670, 88.336618780016408),
         Vector3(7500.0, 6327.6345143037670, 1015.9309593449836)},
        1.8189894035458565e-12);
    add("benardp/contours issue 1",
        {Vector3(12.3015, -0.253368, 5.49101), Vector3(18.6765, -2.55337, 4.91756),
         Vector3(12.3015, -2.55337, 4.91756)},
        {Vector3(-11.9885, -0.253368, 5.49101), Vector3(1.61448, -0.253368, 5.49101),
         Vector3(1.61448, -2.55337, 4.91756)},
        10.68702);
    add("ConvexBodyProximityQueries.jl issue 17",
        {Vector3(-0.37579435, 0.014414025, 0.3265663), Vector3(-0.37263185, 0.0108978925, 0.36118037),
         Vector3(-0.35647663, 0.03625821, 0.34328437)},
        {Vector3(0.23884095, -1.6477574, 0.116889484), Vector3(0.26891768, -1.6353351, 0.10821109),
         Vector3(0.26338503, -1.6657706, 0.10510237)},
        1.7844533437800496);
    const Vector3 point(1.10000002, -7.9000001, 16.5879993), doubled(-0.569999993, -8.10000038, 16.6070004);
    add("parry issue 76", {point, point, point},
        {Vector3(2.27699995, -7.9000001, 16.3180008), doubled, doubled}, 0.17147826590144152);
    add("geogram issue 10",
        {Vector3(1898.68, 775, 1158.48), Vector3(2000, 775, 1166.7), Vector3(1898.68, 675, 1148.6)},
        {Vector3(1966.41, 675, 1163.79), Vector3(1971.63, 675, 1166.95), Vector3(1967.56, 684.554, 1166.67)},
        42.989017651687853);
    const Triangle flat = {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
    add("vertex over the face", flat, {Vector3(1, 1, 0.5), Vector3(1, 9, 3), Vector3(9, 1, 3)}, 0.5);
    add("crossing edges", flat, {Vector3(2, -3, 2), Vector3(2, 3, 2), Vector3(2, 0, 9)}, 2);
    add("edge beside edge", flat, {Vector3(1, -3, 4), Vector3(9, -3, 4), Vector3(5, -9, 4)}, 5);
    add("vertex to vertex", flat, {Vector3(6, -3, 6), Vector3(7, -4, 9), Vector3(9, -3, 7)}, 7);
    add("coplanar", flat, {Vector3(-3, 1, 0), Vector3(-3, 2, 0), Vector3(-9, 1, 0)}, 3);
    return pairs;
}

Mesh meshOf(const Triangle& triangle) {
    Mesh mesh;
    mesh.vertices.assign(triangle.begin(), triangle.end());
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

}  // namespace clearway::testing
