#include "exact/integer.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/exact_triangle.h"
#include "support/random_meshes.h"

using namespace clearway;
using namespace clearway::testing;

namespace {

constexpr std::uint64_t kSeed = 12;

double drawAnySize(Random& random) {
    return std::ldexp(random.uniform(-1, 1), int(random.uniform(-1080, 1020)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_double_is_a_whole_multiple_of_its_last_bit) {
    BOOST_TEST(lastBitOf(1) == 0);
    BOOST_TEST(lastBitOf(-6) == 1);
    BOOST_TEST(lastBitOf(0.75) == -2);
    BOOST_TEST(lastBitOf(std::numeric_limits<double>::denorm_min()) == -1074);
    BOOST_TEST(lastBitOf(std::numeric_limits<double>::max()) == 971);
    Random random(kSeed);
    for (int round = 0; round < 2000; ++round) {
        const double x = drawAnySize(random);
        if (x == 0) continue;
        const int last = lastBitOf(x);
        const double odd = std::ldexp(x, -last);
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round << ", " << x) {
            BOOST_TEST(std::fmod(std::abs(odd), 2) == 1);
            BOOST_TEST((scaledInteger(x, last) == Integer(static_cast<long long>(odd))));
            BOOST_TEST((scaledInteger(x, last - 70) == Integer(static_cast<long long>(odd)) << 70));
        }
    }
    BOOST_TEST((scaledInteger(0, 5) == 0));
}

BOOST_AUTO_TEST_CASE(quotients_and_roots_are_those_of_the_fractions) {
    Random random(kSeed);
    for (int round = 0; round < 2000; ++round) {
        // Up to thousands of digits.
        const auto draw = [&] {
            Integer value = scaledInteger(random.uniform(-1, 1), -60);
            for (int k = int(random.uniform(0, 40)); k > 0; --k)
                value = value * scaledInteger(random.uniform(1, 2), -52) + k;
            return value;
        };
        const Integer a = draw(), b = draw();
        if (a == 0 || b == 0) continue;
        const Rational exact =
            Rational(boost::multiprecision::cpp_int(a)) / Rational(boost::multiprecision::cpp_int(b));
        const double found = quotient(a, b);
        if (std::isinf(found) || std::abs(found) < 1e-300) continue;
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
            BOOST_TEST((abs(Rational(found) - exact) <= abs(exact) * Rational(4 * 0x1p-53)));
            const int exponent = int(random.uniform(-40, 40));
            const LengthBounds root = rootBounds(abs(a), abs(b), exponent);
            const Rational square = abs(exact) * Rational(std::ldexp(1.0, 2 * exponent));
            BOOST_TEST((Rational(root.lower) * Rational(root.lower) <= square));
            BOOST_TEST((Rational(root.upper) * Rational(root.upper) >= square));
            BOOST_TEST(root.upper - root.lower <= 12 * 0x1p-53 * root.upper);
        }
    }
    BOOST_TEST(quotient(0, 7) == 0);
    BOOST_TEST(rootBounds(0, 7, 3).upper == 0);
    BOOST_TEST(std::isinf(rootBounds(1, 0, 3).lower));
    BOOST_TEST(rootBounds(1, 1, -2000).upper > 0);  // only a root of 0 is 0
}
