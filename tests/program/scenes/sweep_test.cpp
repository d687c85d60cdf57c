#include "program/scenes/sweep.h"

#include <boost/test/unit_test.hpp>

#include "program/scenes/scene_checks.h"
#include "program/scenes/screw.h"
#include "support/convex_hull.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

Mesh meshOf(const Piece& piece) {
    Assembly assembly;
    assembly.add("piece", piece);
    return assembly.mesh();
}

void requireSolid(const Piece& piece, double volume, double relative) {
    const Mesh mesh = meshOf(piece);
    BOOST_TEST(isClosed(mesh, mesh.components[0]));
    BOOST_TEST(signedVolume(mesh) == volume, boost::test_tools::tolerance(relative));
}

BOOST_AUTO_TEST_CASE(a_swept_section_is_a_closed_solid_of_area_times_length) {
    requireSolid(sweep(rectangleSection({0, 0}, {2, 3}), {1, 2, 6}), 30, 1e-6);
    requireSolid(sweep(sheetSection({{0, 0}, {10, 0}, {10, 10}}, 2), {0, 5}), 200, 1e-6);
    const double disc = 16 * 0.5 * 4 * std::sin(2 * M_PI / 16);
    requireSolid(sweep(ringSection(squareAround({0, 0}, 5, 16), circle({0, 0}, 2, 16, M_PI_4)), {0, 3}),
                 3 * (100 - disc), 1e-6);
}

BOOST_AUTO_TEST_CASE(turned_outlines_are_closed_solids_with_the_volume_of_their_shape) {
    const double cylinder = M_PI * 25 * 8;
    requireSolid(turned({{0, 0}, {5, 0}, {5, 8}, {0, 8}}, 200), cylinder, 1e-3);
    requireSolid(turned(domeOutline(4, 4, 60), 200), 2.0 / 3 * M_PI * 64, 1e-3);
    CupShape cup;
    cup.rounding = 1;
    const double shell = M_PI * (38 * 38 * 60 - 36 * 36 * 58);
    requireSolid(turned(cupOutline(cup, 30), 200), shell, 0.02);  // the rounded edge takes a little
    BossShape boss;
    const double pad = boss.radius + 2.1 * boss.foot;
    const double rough = M_PI * (boss.radius * boss.radius * (boss.height - boss.pad) + pad * pad * boss.pad);
    requireSolid(turned(bossOutline(boss, 30), 200), rough, 0.1);
}

BOOST_AUTO_TEST_CASE(a_boss_keeps_to_its_height_and_radius) {
    BossShape boss;
    const Polyline outline = bossOutline(boss, 5);
    for (const Vector2& p : outline) {
        BOOST_TEST(p.x() <= boss.radius + 2.1 * boss.foot + 1e-12);
        BOOST_TEST((p.y() >= 0 && p.y() <= boss.height));
    }
}

BOOST_AUTO_TEST_CASE(stations_reach_both_ends_in_steps_no_longer_than_asked) {
    const std::vector<double> stations = stationsBetween(-3, 7, 3);
    BOOST_TEST(stations.size() == 5);
    BOOST_TEST(stations.front() == -3);
    BOOST_TEST(stations.back() == 7);
    BOOST_TEST(stationsBetween(0, 6, 3).size() == 3);
}

BOOST_AUTO_TEST_CASE(a_placement_keeps_solids_from_turning_inside_out) {
    const Piece bar = sweep(rectangleSection({0, 0}, {2, 3}), {0, 5});
    for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(0, 0, -1), Vector3(0, -1, 0), Vector3(1, 2, 3)}) {
        requireSolid(placed(bar, standingAt({1, 2, 3}, axis, 0.4)), 30, 1e-6);
        const Vector3 tip = standingAt({1, 2, 3}, axis, 0.4)(Vector3(0, 0, 2));
        BOOST_TEST((tip - Vector3(1, 2, 3) - 2 * axis.normalized()).norm() < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(the_screw_carries_what_it_bends_along_itself) {
    const Screw screw{870, -105};
    const Vector3 point(130, -40, 70);
    for (const double angle : {-1.1, 0.0, 0.3}) {
        const Vector3 moved = poseOf(screw.motion(angle)) * screw.bend(point);
        BOOST_TEST((moved - screw.bend(point + Vector3(angle * screw.radius, 0, 0))).norm() < 1e-9);
    }
    // At its lowest point the bend is the identity up to first order, before it the tangent plane goes on.
    BOOST_TEST((screw.bend({0, 5, 7}) - Vector3(0, 5, 7)).norm() < 1e-9);
    BOOST_TEST(screw.bendAfterStart({-50, 5, 7}).z() == 7);
    BOOST_TEST((screw.bendAfterStart(point) - screw.bend(point)).norm() == 0);
}

BOOST_AUTO_TEST_CASE(numbered_names_count_up_and_coordinates_are_floats) {
    Assembly assembly;
    const Piece bar = sweep(rectangleSection({0, 0}, {1.0 / 3, 3}), {0, 5});
    assembly.addNumbered("bar", bar);
    assembly.add("other", bar);
    assembly.addNumbered("bar", bar);
    const Mesh mesh = assembly.mesh({0.1, 0, -5});
    BOOST_REQUIRE(mesh.components.size() == 3);
    BOOST_TEST(mesh.components[0].name == "bar_01");
    BOOST_TEST(mesh.components[2].name == "bar_02");
    BOOST_TEST(mesh.components[2].firstTriangle == 24);
    for (const Vector3& v : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis)
            BOOST_TEST(v[axis] == static_cast<double>(static_cast<float>(v[axis])));
    }
}

}  // namespace
