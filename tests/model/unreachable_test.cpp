// Compares the triangles that are left out with their distances from the box of positions.
#include "model/query_range.h"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <set>
#include <stdexcept>

#include "support/oracle.h"
#include "support/random_meshes.h"
#include "support/triangle_distance.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(unreachable_test)

using testing::Random;

/// The distance of a triangle from a solid box: from its 12 faces, or 0 with a corner inside.
double distanceFromBox(const Mesh& mesh, std::size_t triangle, const Box& solid) {
    const auto corners = testing::cornersOf(mesh, triangle);
    for (const Vector3& corner : corners) {
        if (solid.contains(corner)) return 0;
    }
    const Mesh faces = testing::translated(testing::box(solid.sizes() / 2), solid.center());
    long double least = std::numeric_limits<long double>::infinity();
    for (std::size_t face = 0; face < faces.triangles.size(); ++face) {
        least = std::min(least, testing::triangleDistance(testing::toLong(corners),
                                                          testing::toLong(testing::cornersOf(faces, face)))
                                    .distance);
    }
    return static_cast<double>(least);
}

std::set<std::uint32_t> keptOf(const Mesh& mesh, const QueryRange& range, std::size_t& leftOut) {
    CleanMesh cleaned = clean(mesh);
    leftOut = leaveOutUnreachable(cleaned, range);
    for (const Vector3& vertex : cleaned.vertices) BOOST_TEST(vertex.allFinite());
    for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) {  // what is kept is what was there
        const auto expected = testing::cornersOf(mesh, cleaned.triangleIds[i]);
        for (int corner = 0; corner < 3; ++corner) {
            BOOST_TEST(cleaned.vertices.at(cleaned.triangles[i][corner]) == expected[corner]);
        }
    }
    return {cleaned.triangleIds.begin(), cleaned.triangleIds.end()};
}

Box randomBox(Random& random, double halfSide) {
    Box box(random.inBox(halfSide));
    box.extend(random.inBox(halfSide));
    const int flat = random.below(6);  // now and then without an extent
    if (flat < 3) box.max()[flat] = box.min()[flat];
    return box;
}

BOOST_AUTO_TEST_CASE(exactly_the_triangles_farther_than_radius_and_cap_are_left_out) {
    int kept = 0, gone = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        const double size = seed % 3 == 0 ? 20 : seed % 3 == 1 ? 3 : 0.2;
        Mesh mesh = testing::randomSoup(random, 150, 12, size);
        if (seed % 4 == 0) mesh = testing::joined(mesh, testing::randomTerrain(random, 6, 30, 2));
        const QueryRange range{randomBox(random, 6), random.uniform(0, 3), random.uniform(0, 3)};
        std::size_t leftOut = 0;
        const auto there = keptOf(mesh, range, leftOut);
        BOOST_TEST_CONTEXT("seed " << seed) {
            BOOST_TEST(there.size() + leftOut == mesh.triangles.size());
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
                const double distance = distanceFromBox(mesh, i, range.positions);
                const double limit = range.partRadius + range.cap;
                const bool isThere = there.count(static_cast<std::uint32_t>(i)) > 0;
                ++(isThere ? kept : gone);
                if (distance <= limit) BOOST_TEST(isThere, "triangle " << i << " at " << distance);
                if (distance > limit * (1 + 1e-9) + 1e-9 && there.size() > 1) {
                    BOOST_TEST(!isThere, "triangle " << i << " at " << distance << ", limit " << limit);
                }
            }
        }
    }
    BOOST_TEST(kept > 1000);
    BOOST_TEST(gone > 1000);
}

BOOST_AUTO_TEST_CASE(a_triangle_at_the_very_limit_stays_at_any_scale) {
    for (const double scale : {1e-200, 1e-6, 1.0, 1e6, 1e200}) {
        const auto keepsAt = [&](double distance) {
            Mesh mesh;
            mesh.vertices = {{0, 0, 0},
                             {1, 0, 0},
                             {0, 1, 0},  // in the middle of the positions
                             {-1, 7 + distance, -9},
                             {-1, 7 + distance, 9},
                             {3, 9 + distance, 0}};
            mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
            std::size_t leftOut = 0;
            const QueryRange range{Box(Vector3(-5, -6, -7) * scale, Vector3(5, 7, 8) * scale), 2 * scale,
                                   0.5 * scale};
            return keptOf(testing::scaledBy(mesh, scale), range, leftOut).count(1) > 0;
        };
        BOOST_TEST_CONTEXT("scale " << scale) {
            BOOST_TEST(keepsAt(2.5));
            BOOST_TEST(!keepsAt(2.5 * (1 + 1e-9)));
        }
    }
}

