#include "program/scenes/loft.h"

#include <boost/test/unit_test.hpp>

#include "program/scenes/plate.h"
#include "program/scenes/scene_checks.h"
#include "program/scenes/sweep.h"
#include "support/convex_hull.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

Box boxOf(const Piece& piece) {
    Box box;
    for (const Vector3& vertex : piece.vertices) box.extend(vertex);
    return box;
}

void requireSolid(const Piece& piece, double volume, double relative) {
    Assembly assembly;
    assembly.add("piece", piece);
    const Mesh mesh = assembly.mesh();
    BOOST_TEST(isClosed(mesh, mesh.components[0]));
    BOOST_TEST(signedVolume(mesh) == volume, boost::test_tools::tolerance(relative));
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

}  // namespace
