// The exact oracle agrees with CGAL's on all pairs that CGAL accepts, which are triangles with an area.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <boost/test/unit_test.hpp>
#include <sstream>

#include "support/exact_distance.h"
#include "support/full_run.h"
#include "support/hard_triangles.h"

BOOST_AUTO_TEST_SUITE(cgal_test)

using namespace clearway;
using namespace clearway::testing;

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr std::uint64_t kSeed = 127;

/// The triangle moved by the pose, without rounding.
Kernel::Triangle_3 toCgal(const Pose& X, const Triangle& t) {
    const auto at = [&](const Vector3& p, int row) {
        Kernel::FT sum = X.translation[row];
        for (int k = 0; k < 3; ++k) sum += Kernel::FT(X.rotation(row, k)) * Kernel::FT(p[k]);
        return sum;
    };
    const auto point = [&](const Vector3& p) { return Kernel::Point_3(at(p, 0), at(p, 1), at(p, 2)); };
    return {point(t[0]), point(t[1]), point(t[2])};
}

/// The number as text, so that the two libraries' number types need not know each other.
Rational toRational(const Kernel::FT& number) {
    std::ostringstream text;
    text << CGAL::exact(number);
    return Rational(text.str());
}

BOOST_AUTO_TEST_CASE(exact_distances_equal_cgals_on_every_pair_that_it_takes) {
    Random random(kSeed);
    int compared = 0, touching = 0;
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        for (int trial = 0; trial < inForm(60, 20); ++trial) {
            const TrianglePair pair = family.make(random);
            const Pose pose = trial % 2 == 0 ? Pose{} : random.pose(10);
            const Kernel::Triangle_3 a = toCgal(pose, pair.a), b = toCgal(Pose{}, pair.b);
            if (a.is_degenerate() || b.is_degenerate()) continue;
            const ExactDistance distance = exactDistance(pose, pair.a, pair.b);
            BOOST_TEST((distance.squared() == toRational(CGAL::squared_distance(a, b))),
                       family.name << ", seed " << kSeed << ", trial " << trial);
            BOOST_TEST(distance.isZero() == CGAL::do_intersect(a, b),
                       family.name << ", seed " << kSeed << ", trial " << trial);
            ++compared;
            touching += distance.isZero();
        }
    }
    BOOST_TEST(compared > inForm(1500, 500));
    BOOST_TEST(touching > inForm(300, 100));
}

BOOST_AUTO_TEST_SUITE_END()
