// A ball holds the exact value, has error 0 only when it equals that value, and never decides a sign wrongly.
#include "exact/ball.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "support/exact_distance.h"
#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(ball_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 11;

struct Tracked {
    Ball ball;
    Rational exact;
};

bool holds(const Tracked& x) {
    const Rational off = x.exact - Rational(x.ball.high) - Rational(x.ball.low);
    return abs(off) <= Rational(x.ball.error);
}

// Draws a number of any size, with few digits or with all 53.
Tracked draw(Random& random) {
    const int kind = int(random.uniform(0, 4));
    const double value = kind == 0   ? std::floor(random.uniform(-4, 4))
                         : kind == 1 ? std::ldexp(std::floor(random.uniform(-1000, 1000)), -8)
                         : kind == 2 ? random.uniform(-1, 1)
                                     : std::ldexp(random.uniform(-1, 1), int(random.uniform(-60, 60)));
    return {Ball(value), Rational(value)};
}

BOOST_AUTO_TEST_CASE(sums_and_products_hold_the_exact_value_and_signs_are_right) {
    Random random(kSeed);
    int decided = 0, exactZeros = 0, open = 0;
    for (int round = 0; round < 3000; ++round) {
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
            std::vector<Tracked> pool;
            for (int k = 0; k < 4; ++k) pool.push_back(draw(random));
            for (int step = 0; step < 8; ++step) {
                const Tracked a = pool[std::size_t(random.uniform(0, double(pool.size())))],
                              b = pool[std::size_t(random.uniform(0, double(pool.size())))];
                const int kind = int(random.uniform(0, 3));
                const Tracked c = kind == 0   ? Tracked{a.ball + b.ball, a.exact + b.exact}
                                  : kind == 1 ? Tracked{a.ball - b.ball, a.exact - b.exact}
                                              : Tracked{a.ball * b.ball, a.exact * b.exact};
                BOOST_TEST(holds(c));
                const Verdict sign = isNotNegative(c.ball);
                if (sign == Verdict::open) {
                    ++open;
                } else {
                    BOOST_TEST((sign == Verdict::yes) == (c.exact >= 0));
                    ++decided;
                }
                if (c.ball.isZero()) {
                    BOOST_TEST((c.exact == 0));
                    ++exactZeros;
                }
                pool.push_back(c);
            }
        }
    }
    BOOST_TEST(decided > 1000);
    BOOST_TEST(exactZeros > 100);
    BOOST_TEST(open > 10);
}

BOOST_AUTO_TEST_CASE(an_error_is_that_of_twice_a_doubles_digits) {
    Random random(kSeed);
    for (int round = 0; round < 1000; ++round) {
        Ball sum;
        double size = 0;
        for (int k = 0; k < 6; ++k) {
            const Ball product =
                Ball(random.uniform(-1, 1)) * Ball(random.uniform(-1, 1)) * Ball(random.uniform(-1, 1));
            size += std::abs(product.high);
            sum = sum + product;
        }
        BOOST_TEST(sum.error <= 0x1p-98 * size, "seed " << kSeed << ", round " << round);
    }
}

BOOST_AUTO_TEST_CASE(what_overflows_or_underflows_decides_nothing_wrongly) {
    const Ball huge(1e300), tiny(1e-300);
    BOOST_TEST(int(isNotNegative(huge * huge - huge)) != int(Verdict::no));
    BOOST_TEST(int(isNotNegative(huge - huge * huge)) != int(Verdict::yes));
    BOOST_TEST(int(isNotNegative(-(tiny * tiny))) != int(Verdict::yes));
    const LengthBounds bounds = rootBounds(tiny * tiny, Ball(1));
    BOOST_TEST(bounds.lower <= 1e-300);
    BOOST_TEST(bounds.upper >= 1e-300);
}

BOOST_AUTO_TEST_CASE(roots_of_fractions_are_enclosed) {
    Random random(kSeed);
    for (int round = 0; round < 2000; ++round) {
        const Tracked a = draw(random), b = draw(random);
        const Tracked numerator{a.ball * a.ball, a.exact * a.exact},
            denominator{b.ball * b.ball, b.exact * b.exact};
        const LengthBounds bounds = rootBounds(numerator.ball, denominator.ball);
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
            if (denominator.exact == 0) {
                BOOST_TEST(std::isinf(bounds.lower));
                continue;
            }
            const Rational square = numerator.exact / denominator.exact;
            BOOST_TEST((Rational(bounds.lower) * Rational(bounds.lower) <= square));
            BOOST_TEST(
                (std::isinf(bounds.upper) || Rational(bounds.upper) * Rational(bounds.upper) >= square));
            BOOST_TEST(bounds.upper - bounds.lower <= 0x1p-49 * bounds.upper);
        }
    }
}

// With an error almost as large as the value, the tail makes up most of the difference between them.
BOOST_AUTO_TEST_CASE(bounds_count_the_tail) {
    const Ball doubtful(1, -0x1p-54, 1 - 0x1p-52);
    const Rational least = Rational(doubtful.high) + Rational(doubtful.low) - Rational(doubtful.error);
    BOOST_TEST((Rational(leastOf(doubtful)) <= least));
    const LengthBounds numerator = rootBounds(doubtful, Ball(1));
    BOOST_TEST((Rational(numerator.lower) * Rational(numerator.lower) <= least));
    const LengthBounds denominator = rootBounds(Ball(1), doubtful);
    BOOST_TEST((std::isinf(denominator.upper) ||
                Rational(denominator.upper) * Rational(denominator.upper) >= 1 / least));
}

// A tail may lie hundreds of digits behind the head; what a product loses of it must be counted as error.
BOOST_AUTO_TEST_CASE(products_whose_tails_underflow_are_not_called_exact) {
    Random random(kSeed);
    for (int round = 0; round < 2000; ++round) {
        const auto wide = [&] {
            const double head = std::floor(random.uniform(-4, 4)),
                         tail =
                             std::ldexp(std::floor(random.uniform(-4, 4)), int(random.uniform(-1074, -60)));
            return Tracked{Ball(head) + Ball(tail), Rational(head) + Rational(tail)};
        };
        const Tracked a = wide(), b = wide();
        const double scale = std::ldexp(1.0, int(random.uniform(-60, 0)));
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
            BOOST_TEST(holds({a.ball * b.ball, a.exact * b.exact}));
            BOOST_TEST(holds({a.ball * Ball(scale), a.exact * Rational(scale)}));
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
