#include "demos/scenes/solids.h"

#include <boost/test/unit_test.hpp>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/section.h"
#include "demos/scenes/tunnel_console.h"
#include "support/convex_hull.h"

BOOST_AUTO_TEST_SUITE(solids_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

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
    // At its lowest point the bend is the identity up to first order; before that point it continues in the
    // tangent plane.
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

Box boxOf(const Piece& piece) {
    Box box;
    for (const Vector3& vertex : piece.vertices) box.extend(vertex);
    return box;
}

BOOST_AUTO_TEST_CASE(a_rounded_box_is_a_solid_of_its_size) {
    const Vector3 low(1, 2, 3), high(41, 32, 23);
    const Piece box = roundedBox(low, high, 4, 1, 3);
    requireSolid(box, 40 * 30 * 20, 0.02);
    BOOST_TEST((boxOf(box).min() - low).norm() < 1e-9);
    BOOST_TEST((boxOf(box).max() - high).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_corner_that_does_not_fit_is_lessened) {
    requireSolid(roundedBox({0, 0, 0}, {40, 5, 20}, 10, 1, 3), 40 * 5 * 20, 0.1);
    requireSolid(roundedBox({0, 0, 0}, {40, 30, 1}, 10, 5, 3), 40 * 30 * 1, 0.12);
    const Piece narrow = roundedBox({0, 0, 0}, {40, 5, 20}, 10, 1, 3);
    for (const TriangleIndices& t : narrow.triangles) {  // convex, so that no side looks inwards
        const Vector3 a = narrow.vertices[t[0]], b = narrow.vertices[t[1]], c = narrow.vertices[t[2]];
        BOOST_TEST((b - a).cross(c - a).dot(a - Vector3(20, 2.5, 10)) > 0);
    }
}

BOOST_AUTO_TEST_CASE(a_tray_is_a_closed_shell_open_above) {
    const Piece shell = tray({0, 0, 0}, {160, 140, 20}, 6, 2, 4);
    requireSolid(shell, 160 * 140 * 20 - 156 * 136 * 18, 0.05);
    BOOST_TEST((boxOf(shell).sizes() - Vector3(160, 140, 20)).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_ring_has_the_volume_of_its_section_times_the_way_of_its_middle) {
    requireSolid(ring({{8, 0}, {10, 0}, {10, 3}, {8, 3}}, 200), M_PI * (100 - 64) * 3, 1e-3);
    requireSolid(ring(circle({20, 5}, 3, 100), 200), 2 * M_PI * 20 * M_PI * 9, 2e-3);
}

BOOST_AUTO_TEST_CASE(a_bolt_has_a_shank_below_and_a_hexagon_above) {
    const BoltShape shape;
    for (const int segments : {8, 16, 36}) {
        const Piece screw = bolt(shape, segments);
        const double hexagon = 2 * std::sqrt(3.0) * shape.head * shape.head * 0.7 * shape.height;
        requireSolid(screw, M_PI * shape.shank * shape.shank * shape.length + 1.3 * hexagon, 0.2);
        BOOST_TEST(boxOf(screw).min().z() == -shape.length);
        BOOST_TEST(boxOf(screw).max().z() == shape.height);
        BOOST_TEST(boxOf(screw).max().x() <= 1.35 * shape.head + 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(a_plate_with_holes_is_closed_and_lacks_the_holes) {
    const std::vector<double> xs{0, 10, 25, 30}, ys{0, 12, 20};
    for (const int segments : {4, 8, 12, 60}) {
        const auto radius = [](std::size_t column, std::size_t row) {
            return (column + row) % 2 == 0 ? 2.0 : 0.0;
        };
        const Section section = holedSection(xs, ys, radius, segments);
        const double polygon = segments * 0.5 * 4 * std::sin(2 * M_PI / segments);
        requireSolid(sweep(section, {0, 1.5}), 1.5 * (30 * 20 - 3 * polygon), 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(facing_turns_the_axes_where_it_says) {
    const Placement placement = facing({1, 2, 3}, {0, 0, 2}, {0, -5, 0});
    BOOST_TEST((placement(Vector3::UnitZ()) - Vector3(1, 1, 3)).norm() < 1e-12);
    BOOST_TEST((placement(Vector3::UnitX()) - Vector3(1, 2, 4)).norm() < 1e-12);
    requireSolid(placed(roundedBox({0, 0, 0}, {10, 20, 30}, 2, 0.5, 2), placement), 6000, 0.05);
    const Piece alongY = sweepAlongY(rectangleSection({0, 0}, {2, 3}), {1, 6});
    requireSolid(alongY, 30, 1e-6);
    BOOST_TEST((boxOf(alongY).max() - Vector3(2, 6, 3)).norm() < 1e-12);
    const Piece alongZ = sweepAlongZ(rectangleSection({0, 0}, {2, 3}), {1, 6});
    requireSolid(alongZ, 30, 1e-6);
    BOOST_TEST((boxOf(alongZ).max() - Vector3(2, 3, 6)).norm() < 1e-12);
}

const Line kElbow{{0, 0, 0}, {0, 0, 50}, {0, 50, 50}, {40, 50, 50}};

BOOST_AUTO_TEST_CASE(a_bent_line_keeps_its_ends_and_its_arcs_their_radius) {
    const Line line = bent(kElbow, 10, 4);
    BOOST_TEST(line.size() == 2 + 2 * 5);
    BOOST_TEST((line.front() == kElbow.front()));
    BOOST_TEST((line.back() - kElbow.back()).norm() < 1e-12);
    for (std::size_t i = 1; i <= 5; ++i) {
        BOOST_TEST(std::abs((line[i] - Vector3(0, 10, 40)).norm() - 10) < 1e-12);
        BOOST_TEST(std::abs(line[i].x()) < 1e-12);
    }
    BOOST_TEST((line[1] - Vector3(0, 0, 40)).norm() < 1e-12);
    BOOST_TEST((line[5] - Vector3(0, 10, 50)).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_radius_that_does_not_fit_is_lessened_and_a_straight_corner_kept) {
    const Line line = bent({{0, 0, 0}, {0, 0, 10}, {0, 10, 10}}, 100, 3);
    BOOST_TEST((line[1] - Vector3(0, 0, 10 - 4.9)).norm() < 1e-12);
    BOOST_TEST(bent({{0, 0, 0}, {0, 0, 10}, {0, 0, 30}}, 5, 3).size() == 3);
}

BOOST_AUTO_TEST_CASE(a_smooth_line_goes_through_its_points_without_corners) {
    const Line points{{0, 0, 0}, {100, 20, 0}, {140, 120, 30}, {60, 160, 90}}, line = smooth(points, 2);
    for (const Vector3& point : points) {
        const bool found = std::any_of(line.begin(), line.end(),
                                       [&](const Vector3& p) { return (p - point).norm() < 1e-9; });
        BOOST_TEST(found);
    }
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const double cosine = (line[i] - line[i - 1]).normalized().dot((line[i + 1] - line[i]).normalized());
        BOOST_TEST(cosine > std::cos(0.15));
    }
    BOOST_TEST(lengthOf(line) > lengthOf(points));
    BOOST_TEST(lengthOf(line) < 1.2 * lengthOf(points));
}

BOOST_AUTO_TEST_CASE(rods_and_pipes_are_closed_solids_of_area_times_length) {
    const Line line = bent(kElbow, 12, 12);
    const double length = lengthOf(line);
    requireSolid(rod(line, 3, 60), M_PI * 9 * length, 0.01);
    requireSolid(pipe(line, 3, 1, 60), M_PI * 5 * length, 0.01);
    const Line straight = smooth({{0, 0, 0}, {0, 30, 40}, {0, 60, 80}}, 0.5);
    requireSolid(variedRod(
                     straight, [](double along) { return along < 60 ? 3.0 : 4.0; }, 60),
                 M_PI * (9 * 60 + 16 * 40), 0.01);
}

BOOST_AUTO_TEST_CASE(a_rod_stays_within_its_radius_of_its_line) {
    const Line line = smooth({{0, 0, 0}, {80, 30, 10}, {90, 100, 60}, {10, 140, 80}}, 5);
    const int segments = 12;
    const Piece piece = rod(line, 4, segments);
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
        BOOST_TEST(std::abs((piece.vertices[i] - line[i / segments]).norm() - 4) < 1e-9);
    }
}

/// A flat cable on a level line keeps its face up, whatever the bends.
BOOST_AUTO_TEST_CASE(a_pulled_section_does_not_twist) {
    const Line line = bent({{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {100, 50, 0}, {100, -40, 0}}, 10, 6);
    const Piece strip = pulled(rectangleSection({-1, -8}, {1, 8}), line, Vector3::UnitZ());
    for (const Vector3& vertex : strip.vertices) BOOST_TEST(std::abs(std::abs(vertex.z()) - 1) < 1e-9);
}

const Box kGridBox(Vector3(-3, 1, 2), Vector3(17, 14, 5));

Mesh gridMesh(std::size_t triangles) {
    Assembly assembly;
    assembly.add("box", gridBox(kGridBox, triangles));
    return assembly.mesh();
}

BOOST_AUTO_TEST_CASE(any_number_of_triangles_is_reached) {
    for (std::size_t n = 12; n < 400; ++n) BOOST_TEST(gridMesh(n).triangles.size() == n - n % 2);
    BOOST_TEST(gridMesh(100001).triangles.size() == 100000);
}

BOOST_AUTO_TEST_CASE(it_is_a_closed_solid_of_the_box) {
    for (const std::size_t n : {12, 14, 100, 346, 5000}) {
        const Mesh mesh = gridMesh(n);
        BOOST_TEST(isClosed(mesh, mesh.components[0]));
        BOOST_TEST(signedVolume(mesh) == kGridBox.volume(), boost::test_tools::tolerance(1e-6));
        BOOST_TEST((boundingBox(mesh).min() == kGridBox.min()));
        BOOST_TEST((boundingBox(mesh).max() == kGridBox.max()));
    }
}

BOOST_AUTO_TEST_CASE(every_triangle_lies_in_a_face_exactly_and_none_is_degenerate) {
    const Mesh mesh = gridMesh(700);
    for (const TriangleIndices& t : mesh.triangles) {
        const Vector3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        bool isInFace = false;
        for (int axis = 0; axis < 3; ++axis) {
            isInFace = isInFace || (a[axis] == b[axis] && b[axis] == c[axis] &&
                                    (a[axis] == kGridBox.min()[axis] || a[axis] == kGridBox.max()[axis]));
        }
        BOOST_TEST(isInFace);
        BOOST_TEST((b - a).cross(c - a).norm() > 0.01);
    }
}

BOOST_AUTO_TEST_SUITE_END()
