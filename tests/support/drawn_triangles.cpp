// Triangle pairs whose distance the oracle has to find.
#include <algorithm>
#include <cmath>

#include "support/hard_triangle_draws.h"

namespace clearway::testing {
namespace {

Triangle flatTriangle(Random& random, double z) {
    Triangle triangle = randomTriangle(random);
    for (Vector3& p : triangle) p.z() = z;
    return triangle;
}

TrianglePair coplanar(Random& random) {
    TrianglePair pair{flatTriangle(random, 0), flatTriangle(random, 0)};
    const double shift = random.uniform(0, 900);
    for (Vector3& p : pair.b) p.x() += shift;
    return pair;
}

/// Brings half of the draws near each other.
TrianglePair sometimesNear(Random& random, TrianglePair pair) {
    if (random.below(2) == 0) {
        const Vector3 shift = pair.a[0] - pair.b[0] + random.direction() * powerOfTen(random, 0, 6);
        for (Vector3& p : pair.b) p += shift;
    }
    return pair;
}

/// A triangle whose third corner is beside a random edge, by 1e-1 .. 1e-9 of the edge's length.
Triangle flatAt(Random& random, double share) {
    Triangle triangle = randomTriangle(random);
    const Vector3 edge = triangle[1] - triangle[0];
    triangle[2] = triangle[0] + share * edge + random.direction() * edge.norm() * powerOfTen(random, 1, 9);
    return triangle;
}

Vector3 gridPoint(Random& random, int end) {
    const double x = random.below(end), y = random.below(end);
    return {x, y, double(random.below(end))};
}

/// Replaces triangles one after another: always the first, and the second in half of the draws.
template <class Make>
TrianglePair oneOrBoth(Random& random, const Make& make) {
    TrianglePair pair{make(), randomTriangle(random)};
    if (random.below(2) == 0) pair.b = make();
    if (random.below(2) == 0) std::swap(pair.a, pair.b);
    return sometimesNear(random, pair);
}

TrianglePair randomPair(Random& random) {
    return {randomTriangle(random), randomTriangle(random)};
}

TrianglePair edgesAlongX(Random& random) {
    TrianglePair pair = randomPair(random);
    pair.a[1] = pair.a[0] + Vector3(random.uniform(-kDrawSize, kDrawSize), 0, 0);
    pair.b[1] = pair.b[0] + Vector3(random.uniform(-kDrawSize, kDrawSize), 0, 0);
    return pair;
}

TrianglePair coplanarTurned(Random& random) {
    return sometimesTurned(random, coplanar(random));
}

TrianglePair nearlyCoplanar(Random& random) {
    TrianglePair pair = coplanar(random);
    for (Vector3& p : pair.b) p.z() += random.uniform(-1e-9, 1e-9);
    return sometimesTurned(random, pair);
}

TrianglePair needles(Random& random) {
    const Triangle a = flatAt(random, 0), b = flatAt(random, 0);
    return sometimesNear(random, {a, b});
}

TrianglePair caps(Random& random) {
    const Triangle a = flatAt(random, random.uniform(0.1, 0.9)), b = flatAt(random, random.uniform(0.1, 0.9));
    return sometimesNear(random, {a, b});
}

TrianglePair segments(Random& random) {
    return oneOrBoth(random, [&] {  // integers put the corners in a row exactly
        const Vector3 from = gridPoint(random, 900) - Vector3::Constant(450), way = gridPoint(random, 200);
        return Triangle{from, from + 4 * way, from + random.below(5) * way};
    });
}

TrianglePair points(Random& random) {
    return oneOrBoth(random, [&] {
        const Vector3 point = random.inBox(kDrawSize);
        return Triangle{point, point, point};
    });
}

TrianglePair zeroLengthEdges(Random& random) {
    return oneOrBoth(random, [&] {
        Triangle triangle = randomTriangle(random);
        triangle[random.below(3)] = triangle[random.below(3)];
        return triangle;
    });
}

TrianglePair integerGrid(Random& random) {
    TrianglePair pair;
    for (Vector3& p : pair.a) p = gridPoint(random, 3);
    for (Vector3& p : pair.b) p = gridPoint(random, 3);
    return pair;
}

TrianglePair farFromOrigin(Random& random) {
    const double offset = 1 / powerOfTen(random, 3, 9);
    const Triangle a = randomTriangle(random, 5), b = randomTriangle(random, 5);
    return movedBy({a, b}, Pose{Matrix3::Identity(), offset * random.direction()});
}

TrianglePair scaledGrid(Random& random) {
    TrianglePair pair = random.below(2) == 0 ? integerGrid(random) : randomPair(random);
    const double scale = std::ldexp(1.0, std::array<int, 4>{-60, -20, 20, 60}[random.below(4)]);
    for (Triangle* triangle : {&pair.a, &pair.b}) {
        for (Vector3& p : *triangle) p *= scale;
    }
    return pair;
}

TrianglePair mixedSizes(Random& random) {
    const Triangle a = randomTriangle(random, 1e6 * random.uniform(0.5, 1));
    return {a, randomTriangle(random, 1)};
}

TrianglePair zerosAndDenormals(Random& random) {
    TrianglePair pair = integerGrid(random);
    for (Triangle* triangle : {&pair.a, &pair.b}) {
        for (Vector3& p : *triangle) {
            for (double& x : p) {
                if (x == 0) x = std::array<double, 5>{0.0, -0.0, 5e-324, -5e-324, 1e-310}[random.below(5)];
            }
        }
    }
    return pair;
}

TrianglePair wholeDenormals(Random& random) {
    TrianglePair pair = integerGrid(random);
    for (Vector3& p : pair.a) p = p * 5e-324 - Vector3(0.0, 1e-310, 0.0) * random.below(2);
    pair.b[0] = -0.0 * pair.b[0];
    return pair;
}

TrianglePair cornerInPlane(Random& random) {
    // Routines that decide by signs of determinants call some of these touching: a corner of one triangle
    // lies in the other's plane but beside the other, and coordinates repeat.
    const double z = random.uniform(-10, 10), y0 = random.uniform(-10, 0), y1 = y0 - random.uniform(1, 5);
    const double right = random.uniform(2, 14), left = right - random.uniform(1e-3, 12);
    return {{Vector3(right, y0, z), Vector3(right + random.uniform(0, 9), y1, z - random.uniform(0.1, 2)),
             Vector3(right, y1, z - random.uniform(0.1, 2))},
            {Vector3(left - random.uniform(1, 14), y0, z), Vector3(left, y0, z), Vector3(left, y1, z)}};
}

}  // namespace

std::vector<TriangleFamily> drawnFamilies() {
    return {{0, "random", randomPair},
            {2, "one edge of each along x", edgesAlongX},
            {17, "coplanar turned", coplanarTurned},
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

}  // namespace clearway::testing