// Triangles that queries cannot prove farther than the cap count as within it: 38 * 2^-53 of the largest
// coordinate.
BOOST_AUTO_TEST_CASE(a_triangle_askew_stays_at_the_limit_and_as_far_beyond_as_a_query_may_say_within) {
    Random random(9);
    for (int i = 0; i < 3000; ++i) {
        const Box positions(Vector3(20, 30, 40) - random.inBox(1).cwiseAbs(), Vector3(20, 30, 40));
        const Matrix3 askew = random.rotation();
        const Vector3 away = askew.col(2).cwiseAbs();  // the high corner is the nearest
        const Vector3 u = away.unitOrthogonal(), v = away.cross(u);
        const double limit = 3, beyond = random.uniform(0, 38 * 0x1p-53 * 50);
        const Vector3 nearest = positions.max() + away * (limit + beyond);
        Mesh mesh;
        mesh.vertices = {{20, 30, 40},    {20, 30, 41},    {20, 31, 40},
                         nearest + u * 5, nearest + v * 5, nearest - (u + v) * 5};
        mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
        std::size_t leftOut = 0;
        keptOf(mesh, {positions, 0, limit}, leftOut);
        BOOST_TEST(leftOut == 0u, "triangle " << i);
    }
}

BOOST_AUTO_TEST_CASE(sums_beyond_the_largest_double_leave_nothing_out) {
    // The triangle lies across the diagonal, 1.86e308 along (1, 1, 1), the positions end at 1.785e308: a gap
    // of 4.4e306.
    const double far = 1.3e308, near = 0.28e308;
    Mesh mesh;
    mesh.vertices = {{far, near, near},           {near, far, near},           {near, near, far},
                     {0.5e308, 0.5e308, 0.5e308}, {0.4e308, 0.5e308, 0.5e308}, {0.5e308, 0.4e308, 0.5e308}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    std::size_t leftOut = 0;
    const Box positions(Vector3::Constant(0.5e308), Vector3::Constant(0.595e308));
    keptOf(mesh, {positions, 0.4e307, 0.4e307}, leftOut);
    BOOST_TEST(leftOut == 0u);
    keptOf(mesh, {positions, 1e306, 1e306}, leftOut);
    BOOST_TEST(leftOut == 1u);
}

BOOST_AUTO_TEST_CASE(when_it_would_be_all_one_triangle_stays) {
    Random random(5);
    const Mesh mesh = testing::randomSoup(random, 40, 3, 1);
    std::size_t leftOut = 0;
    const auto there = keptOf(mesh, {Box(Vector3(100, 0, 0), Vector3(101, 1, 1)), 2, 3}, leftOut);
    BOOST_TEST(there.size() == 1u);
    BOOST_TEST(leftOut == 39u);
}

BOOST_AUTO_TEST_CASE(a_reach_that_is_none_is_refused_by_name) {
    const Box box(Vector3(-1, -1, -1), Vector3(1, 1, 1));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto requireRefused = [](const QueryRange& range, const std::string& what) {
        testing::requireRefusedBy([&] { requireRange(range); }, {what});
    };
    BOOST_CHECK_NO_THROW(requireRange({box, 0, 0}));
    BOOST_CHECK_NO_THROW(requireRange({Box(Vector3(1, 2, 3)), 1, 1}));
    requireRefused({Box(), 1, 1}, "positions along x");
    requireRefused({Box(Vector3(-1, 2, -1), Vector3(1, 1, 1)), 1, 1}, "positions along y are 2 to 1");
    requireRefused({Box(Vector3(-1, -1, nan), Vector3(1, 1, 1)), 1, 1}, "positions along z");
    requireRefused({Box(Vector3(-1, -1, -1), Vector3(1, infinity, 1)), 1, 1}, "positions along y");
    for (const double wrong : {-1.0, nan, infinity}) {
        requireRefused({box, wrong, 1}, "partRadius");
        requireRefused({box, 1, wrong}, "cap");
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
