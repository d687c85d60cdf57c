#include "exact/moved_point.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/exact_triangle.h"
#include "support/random_meshes.h"

using namespace clearway;
using namespace clearway::testing;

BOOST_AUTO_TEST_CASE(moved_points_are_exact) {
    constexpr std::uint64_t kSeed = 14;
    Random random(kSeed);
    for (int round = 0; round < 500; ++round) {
        const bool isSimple = round % 3 == 0;
        Pose X = isSimple ? Pose{} : random.pose(100);
        if (round % 5 == 0) X.translation = {0, std::ldexp(1.0, int(random.uniform(-300, 300))), -3};
        Vector3 point(random.uniform(-1, 1), std::floor(random.uniform(-9, 9)), random.uniform(-1e6, 1e6));
        if (round % 7 == 0) point.setZero();
        const ExactPoint exact = exactlyMoved(X, {point, point, point})[0];
        const Triple<Ball> ball = movedBall(X, point);
        const int exponent = lastBitOf(X, point) - (round % 4);
        const Triple<Integer> whole = movedInteger(X, point, exponent);
        const Ball* balls[3] = {&ball.x, &ball.y, &ball.z};
        const Integer* wholes[3] = {&whole.x, &whole.y, &whole.z};
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
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
