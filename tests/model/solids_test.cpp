// Inside and outside follow exactly from the signed crossings of closed shells, wherever the ray goes.
#include "model/solids.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"
#include "support/winding.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(solids_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 51;

bool holds(const Solid& solid, const Vector3& point) {
    return solid.winding({}, {}, point) > 0;
}

std::string refusalOf(const Mesh& mesh) {
    return refusalBy([&] { Solid(mesh, "bracket"); });
}

// Rays from grid points run along edges and through corners of the box's triangles.
BOOST_AUTO_TEST_CASE(a_box_holds_what_is_between_its_sides) {
    const Solid solid(box({2, 3, 4}, 4), "box");
    BOOST_TEST(!solid.isTurnedOver());
    for (double x = -3; x <= 3; x += 0.5) {
        for (double y = -4; y <= 4; y += 0.5) {
            for (double z = -5; z <= 5; z += 0.5) {
                const Vector3 outside = Vector3(std::abs(x) - 2, std::abs(y) - 3, std::abs(z) - 4);
                if (outside.maxCoeff() == 0) continue;  // on the surface
                BOOST_TEST(holds(solid, {x, y, z}) == (outside.maxCoeff() < 0), x << " " << y << " " << z);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_reversed_cube_is_turned_over_and_holds_the_same) {
    const Solid solid(reversed(box({1, 1, 1}, 2)), "cube");
    BOOST_TEST(solid.isTurnedOver());
    BOOST_TEST(holds(solid, {0.25, 0.5, 0}));
    BOOST_TEST(!holds(solid, {0.25, 0.5, -2}));
}

BOOST_AUTO_TEST_CASE(a_cavity_is_outside_and_what_stands_in_it_is_inside) {
    const Mesh hollow = joined(box({3, 3, 3}), reversed(box({2, 2, 2}, 2)));
    const Mesh filled = joined(hollow, box({1, 1, 1}));
    for (const bool isReversed : {false, true}) {
        const Solid cavity(isReversed ? reversed(hollow) : hollow, "hollow"),
            island(isReversed ? reversed(filled) : filled, "filled");
        BOOST_TEST(cavity.isTurnedOver() == isReversed);
        BOOST_TEST(holds(cavity, {2.5, 0, 0}));
        BOOST_TEST(!holds(cavity, {0, 0, 0}));
        BOOST_TEST(!holds(cavity, {0, 0, -1.5}));
        BOOST_TEST(holds(island, {0, 0, 0}));
        BOOST_TEST(!holds(island, {0, 0, -1.5}));
        BOOST_TEST(island.shellVertices().size() == 3u);
    }
}

BOOST_AUTO_TEST_CASE(shells_that_pierce_each_other_are_oriented_by_what_sticks_out) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 way(corner & 1 ? 0.9 : -0.9, corner & 2 ? 0.8 : -0.8, corner & 4 ? 0.7 : -0.7);
        const Mesh first = box({1, 1, 1}, 2), second = translated(box({1, 1, 1}, 2), way);
        const Mesh both = joined(first, second);
        for (const bool isReversed : {false, true}) {
            const Solid solid(isReversed ? reversed(both) : both, "two");
            BOOST_TEST(solid.isTurnedOver() == isReversed);
            BOOST_TEST(holds(solid, -0.9 * way));
            BOOST_TEST(holds(solid, 0.5 * way));
            BOOST_TEST(holds(solid, 1.9 * way));
            BOOST_TEST(!holds(solid, 2.5 * way));
        }
        for (const Mesh& mixed : {joined(first, reversed(second)), joined(reversed(first), second)}) {
            BOOST_TEST(refusalOf(mixed).find("1 of its outermost shells face outwards and 1 inwards") !=
                       std::string::npos);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_flat_shell_beside_faces_no_way) {
    Mesh sheet;
    sheet.vertices = {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const Solid solid(joined(box({1, 1, 1}), sheet), "box and sheet");
    BOOST_TEST(!solid.isTurnedOver());
    BOOST_TEST(holds(solid, {0.5, 0.25, 0}));
}

BOOST_AUTO_TEST_CASE(what_encloses_nothing_is_refused_by_name) {
    Mesh open = box({1, 1, 1});
    open.triangles.pop_back();
    BOOST_TEST(refusalOf(open) ==
               "'bracket' encloses nothing: 3 open edges, 0 edges where a triangle is turned over and "
               "0 edges of more than two triangles that do not face in pairs, expected a closed surface");
    Mesh twisted = box({1, 1, 1});
    std::swap(twisted.triangles[0][0], twisted.triangles[0][1]);
    BOOST_TEST(refusalOf(twisted).find("3 edges where a triangle is turned over") != std::string::npos);
    const Mesh mixed = joined(box({1, 1, 1}), reversed(translated(box({1, 1, 1}), {5, 0, 0})));
    BOOST_TEST(refusalOf(mixed) ==
               "'bracket' encloses nothing: 1 of its outermost shells face outwards and 1 inwards, "
               "expected all to face one way");
}

BOOST_AUTO_TEST_CASE(boxes_that_touch_along_an_edge_hold_what_each_holds) {
    const Mesh first = box({1, 1, 1}), second = translated(box({1, 1, 1}), {2, 2, 0});
    for (const bool isReversed : {false, true}) {
        const Solid solid(isReversed ? reversed(joined(first, second)) : joined(first, second), "two");
        BOOST_TEST(solid.isTurnedOver() == isReversed);
        for (double x = -1.5; x <= 4; x += 0.5) {
            for (double y = -1.5; y <= 4; y += 0.5) {
                const double inFirst = std::max(std::abs(x), std::abs(y)),
                             inSecond = std::max(std::abs(x - 2), std::abs(y - 2));
                if (inFirst == 1 || inSecond == 1) continue;  // on the surface
                BOOST_TEST(holds(solid, {x, y, 0}) == (inFirst < 1 || inSecond < 1), x << " " << y);
            }
        }
    }
    for (const Mesh& mixed : {joined(first, reversed(second)), joined(reversed(first), second)}) {
        BOOST_TEST(refusalOf(mixed).find("a part of its surface faces the other way than the rest, near ") !=
                   std::string::npos);
    }
}

// A point of the surface that is moved by the least step of a double lies on that side, also if the mesh is
// turned.
BOOST_AUTO_TEST_CASE(points_a_rounding_from_the_surface_are_on_their_side) {
    Random random(kSeed);
    int tried = 0;
    const Mesh mesh = sphere(3, 12);
    const Solid solid(mesh, "sphere");
    for (int round = 0; round < 300; ++round) {
        const std::size_t t = std::size_t(random.uniform(0, double(mesh.triangles.size())));
        const Vector3 &a = mesh.vertices[mesh.triangles[t][0]], &b = mesh.vertices[mesh.triangles[t][1]],
                      &c = mesh.vertices[mesh.triangles[t][2]];
        const Vector3 normal = (solid.isTurnedOver() ? -1.0 : 1.0) * (b - a).cross(c - a).normalized();
        if (!((b - a).cross(c - a).norm() > 1e-3)) continue;  // a triangle at a pole may have no area
        const double s = random.uniform(0.1, 0.5), u = random.uniform(0.1, 0.4);
        const Vector3 on = a + s * (b - a) + u * (c - a);
        const Pose X = random.pose(5);
        ++tried;
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
            for (const double away : {1e-14, 1e-9, 0.1}) {
                BOOST_TEST(holds(solid, on - away * normal));
                BOOST_TEST(!holds(solid, on + away * normal));
                const double far = std::max(away, 1e-13);
                BOOST_TEST(solid.winding(X, X, on - far * normal) == 1);
                BOOST_TEST(solid.winding(X, X, on + far * normal) == 0);
            }
        }
    }
    BOOST_TEST(tried > 200);
}

BOOST_AUTO_TEST_CASE(windings_are_those_of_the_solid_angles_wherever_mesh_and_point_are_moved) {
    Random random(kSeed);
    const Mesh mesh = joined(joined(reversed(torus(4, 1.5, 12)), translated(box({1, 2, 3}, 2), {9, 0, 0})),
                             reversed(translated(box({0.5, 1, 1.5}), {9, 0.1, 0})));
    const Solid solid(mesh, "several shells");
    const Component whole{"", 0, std::uint32_t(mesh.triangles.size())};
    int inside = 0;
    for (int round = 0; round < 500; ++round) {
        const Vector3 point(random.uniform(-7, 12), random.uniform(-7, 7), random.uniform(-4, 4));
        const double angles = windingBySolidAngles(mesh, whole, point) * (solid.isTurnedOver() ? -1 : 1);
        if (std::abs(angles - std::round(angles)) > 1e-6) continue;
        const Pose X_aMesh = random.pose(10);
        const Vector3 seen = X_aMesh * point;
        const Pose X_aPoint = random.pose(10);
        BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round) {
            BOOST_TEST(solid.winding({}, {}, point) == int(std::round(angles)));
            BOOST_TEST(solid.winding(X_aMesh, {}, seen) == int(std::round(angles)));
            BOOST_TEST(solid.winding(X_aMesh, X_aPoint, inverse(X_aPoint) * seen) == int(std::round(angles)));
        }
        inside += angles > 0.5;
    }
    BOOST_TEST(inside > 40);
    BOOST_TEST(inside < 300);
}

// The winding of each solid around each piece says so.
BOOST_AUTO_TEST_CASE(the_first_of_many_solids_that_hold_a_piece_is_named_with_its_first_piece) {
    Random random(kSeed);
    const auto boxes = [&](int count, double halfSide) {
        std::vector<Mesh> meshes;
        for (int i = 0; i < count; ++i) {
            const Mesh at = translated(box(Vector3::Constant(halfSide), 1), random.inBox(4));
            meshes.push_back(named(i % 3 == 0 ? reversed(at) : at, std::to_string(i)));
        }
        return meshes;
    };
    const auto all = [](const std::vector<Mesh>& meshes) {
        Mesh mesh;
        std::vector<Component> components;
        for (const Mesh& next : meshes) {
            components.push_back(next.components[0]);
            components.back().firstTriangle = std::uint32_t(mesh.triangles.size());
            mesh = joined(mesh, next);
        }
        mesh.components = components;
        return mesh;
    };
    int held = 0;
    for (int round = 0; round < 60; ++round) {
        const std::vector<Mesh> large = boxes(1 + 3 * round, 0.5), small = boxes(6, 0.1);
        const Pose X_aLarge = random.pose(20), X_largeSmall = random.pose(0.5),
                   X_aSmall = X_aLarge * X_largeSmall;
        std::string expected;
        for (std::size_t i = 0; i < large.size() && expected.empty(); ++i) {
            const Solid solid(large[i], "box");
            for (std::size_t k = 0; k < small.size() && expected.empty(); ++k) {
                if (solid.winding(X_aLarge, X_aSmall, small[k].vertices[small[k].triangles[0][0]]) > 0) {
                    expected = std::to_string(i) + " holds " + std::to_string(k);
                }
            }
        }
        const Solids outer(all(large)), inner(all(small));
        const auto found = outer.holding(X_aLarge, inner, X_aSmall);
        BOOST_TEST((found ? *found->outer + " holds " + *found->inner : "") == expected,
                   "seed " << kSeed << ", round " << round);
        held += !expected.empty();
    }
    BOOST_TEST(held > 10);
    BOOST_TEST(held < 55);
}

BOOST_AUTO_TEST_SUITE_END()
