// A ray's crossing is that of exact arithmetic, also along edges, through corners and a rounding beside them.
#include "exact/ray_crossing.h"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(ray_crossing_test)

using namespace clearway;
using namespace clearway::testing;

using Integer = boost::multiprecision::cpp_int;
using Point = std::array<Integer, 3>;

constexpr std::uint64_t kSeed = 61;

/// The number times 2^2400, which is whole: a double is a multiple of 2^-1074.
Integer scaled(double number) {
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), 53));
    return Integer(digits) << (exponent - 53 + 2400);
}

Integer cross(const Point& a, const Point& b, int i, int j) {
    return a[i] * b[j] - a[j] * b[i];
}

/// The sides of the edges are those of the point moved by (e, e^2), where e = 2^-1200 is below all other differences.
int slowCrossing(const Vector3& origin, const std::array<Vector3, 3>& corners) {
    const Integer e = Integer(1) << 1200, squared = 1;  // both scaled
    std::array<Point, 3> d, moved;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) d[k][i] = scaled(corners[k][i]) - scaled(origin[i]);
        moved[k] = {d[k][0] - e, d[k][1] - squared, d[k][2]};
    }
    std::array<int, 3> sides;
    for (int k = 0; k < 3; ++k) sides[k] = cross(moved[k], moved[(k + 1) % 3], 0, 1).sign();
    if (sides[0] == 0 || sides[0] != sides[1] || sides[1] != sides[2]) return 0;
    Point u, v;
    for (int i = 0; i < 3; ++i) {
        u[i] = d[1][i] - d[0][i];
        v[i] = d[2][i] - d[0][i];
    }
    const Integer height =
        d[0][0] * cross(u, v, 1, 2) + d[0][1] * cross(u, v, 2, 0) + d[0][2] * cross(u, v, 0, 1);
    return height.sign() == sides[0] ? sides[0] : 0;
}

/// A number that often equals another one, or is a rounding beside it.
double nearWhole(Random& random) {
    const double whole = random.below(5) - 2;
    const int kind = random.below(4);
    return kind == 0 ? random.uniform(-2, 2) : kind == 1 ? whole + 0x1p-51 : whole;
}

Vector3 nearGrid(Random& random) {
    return {nearWhole(random), nearWhole(random), nearWhole(random)};
}

BOOST_AUTO_TEST_CASE(a_crossing_is_that_of_exact_arithmetic) {
    Random random(kSeed);
    int crossed = 0;
    for (int round = 0; round < 20000; ++round) {
        const double unit = std::ldexp(1.0, round % 10 == 0 ? random.below(640) - 320 : 0);
        const std::array<Vector3, 3> corners{unit * nearGrid(random), unit * nearGrid(random),
                                             unit * nearGrid(random)};
        Vector3 origin = unit * nearGrid(random);
        if (random.below(3) == 0) {
            const double s = 0.25 * random.below(5), t = 0.25 * random.below(5);
            origin = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
        }
        const Pose still;
        const int found = ZRay(still, still, origin).crossing({&corners[0], &corners[1], &corners[2]});
        BOOST_TEST(found == slowCrossing(origin, corners), "seed " << kSeed << ", round " << round);
        crossed += found != 0;
    }
    BOOST_TEST(crossed > 500);
}

// A quarter turn about z and a shift by whole numbers are exact in double. What is next to an edge of the turned mesh is decided as
// beside the mesh itself.
BOOST_AUTO_TEST_CASE(a_crossing_of_moved_bodies_is_that_of_bodies_at_rest) {
    Random random(kSeed);
    Pose X;
    X.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    X.translation = {4, -8, 16};
    const Pose still;
    int crossed = 0;
    for (int round = 0; round < 20000; ++round) {
        const std::array<Vector3, 3> corners{nearGrid(random), nearGrid(random), nearGrid(random)};
        const Vector3 origin = nearGrid(random);
        const CornerPointers pointers{&corners[0], &corners[1], &corners[2]};
        const int found = ZRay(still, still, origin).crossing(pointers);
        BOOST_TEST(ZRay(X, X, origin).crossing(pointers) == found, "seed " << kSeed << ", round " << round);
        crossed += found != 0;
    }
    BOOST_TEST(crossed > 500);
}

BOOST_AUTO_TEST_SUITE_END()
