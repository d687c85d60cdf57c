// Triangle pairs whose distance is known in closed form. Coordinates are chosen so that the distance is
// exact; turned pairs are off it by the rounding of their corners.
#include <algorithm>
#include <cmath>

#include "support/hard_triangle_draws.h"

namespace clearway::testing {
namespace {

/// A triangle in z = 0 around the origin, which contains a circle of radius 40 about the origin.
const Triangle kLying = {Vector3(-100, -100, 0), Vector3(100, -100, 0), Vector3(0, 200, 0)};

/// A multiple of 1/16 in [low, high], so that sums and middles of a few of them are exact.
double sixteenth(Random& random, int low, int high) {
    return low + random.below(16 * (high - low) + 1) / 16.0;
}

/// Moves both triangles together, corner by corner, so that shared corners stay shared.
TrianglePair touching(Random& random, const Triangle& a, const Triangle& b) {
    return sometimesTurned(random, {a, b, 0});
}

/// Moves pairs whose contact survives the rounding of their corners.
TrianglePair surelyTouching(Random& random, const Triangle& a, const Triangle& b) {
    TrianglePair pair = touching(random, a, b);
    pair.statedWithin = 0;
    return pair;
}

}  // namespace

Triangle randomTriangle(Random& random, double halfSide) {
    const Vector3 a = random.inBox(halfSide), b = random.inBox(halfSide);
    return {a, b, random.inBox(halfSide)};
}

double powerOfTen(Random& random, int low, int high) {
    return std::pow(10.0, -(low + random.below(high - low + 1)));
}

TrianglePair movedBy(const TrianglePair& pair, const Pose& pose) {
    TrianglePair moved = pair;
    double largest = 0;
    for (Triangle* triangle : {&moved.a, &moved.b}) {
        for (Vector3& corner : *triangle) {
            largest = std::max(largest, corner.cwiseAbs().maxCoeff());
            corner = pose * corner;
            largest = std::max(largest, corner.cwiseAbs().maxCoeff());
        }
    }
    // A coordinate is off by 4 roundings of up to 3 times the largest coordinate, each triangle by sqrt 3 of
    // that, and both by the rotation's own defect.
    moved.statedWithin += 64 * 0x1p-53 * largest;
    return moved;
}

TrianglePair sometimesTurned(Random& random, const TrianglePair& pair) {
    return random.below(2) == 0 ? pair : movedBy(pair, random.pose(kDrawSize));
}

namespace {

TrianglePair smallCells(Random& random) {
    const double cell = std::array<double, 3>{1.7e-4, 1e-5, 1e-6}[random.below(3)];
    const Triangle lying = {Vector3(0, 0, 0), Vector3(cell, 0, 0), Vector3(0, cell, 0)};
    const double x = 0.3 * cell, height = 0.1 * cell;
    return {lying, {Vector3(x, x, height), Vector3(2 * cell, 0, cell), Vector3(0, 2 * cell, cell)}, height};
}

TrianglePair parallelPlates(Random& random) {
    const double height = powerOfTen(random, 0, 9);
    Triangle above = randomTriangle(random, 200);
    const double x = above[0].x(), y = above[0].y();
    for (Vector3& p : above) p = Vector3(p.x() - x, p.y() - y, height);
    return sometimesTurned(random, {kLying, above, height});
}

TrianglePair crossingPlates(Random& random) {
    const double x = random.uniform(-50, 50);
    return surelyTouching(random, kLying, {Vector3(x, 0, -10), Vector3(x, 0, 10), Vector3(x, 20, 5)});
}

TrianglePair axisAlignedPiercing(Random& random) {
    // One triangle has legs along two axes; an edge of the other, along the third axis, goes through it.
    const Vector3 corner = random.inBox(kDrawSize);
    const double width = random.uniform(1, 400), depth = random.uniform(1, 400);
    const Triangle lying = {corner, corner + Vector3(width, 0, 0), corner + Vector3(0, depth, 0)};
    const Vector3 through = corner + Vector3(random.uniform(0.05, 0.45) * width, 0.5 * depth, 0);
    const Vector3 low = through - Vector3(0, 0, random.uniform(0.5, 300));
    const Vector3 high(through.x(), through.y(), corner.z() + random.uniform(0.5, 300));
    return {lying, {low, high, low + Vector3(0, random.uniform(-400, 400), 0)}, 0};
}

TrianglePair standingPlate(Random& random) {
    const double height = powerOfTen(random, 0, 9);
    const double y = random.uniform(-30, 30);
    return sometimesTurned(
        random, {kLying,
                 {Vector3(20, y, height), Vector3(20, random.uniform(-kDrawSize, kDrawSize), height),
                  Vector3(20, random.uniform(-kDrawSize, kDrawSize), height + 100)},
                 height});
}

TrianglePair vertexOverFace(Random& random) {
    const double height = powerOfTen(random, 1, 9);
    const double x = random.uniform(-20, 20);
    return sometimesTurned(
        random, {kLying, {Vector3(x, 3, height), Vector3(x + 40, 0, 60), Vector3(x - 9, 50, 80)}, height});
}

TrianglePair crossingEdges(Random& random) {
    const double height = powerOfTen(random, 0, 9);
    const double x = random.uniform(-50, 50), y = random.uniform(-50, 50);
    return sometimesTurned(random, {{Vector3(-100, y, 0), Vector3(100, y, 0), Vector3(0, y + 3, -50)},
                                    {Vector3(x, -90, height), Vector3(x, 120, height), Vector3(x + 9, 0, 70)},
                                    height});
}

TrianglePair vertexToVertex(Random& random) {
    // Integers whose norm is an integer, and corners that all lie behind.
    const std::array<Vector3, 4> ways = {Vector3(1, 2, 2), Vector3(2, 3, 6), Vector3(-6, 7, 6),
                                         Vector3(2, -6, 9)};
    const std::array<double, 4> norms = {3, 7, 11, 11};
    const int which = random.below(4);
    const double scale = 1 + random.below(40);
    const Vector3 way = scale * ways[which];
    const auto behind = [&] {
        Vector3 offset(random.below(61) - 30, random.below(61) - 30, random.below(61) - 30);
        if (offset.dot(way) < 0) offset = -offset;
        return offset;
    };
    const Vector3 from(random.below(200), random.below(200), random.below(200)), to = from + way;
    return sometimesTurned(
        random,
        {{from, from - behind(), from - behind()}, {to + behind(), to, to + behind()}, scale * norms[which]});
}

TrianglePair vertexToEdge(Random& random) {
    const double scale = std::ldexp(1.0, -random.below(30)), x = sixteenth(random, -90, 90);
    const Vector3 corner(x, 3 * scale, 4 * scale);
    return sometimesTurned(random, {{Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, -50, -60)},
                                    {corner, corner + Vector3(20, 10, 5), corner + Vector3(-9, 0, 40)},
                                    5 * scale});
}

TrianglePair nearlyParallelEdges(Random& random) {
    const double angle = powerOfTen(random, 2, 10);
    const double height = random.below(2) == 0 ? 0 : powerOfTen(random, 0, 6);
    const double turn = 300 * angle;
    return sometimesTurned(random,
                           {{Vector3(-200, 0, 0), Vector3(250, 0, 0), Vector3(0, 30, -90)},
                            {Vector3(-300, -turn, height), Vector3(300, turn, height), Vector3(20, -70, 80)},
                            height});
}

TrianglePair exactlyParallelEdges(Random& random) {
    // Beside each other, one beyond the other's end, and in one line.
    const double offset = sixteenth(random, -600, 600);
    const double height = random.below(2) == 0 ? 0 : sixteenth(random, 0, 5);
    const double between = std::max({0.0, offset - 80 - 100, -100 - (offset + 90)});
    return sometimesTurned(random, {{Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, -30, -90)},
                                    {Vector3(offset - 80, height, 0), Vector3(offset + 90, height, 0),
                                     Vector3(offset + 5, 70, 80)},
                                    std::hypot(between, height)});
}

