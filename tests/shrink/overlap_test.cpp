#include "clearway/overlap.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/assembled_problems.h"
#include "support/oracle.h"
#include "support/random_meshes.h"
#include "support/winding.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(overlap_test)

double depthOf(const Mesh& part, const Vector3& point) {
    Mesh one;
    one.vertices = {point};
    one.triangles = {{0, 0, 0}};
    const Component all{"", 0, static_cast<std::uint32_t>(part.triangles.size())};
    if (std::abs(windingBySolidAngles(part, all, point)) < 0.5) return 0;
    return bruteForceDistance(one, part, {}).distance;
}

BOOST_AUTO_TEST_CASE(a_corner_that_reaches_into_a_box_is_as_deep_as_it_is) {
    const OverlapMeter meter(box({5, 5, 5}));
    const Mesh block = translated(box({2, 2, 2}), {6, 0, 0});
    const DeepestPoint found = meter.deepest(block, {});
    BOOST_TEST(found.lower <= 1);
    BOOST_TEST(found.upper >= 1);
    BOOST_TEST(found.upper <= found.lower * 1.01 + 0.002);
    BOOST_TEST(found.point.x() == 4, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(found.obstacleTriangle >= 0);
}

BOOST_AUTO_TEST_CASE(what_is_outside_or_only_touches_has_no_depth_of_interest) {
    const OverlapMeter meter(box({5, 5, 5}));
    BOOST_TEST(meter.deepest(translated(box({1, 1, 1}), {9, 0, 0}), {}).upper == 0);
    const DeepestPoint touching = meter.deepest(translated(box({1, 1, 1}), {6, 0, 0}), {});
    BOOST_TEST(touching.lower <= 1e-9);
    BOOST_TEST(touching.upper < 0.002);
}

/// All that reaches into the part is near one triangle of its surface, and no deeper than what is of interest.
BOOST_AUTO_TEST_CASE(what_is_hardly_deep_below_one_triangle_has_its_place) {
    const OverlapMeter meter(box({50, 50, 50}));
    const Mesh lid = translated(box({5, 5, 5}), {20, 5, 54.99});
    const DeepestPoint found = meter.deepest(lid, {});
    BOOST_TEST(found.obstacleTriangle >= 0);
    BOOST_TEST(found.lower > 0);
    BOOST_TEST(found.upper >= 0.01 * (1 - 1e-9));
    BOOST_TEST(found.point.z() < 50);
    BOOST_TEST(found.point.z() > 49.98);
}

/// A random point of one of the mesh's triangles, corners and edges included.
Vector3 pointOn(const Mesh& mesh, Random& random) {
    const auto& t = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    double u = random.below(3) == 0 ? 0 : random.uniform(0, 1),
           v = random.below(3) == 0 ? 0 : random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return (1 - u - v) * mesh.vertices[t[0]] + u * mesh.vertices[t[1]] + v * mesh.vertices[t[2]];
}

BOOST_AUTO_TEST_CASE(the_deepest_point_is_within_its_bounds_at_random_poses) {
    Random random(5);
    const Mesh part = torus(4, 1.5, 10), obstacle = box({1, 2, 3}, 2);
    const OverlapMeter meter(part);
    int reaching = 0;
    for (int n = 0; n < 40; ++n) {
        const Pose X = random.pose(4);
        const DeepestPoint found = meter.deepest(obstacle, X);
        const Mesh seen = transformed(obstacle, inverse(X));
        if (found.obstacleTriangle >= 0) {
            ++reaching;
            BOOST_TEST(depthOf(part, inverse(X) * found.point) == found.lower,
                       boost::test_tools::tolerance(1e-6));
            BOOST_TEST(found.upper <= 1.01 * found.lower + 2e-3);
        }
        for (int k = 0; k < 100; ++k) {
            BOOST_REQUIRE(depthOf(part, pointOn(seen, random)) <= found.upper + 1e-9);
        }
    }
    BOOST_TEST(reaching > 10);
}

/// Faces that coincide, or nearly so, are decided without halving them along all their edges. Nothing deeper is lost by that.
BOOST_AUTO_TEST_CASE(nothing_of_a_touching_obstacle_lies_deeper_than_the_bound) {
    Random random(9);
    int deep = 0;
    for (const AssembledProblem& problem : touchingProblems()) {
        const OverlapMeter meter(problem.part);
        Box box;
        for (const Vector3& vertex : problem.part.vertices) box.extend(vertex);
        const double size = box.diagonal().norm();
        for (const double by : {0.0, 1e-9, 1e-4, 1e-3, 0.01}) {
            const Vector3 shift = by * size * random.direction();
            Pose X_environmentPart;
            X_environmentPart.translation = -shift;
            const DeepestPoint found = meter.deepest(problem.environment, X_environmentPart);
            const Mesh seen = translated(problem.environment, shift);
            for (int k = 0; k < 300; ++k) {
                const double depth = depthOf(problem.part, pointOn(seen, random));
                BOOST_TEST_CONTEXT(problem.name << " moved by " << shift.transpose())
                BOOST_REQUIRE(depth <= found.upper + 1e-9);
                deep += depth > 1e-4 * size;
            }
        }
    }
    BOOST_TEST(deep > 300);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
