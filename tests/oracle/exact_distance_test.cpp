#include "support/exact_distance.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/full_run.h"
#include "support/hard_triangles.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(exact_distance_test)

BOOST_AUTO_TEST_CASE(an_exact_distance_is_ordered_among_the_doubles_around_it) {
    constexpr std::uint64_t kSeed = 7;
    Random random(kSeed);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        for (int i = 0; i < inForm(12, 6); ++i) {
            BOOST_TEST_CONTEXT("family " << family.name << ", seed " << kSeed << ", pair " << i) {
                const TrianglePair pair = family.make(random);
                const ExactDistance distance = exactDistance(pair.a, pair.b);
                const Rational square = distance.squared();
                const auto root = std::sqrt(static_cast<long double>(square));
                BOOST_TEST(std::abs(distance.rounded() - root) <= 0x1p-60L * root);
                const double nearest = static_cast<double>(root);
                for (const double d : {nearest, std::nextafter(nearest, 0.0),
                                       std::nextafter(nearest, infinity), 0.0, 1e-300, 3.0, 1e300}) {
                    BOOST_TEST(distance.compare(d) == square.compare(Rational(d) * Rational(d)));
                }
                BOOST_TEST(distance.compare(infinity) == -1);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(exact_distances_of_other_exponents_are_ordered) {
    const Triangle point = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    const auto at = [&](double x) {
        const Triangle other = {Vector3(x, 0, 0), Vector3(x, 0, 0), Vector3(x, 0, 0)};
        return exactDistance(point, other);
    };
    BOOST_TEST(at(0x1p-1000).compare(at(3)) == -1);
    BOOST_TEST(at(0x1p900).compare(at(0.1)) == 1);
    BOOST_TEST(at(0.75).compare(at(-0.75)) == 0);
    BOOST_TEST(at(0).compare(at(5e-324)) == -1);
    BOOST_TEST(at(0).compare(at(0)) == 0);
    BOOST_TEST(at(0.1).rounded() == static_cast<long double>(0.1));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