TrianglePair coplanarApart(Random& random) {
    const double gap = powerOfTen(random, 0, 9) * (1 + random.below(9));
    return sometimesTurned(random, {{Vector3(0, -50, 0), Vector3(0, 50, 0), Vector3(-80, 7, 0)},
                                    {Vector3(gap, random.uniform(-40, 40), 0),
                                     Vector3(gap + random.uniform(1, 90), random.uniform(-90, 90), 0),
                                     Vector3(gap + random.uniform(1, 90), random.uniform(-90, 90), 0)},
                                    gap});
}

TrianglePair coplanarNested(Random& random) {
    Triangle within;
    for (Vector3& p : within) p = Vector3(random.uniform(-25, 25), random.uniform(-25, 25), 0);
    return touching(random, kLying, within);
}

TrianglePair coplanarEdgeTouch(Random& random) {
    const double x = random.uniform(-90, 40);
    return touching(random, {Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, -70, 0)},
                    {Vector3(x, 0, 0), Vector3(x + random.uniform(1, 90), 0, 0), Vector3(x + 20, 60, 0)});
}

TrianglePair identical(Random& random) {
    const Triangle triangle = randomTriangle(random);
    return {triangle, triangle, 0};
}

TrianglePair sharedVertex(Random& random) {
    TrianglePair pair{randomTriangle(random), randomTriangle(random), 0};
    pair.b[random.below(3)] = pair.a[random.below(3)];
    return pair;
}

TrianglePair sharedEdge(Random& random) {
    // From 0.001 degrees to flat; 0 is folded onto itself.
    const std::array<double, 4> folds = {powerOfTen(random, 0, 5), random.uniform(0, 3.1415), 0, 1.7453e-5};
    const double fold = folds[random.below(4)];
    const Vector3 tip(10, 80 * std::cos(fold), 80 * std::sin(fold)), flat(10, -80, 0);
    return surelyTouching(random, {Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, 90, 0)},
                          {Vector3(100, 0, 0), Vector3(-100, 0, 0), random.below(8) == 0 ? flat : tip});
}

TrianglePair tJunction(Random& random) {
    const double x = sixteenth(random, -99, 99);
    return touching(random, {Vector3(-100, 0, 0), Vector3(100, 0, 0), Vector3(0, 90, 20)},
                    {Vector3(x, 0, 0), Vector3(x + 40, -70, 9), Vector3(x - 30, -60, 30)});
}

}  // namespace

std::vector<TriangleFamily> statedFamilies() {
    return {{3, "vertex over a small cell", smallCells},
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
            {18, "identical", identical},
            {19, "shared vertex", sharedVertex},
            {20, "shared edge", sharedEdge},
            {21, "T-junction", tJunction}};
}

}  // namespace clearway::testing
