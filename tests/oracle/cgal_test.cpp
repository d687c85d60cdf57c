// The rational oracle agrees with CGAL's exact one on all pairs that CGAL accepts, which are triangles with
// an area.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <boost/test/unit_test.hpp>
#include <sstream>

#include "support/exact_triangle.h"
#include "support/full_run.h"
#include "support/hard_triangles.h"

BOOST_AUTO_TEST_SUITE(cgal_test)

using namespace clearway;
using namespace clearway::testing;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr std::uint64_t kSeed = 127;

Kernel::Triangle_3 toCgal(const Triangle& t) {
    const auto point = [](const Vector3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
    return {point(t[0]), point(t[1]), point(t[2])};
}

/// The number as text, so that the two libraries' number types need not know each other.
Rational toRational(const Kernel::FT& number) {
    std::ostringstream text;
    text << CGAL::exact(number);
    return Rational(text.str());
}

}  // namespace

BOOST_AUTO_TEST_CASE(rationals_equal_cgal_on_every_pair_that_it_takes) {
    Random random(kSeed);
    int compared = 0, touching = 0;
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        for (int trial = 0; trial < inForm(60, 20); ++trial) {
            const TrianglePair pair = family.make(random);
            const Kernel::Triangle_3 a = toCgal(pair.a), b = toCgal(pair.b);
            if (a.is_degenerate() || b.is_degenerate()) continue;
            const Rational square = exactDistanceSquared(toExact(pair.a), toExact(pair.b));
            BOOST_TEST((square == toRational(CGAL::squared_distance(a, b))),
                       family.name << ", seed " << kSeed << ", trial " << trial);
            BOOST_TEST((square == 0) == CGAL::do_intersect(a, b),
                       family.name << ", seed " << kSeed << ", trial " << trial);
            ++compared;
            touching += square == 0;
        }
    }
    BOOST_TEST(compared > inForm(1500, 500));
    BOOST_TEST(touching > inForm(300, 100));
}

BOOST_AUTO_TEST_SUITE_END()
