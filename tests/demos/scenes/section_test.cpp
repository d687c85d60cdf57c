#include "demos/scenes/section.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(section_test)

using namespace clearway;
using namespace clearway::scenes;

double area(const Section& section) {
    double twice = 0;
    for (const TriangleIndices& t : section.cap) {
        const Vector2 a = section.points[t[1]] - section.points[t[0]],
                      b = section.points[t[2]] - section.points[t[0]];
        const double corner = a.x() * b.y() - a.y() * b.x();
        BOOST_TEST(corner > 0);
        twice += corner;
    }
    return twice / 2;
}

double loopArea(const Section& section) {
    double twice = 0;
    for (const auto& loop : section.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vector2 &a = section.points[loop[i]], &b = section.points[loop[(i + 1) % loop.size()]];
            twice += a.x() * b.y() - a.y() * b.x();
        }
    }
    return twice / 2;
}

const Polyline kCorner{{0, 0}, {10, 0}, {10, 10}};

BOOST_AUTO_TEST_CASE(a_fillet_lies_on_its_circle_and_touches_both_lines) {
    const Polyline line = filleted(kCorner, {3}, 4);
    BOOST_TEST(line.size() == 2 + 5);
    BOOST_TEST((line[1] - Vector2(7, 0)).norm() < 1e-12);
    BOOST_TEST((line[5] - Vector2(10, 3)).norm() < 1e-12);
    for (std::size_t i = 1; i <= 5; ++i) BOOST_TEST(std::abs((line[i] - Vector2(7, 3)).norm() - 3) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_right_turn_is_filleted_as_a_left_one) {
    const Polyline line = filleted({{0, 0}, {10, 0}, {10, -10}}, {3}, 4);
    for (std::size_t i = 1; i <= 5; ++i) BOOST_TEST(std::abs((line[i] - Vector2(7, -3)).norm() - 3) < 1e-12);
}

BOOST_AUTO_TEST_CASE(radius_nought_keeps_the_corner_and_too_large_a_radius_is_lessened) {
    BOOST_TEST(filleted(kCorner, {0}, 4).size() == 3);
    const Polyline line = filleted(kCorner, {100}, 4);
    BOOST_TEST((line[1] - Vector2(10 - 4.9, 0)).norm() < 1e-12);
    BOOST_TEST((line[5] - Vector2(10, 4.9)).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(an_offset_line_keeps_its_distance_from_every_segment) {
    const Polyline line{{0, 0}, {10, 1}, {14, 8}, {20, 7}}, moved = offsetLine(line, 2);
    BOOST_REQUIRE(moved.size() == line.size());
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vector2 along = (line[i + 1] - line[i]).normalized(), left(-along.y(), along.x());
        BOOST_TEST(std::abs(left.dot(moved[i] - line[i]) - 2) < 1e-12);
        BOOST_TEST(std::abs(left.dot(moved[i + 1] - line[i]) - 2) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(caps_fill_what_the_loops_bound) {
    const Section sheet = sheetSection({{0, 0}, {10, 0}, {10, 10}}, 2);
    BOOST_TEST(std::abs(area(sheet) - 40) < 1e-12);  // the middle line's length times the thickness
    const Section square = rectangleSection({1, 2}, {4, 6});
    BOOST_TEST(std::abs(area(square) - 12) < 1e-12);
    const Section ring = ringSection(squareAround({1, 1}, 5, 16), circle({1, 1}, 2, 16, M_PI_4));
    const double disc = 16 * 0.5 * 4 * std::sin(2 * M_PI / 16);
    BOOST_TEST(std::abs(area(ring) - (100 - disc)) < 1e-12);
    const Section tube =
        ringSection(roundedRectangle({0, 0}, {9, 7}, 2, 3), roundedRectangle({1, 1}, {8, 6}, 1, 3));
    for (const Section* section : {&sheet, &square, &ring, &tube}) {
        BOOST_TEST(std::abs(area(*section) - loopArea(*section)) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(a_square_around_a_circle_has_its_corners) {
    const Polyline square = squareAround({1, 2}, 3, 12);
    for (const double x : {-3.0, 3.0}) {
        for (const double y : {-3.0, 3.0}) {
            const bool found = std::any_of(square.begin(), square.end(), [&](const Vector2& p) {
                return (p - Vector2(1 + x, 2 + y)).norm() < 1e-12;
            });
            BOOST_TEST(found);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
