// The oracle's own foundations: long double agrees with exact distances, and these with closed forms.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/exact_distance.h"
#include "support/full_run.h"
#include "support/hard_triangles.h"
#include "support/random_meshes.h"
#include "support/triangle_distance.h"

BOOST_AUTO_TEST_SUITE(triangle_distance_test)

using namespace clearway;
using namespace clearway::testing;

long double extentOf(const TrianglePair& pair) {
    Box box;
    for (const Vector3& p : pair.a) box.extend(p);
    for (const Vector3& p : pair.b) box.extend(p);
    return box.diagonal().norm();
}

long double largestCoordinate(const TrianglePair& pair) {
    double largest = 0;
    for (const Vector3& p : pair.a) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    for (const Vector3& p : pair.b) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return largest;
}

BOOST_AUTO_TEST_CASE(exact_distances_reproduce_known_distances) {
    for (const KnownPair& known : knownTrianglePairs()) {
        BOOST_TEST_CONTEXT(known.name) {
            const long double distance = exactDistance(known.pair.a, known.pair.b).rounded();
            BOOST_TEST(std::abs(distance - known.distance) <= 1e-15L * known.distance);
        }
    }
}

BOOST_AUTO_TEST_CASE(exact_distances_reproduce_what_hard_cases_state) {
    Random random(5);
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        const int trials = inForm(40, 15);
        int stated = 0;
        for (int trial = 0; trial < trials; ++trial) {
            const TrianglePair pair = family.make(random);
            if (std::isnan(pair.stated)) continue;
            ++stated;
            const long double distance = exactDistance(pair.a, pair.b).rounded();
            BOOST_TEST(
                std::abs(distance - pair.stated) <= pair.statedWithin + 0x1p-52L * pair.stated,
                family.name << ", seed 5, trial " << trial << ": " << distance << ", stated " << pair.stated);
        }
        BOOST_TEST((stated == 0 || stated == trials), family.name);
    }
}

BOOST_AUTO_TEST_CASE(exact_distances_say_zero_exactly_when_a_point_is_shared) {
    const Triangle flat = {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
    const auto shared = [&](const Triangle& other) { return exactDistance(flat, other).isZero(); };
    BOOST_TEST(shared(flat));
    BOOST_TEST(shared({Vector3(1, 1, -1), Vector3(1, 1, 1), Vector3(9, 9, 9)}));         // pierces the face
    BOOST_TEST(shared({Vector3(1, 1, 0), Vector3(1, 1, 1), Vector3(2, 1, 1)}));          // vertex on the face
    BOOST_TEST(shared({Vector3(2, 0, 0), Vector3(2, -3, 1), Vector3(2, -3, -1)}));       // vertex on an edge
    BOOST_TEST(shared({Vector3(1, -1, 1), Vector3(1, 1, -1), Vector3(1, -5, -5)}));      // edges cross
    BOOST_TEST(shared({Vector3(0.5, 0.5, 0), Vector3(1, 0.5, 0), Vector3(0.5, 1, 0)}));  // coplanar, nested
    BOOST_TEST(shared({Vector3(4, 0, 0), Vector3(8, 0, 1), Vector3(8, 1, 0)}));          // a common vertex
    BOOST_TEST(shared({Vector3(1, 1, 0), Vector3(1, 1, 0), Vector3(1, 1, 0)}));          // a point
    BOOST_TEST(!shared({Vector3(2, 2 + 1e-15, 0), Vector3(3, 3, 1), Vector3(3, 3, -1)}));
    BOOST_TEST(!shared({Vector3(1, 1, 5e-324), Vector3(1, 1, 1), Vector3(2, 1, 1)}));
    BOOST_TEST(!shared({Vector3(1, 1, -1), Vector3(1, 1, -1), Vector3(1, 1, -5e-324)}));
}

BOOST_AUTO_TEST_CASE(exact_distances_match_brute_sampling_on_the_integer_grid) {
    // On small integers, a fine lattice of points of both triangles bounds the distance from above to within
    // its spacing.
    Random random(11);
    constexpr int kSteps = 24;
    for (int trial = 0; trial < inForm(200, 80); ++trial) {
        TrianglePair pair;
        for (Vector3& p : pair.a) p = Vector3(random.below(3), random.below(3), random.below(3));
        for (Vector3& p : pair.b) p = Vector3(random.below(3), random.below(3), random.below(3));
        double sampled = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= kSteps; ++i) {
            for (int j = 0; i + j <= kSteps; ++j) {
                const Vector3 p =
                    pair.a[0] + (pair.a[1] - pair.a[0]) * i / kSteps + (pair.a[2] - pair.a[0]) * j / kSteps;
                const LongVector q = closestOnTriangle(p.cast<long double>(), toLong(pair.b));
                sampled = std::min(sampled, static_cast<double>((q - p.cast<long double>()).norm()));
            }
        }
        BOOST_TEST_CONTEXT("trial " << trial) {
            const long double exact = exactDistance(pair.a, pair.b).rounded();
            BOOST_TEST(exact <= sampled + 1e-15);
            BOOST_TEST(sampled <= exact + 2 * std::sqrt(3.0) * 2 / kSteps);
        }
    }
}

BOOST_AUTO_TEST_CASE(long_double_agrees_with_exact_distances_on_hard_pairs) {
    Random random(7);
    long double worst = 0;
    std::string worstFamily;
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        for (int trial = 0; trial < inForm(60, 25); ++trial) {
            const TrianglePair pair = family.make(random);
            const long double exact = exactDistance(pair.a, pair.b).rounded();
            const TriangleDistance found = triangleDistance(toLong(pair.a), toLong(pair.b));
            const long double error = std::abs(found.distance - exact) / extentOf(pair);
            if (error > worst) {
                worst = error;
                worstFamily = family.name;
            }
            BOOST_TEST_CONTEXT(family.name << ", seed 7, trial " << trial) {
                BOOST_TEST(error <= 1e-18L);
                const LongVector leftOverOfA =
                    closestOnTriangle(found.pointOnA, toLong(pair.a)) - found.pointOnA;
                const LongVector leftOverOfB =
                    closestOnTriangle(found.pointOnB, toLong(pair.b)) - found.pointOnB;
                BOOST_TEST(leftOverOfA.norm() <= 1e-18L * largestCoordinate(pair));
                BOOST_TEST(leftOverOfB.norm() <= 1e-18L * largestCoordinate(pair));
            }
        }
    }
    BOOST_TEST_MESSAGE("largest error, relative to the pair's extent: " << worst << " in " << worstFamily);
}

BOOST_AUTO_TEST_CASE(all_vertex_orders_agree) {
    Random random(13);
    const std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        const TrianglePair pair = family.make(random);
        const long double first = triangleDistance(toLong(pair.a), toLong(pair.b)).distance;
        for (const auto& i : orders) {
            for (const auto& j : orders) {
                const Triangle a = {pair.a[i[0]], pair.a[i[1]], pair.a[i[2]]};
                const Triangle b = {pair.b[j[0]], pair.b[j[1]], pair.b[j[2]]};
                const long double swapped = triangleDistance(toLong(b), toLong(a)).distance;
                BOOST_TEST(std::abs(swapped - first) <= 1e-18L * extentOf(pair), family.name);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
