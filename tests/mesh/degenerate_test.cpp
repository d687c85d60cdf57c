#include "mesh/clean.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(degenerate_test)

using testing::Random;

/// A multiple of a direction of small whole numbers, exact in double.
Vector3 onLine(Random& random, const Vector3& direction, int exponent) {
    const double mantissa = std::floor(random.uniform(-1, 1) * std::ldexp(1.0, 40)) + 0.5;
    return std::ldexp(mantissa, exponent - 40 + random.below(30)) * direction;
}

BOOST_AUTO_TEST_CASE(three_points_on_a_line_are_degenerate_whatever_the_scale) {
    const Vector3 direction(3, -5, 7);
    for (const int exponent : {-1070, -540, -300, -20, 0, 30, 500, 1015}) {
        BOOST_TEST_CONTEXT("scale 2^" << exponent) {
            const double scale = std::ldexp(1.0, exponent);
            const Vector3 start = scale * Vector3(1, 2, -4);
            BOOST_TEST(isDegenerate(start, start + scale * direction, start + 3 * scale * direction));
            BOOST_TEST(!isDegenerate(start, start + scale * direction,
                                     start + 3 * scale * direction + scale * Vector3::UnitY()));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_needle_that_rounding_would_flatten_has_an_area) {
    // The first two products of the cross product differ but round to one double.
    const double tiny = std::ldexp(1.0, -52);
    BOOST_TEST(!isDegenerate({0, 0, 0}, {1, 1 + tiny, 0}, {1 - tiny, 1, 0}));
    // In binary, 0.1, 0.2 and 0.3 are not multiples of one another.
    BOOST_TEST(isDegenerate({0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}));
    BOOST_TEST(!isDegenerate({0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}));
    // One unit in the last place off a line that runs far from the origin.
    BOOST_TEST(isDegenerate({1e9, 1e9, 0}, {1e9 + 1, 1e9 + 1, 0}, {1e9 + 2, 1e9 + 2, 0}));
    BOOST_TEST(
        !isDegenerate({1e9, 1e9, 0}, {1e9 + 1, 1e9 + 1, 0}, {1e9 + 2, std::nextafter(1e9 + 2, 2e9), 0}));
    // Differences that no double represents.
    BOOST_TEST(isDegenerate({1, 1, 0}, {0, 0, 0}, {1e-300, 1e-300, 0}));
    BOOST_TEST(!isDegenerate({1, 1, 0}, {0, 0, 0}, {1e-300, 2e-300, 0}));
    // Products that underflow.
    BOOST_TEST(!isDegenerate({0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}));
    BOOST_TEST(!isDegenerate({0, 0, 0}, {5e-324, 0, 0}, {0, 0, 5e-324}));
    // Products that overflow.
    BOOST_TEST(!isDegenerate({-1e308, 0, 0}, {1e308, 1e308, 0}, {1e308, 0, 0}));
    BOOST_TEST(isDegenerate({-1e308, -1e308, 0}, {1e308, 1e308, 0}, {0, 0, 0}));
}

BOOST_AUTO_TEST_CASE(a_line_is_told_from_a_needle_of_one_unit_in_the_last_place) {
    // No double represents the differences of the points, so the cross product of the rounded differences is
    // not zero.
    for (const int exponent : {-900, -540, -530, -520, -300, 0, 300, 900}) {
        BOOST_TEST_CONTEXT("seed 1, scale 2^" << exponent) {
            Random random(1);
            int wrong = 0;
            for (int i = 0; i < 2000; ++i) {
                const auto number = [&] { return (random.below(2) ? 1.0 : -1.0) * (1 + random.below(50)); };
                const double x = number(), y = number(), z = number();
                const Vector3 direction(x, y, z);
                const Vector3 a = onLine(random, direction, exponent);
                const Vector3 b = onLine(random, direction, exponent);
                Vector3 c = onLine(random, direction, exponent);
                wrong += isDegenerate(a, b, c) ? 0 : 1;
                c.y() = std::nextafter(c.y(), 0);
                wrong += a != b && isDegenerate(a, b, c) ? 1 : 0;
            }
            BOOST_TEST(wrong == 0);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
