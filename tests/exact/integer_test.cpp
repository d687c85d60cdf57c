// Integers hold doubles, their fractions, the roots of fractions and moved points exactly.
#include "exact/integer.h"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "exact/ball.h"
#include "support/exact_distance.h"
#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(integer_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 12;

double drawAnySize(Random& random) {
    return std::ldexp(random.uniform(-1, 1), int(random.uniform(-1080, 1020)));
}

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
        // Draws integers of up to thousands of digits.
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
    BOOST_TEST(quotient(Integer(0), Integer(7)) == 0);
    BOOST_TEST(rootBounds(0, 7, 3).upper == 0);
    BOOST_TEST(std::isinf(rootBounds(1, 0, 3).lower));
    BOOST_TEST(rootBounds(1, 1, -2000).upper > 0);  // only the root of 0 is 0
}

BOOST_AUTO_TEST_CASE(moved_points_are_exact) {
    constexpr std::uint64_t kMovedSeed = 14;
    Random random(kMovedSeed);
    for (int round = 0; round < 500; ++round) {
        const bool isSimple = round % 3 == 0;
        Pose X = isSimple ? Pose{} : random.pose(100);
        if (round % 5 == 0) X.translation = {0, std::ldexp(1.0, int(random.uniform(-300, 300))), -3};
        Vector3 point(random.uniform(-1, 1), std::floor(random.uniform(-9, 9)), random.uniform(-1e6, 1e6));
        if (round % 7 == 0) point.setZero();
        std::array<Rational, 3> exact;
        for (int k = 0; k < 3; ++k) {
            exact[k] = Rational(X.translation[k]);
            for (int j = 0; j < 3; ++j) exact[k] += Rational(X.rotation(k, j)) * Rational(point[j]);
        }
        const Triple<Ball> ball = movedBall(X, point);
        const int exponent = lastBitOf(X, point) - (round % 4);
        const Triple<Integer> whole = movedInteger(X, point, exponent);
        const Ball* balls[3] = {&ball.x, &ball.y, &ball.z};
        const Integer* wholes[3] = {&whole.x, &whole.y, &whole.z};
        BOOST_TEST_CONTEXT("seed " << kMovedSeed << ", round " << round) {
            for (int k = 0; k < 3; ++k) {
                const Rational off = exact[k] - Rational(balls[k]->high) - Rational(balls[k]->low);
                BOOST_TEST((abs(off) <= Rational(balls[k]->error)));
                const Rational scaled = Rational(boost::multiprecision::cpp_int(*wholes[k]));
                BOOST_TEST((scaled * Rational(std::ldexp(1.0, exponent)) == exact[k]));
                if (isSimple && round % 5 != 0) BOOST_TEST(balls[k]->error == 0);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
