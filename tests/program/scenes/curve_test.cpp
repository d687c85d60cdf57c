#include "program/scenes/curve.h"

#include <boost/test/unit_test.hpp>

#include "program/scenes/scene_checks.h"
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

}  // namespace
