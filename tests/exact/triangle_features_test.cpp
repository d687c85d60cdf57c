// The least distance over all features is the triangles' distance, for degenerate triangles too, and the
// reported places are that far apart.
#include "exact/triangle_features.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/exact_distance.h"
#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(triangle_features_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 13;

using Corners = std::array<Vector3, 3>;

template <class Number>
Number numberOf(double x);
template <>
Ball numberOf<Ball>(double x) {
    return x;
}
template <>
Integer numberOf<Integer>(double x) {
    return scaledInteger(x, 0);
}

LengthBounds rootOfFraction(const Ball& numerator, const Ball& denominator) {
    return rootBounds(numerator, denominator);
}
LengthBounds rootOfFraction(const Integer& numerator, const Integer& denominator) {
    return rootBounds(numerator, denominator, 0);
}

template <class Number>
struct Least {
    bool wants(const Number& numerator, const Number& denominator) {
        offered = rootOfFraction(numerator, denominator);
        return offered.lower < upper;
    }
    template <class Place>
    void take(Verdict feasible, int /*feature*/, const Place& onA, const Place& onB) {
        if (feasible == Verdict::no) return;
        lower = std::min(lower, offered.lower);
        if (feasible == Verdict::open || !(offered.upper < upper)) return;
        upper = offered.upper;
        const auto pointOf = [](const Corners& triangle, const Place& place) {
            const Vector3 corner = triangle[place.corner];
            return Vector3(corner +
                           quotient(place.s, place.whole) * (triangle[(place.corner + 1) % 3] - corner) +
                           quotient(place.t, place.whole) * (triangle[(place.corner + 2) % 3] - corner));
        };
        apart = (pointOf(a, onA) - pointOf(b, onB)).norm();
    }
    bool done() const { return false; }

    Corners a, b;
    LengthBounds offered{};
    double lower = std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    double apart = 0;
};

template <class Number>
Least<Number> leastOf(const Corners& a, const Corners& b) {
    const auto numbersOf = [](const Corners& triangle) {
        typename TriangleFeatures<Number>::Corners corners;
        for (int k = 0; k < 3; ++k) {
            corners[k] = {numberOf<Number>(triangle[k][0]), numberOf<Number>(triangle[k][1]),
                          numberOf<Number>(triangle[k][2])};
        }
        return corners;
    };
    Least<Number> least;
    least.a = a;
    least.b = b;
    TriangleFeatures<Number>(numbersOf(a), numbersOf(b)).visit(least);
    return least;
}

// On a coarse grid most triangles touch, lie in one plane, are parallel or have no area.
BOOST_AUTO_TEST_CASE(triangles_on_a_grid_have_their_exact_distance) {
    Random random(kSeed);
    for (const double cells : {2.0, 3.0, 40.0, 1e9}) {
        int contacts = 0;
        for (int round = 0; round < 1000; ++round) {
            const auto draw = [&] {
                Corners triangle;
                for (Vector3& corner : triangle) {
                    for (int k = 0; k < 3; ++k) corner[k] = std::floor(random.uniform(0, cells + 1));
                }
                return triangle;
            };
            const Corners a = draw(), b = draw();
            const ExactDistance exact = exactDistance(a, b);
            const Rational squared = exact.squared();
            const auto square = [](double x) { return Rational(x) * Rational(x); };
            const Least<Integer> whole = leastOf<Integer>(a, b);
            const Least<Ball> ball = leastOf<Ball>(a, b);
            contacts += squared == 0;
            BOOST_TEST_CONTEXT("seed " << kSeed << ", grid of " << cells << ", round " << round
                                       << ", distance " << exact.rounded()) {
                BOOST_TEST((square(whole.lower) <= squared && square(whole.upper) >= squared));
                BOOST_TEST(whole.upper - whole.lower <= 0x1p-49 * whole.upper);
                BOOST_TEST(std::abs(whole.apart - whole.upper) <= 1e-14 * cells);
                BOOST_TEST((whole.upper == 0) == (squared == 0));
                BOOST_TEST((square(ball.lower) <= squared && square(ball.upper) >= squared));
                if (ball.upper == 0) BOOST_TEST((squared == 0));
            }
        }
        BOOST_TEST(contacts > (cells < 10 ? 100 : 10));
    }
}

BOOST_AUTO_TEST_SUITE_END()
