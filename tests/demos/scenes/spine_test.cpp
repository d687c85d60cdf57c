#include "demos/scenes/spine.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/solids.h"
#include "support/convex_hull.h"

BOOST_AUTO_TEST_SUITE(spine_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

Spine threeBends() {
    Pose start;
    start.translation = {5, -3, 2};
    Spine spine(start);
    spine.straight(20).bend(30, 1.2, 0.4).straight(15).bend(20, 2.5, -2).bend(40, 0.7, 1);
    return spine;
}

double angleBetween(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

BOOST_AUTO_TEST_CASE(frames_are_rotations_and_move_at_unit_speed_along_their_x) {
    const Spine spine = threeBends();
    constexpr double kStep = 1e-4;
    for (double s = -5; s < spine.length() + 5; s += 0.37) {
        const Pose here = spine.frameAt(s), next = spine.frameAt(s + kStep);
        BOOST_TEST(rotationDefect(here) < 1e-12);
        BOOST_TEST((next.translation - here.translation - kStep * here.rotation.col(0)).norm() < 1e-8);
        BOOST_TEST(angleBetween(here.rotation.col(0), next.rotation.col(0)) < kStep / 19);
    }
}

BOOST_AUTO_TEST_CASE(a_bend_turns_by_its_angle_towards_its_direction) {
    Spine spine;
    spine.straight(10).bend(30, M_PI_2, M_PI_2);
    const Pose end = spine.frameAt(spine.length());
    BOOST_TEST((end.translation - Vector3(40, 0, 30)).norm() < 1e-12);
    BOOST_TEST((end.rotation.col(0) - Vector3(0, 0, 1)).norm() < 1e-12);
    BOOST_TEST((end.rotation.col(1) - Vector3(0, 1, 0)).norm() < 1e-12);
    BOOST_TEST(spine.length() == 10 + 30 * M_PI_2);
}

BOOST_AUTO_TEST_CASE(a_spine_through_points_begins_and_ends_on_them_and_rounds_the_corners) {
    const std::vector<Vector3> points{{0, 0, 0},     {100, 0, 0},   {100, 60, 20},
                                      {150, 60, 20}, {200, 60, 20}, {200, 0, 0}};
    const Spine spine = Spine::through(points, 15);
    BOOST_TEST((spine.frameAt(0).translation - points.front()).norm() < 1e-9);
    BOOST_TEST((spine.frameAt(spine.length()).translation - points.back()).norm() < 1e-9);
    BOOST_TEST((spine.frameAt(0).rotation.col(2) - Vector3::UnitZ()).norm() < 1e-12);
    for (const Spine::Piece& piece : spine.pieces()) BOOST_TEST(piece.length > 0);
    double farthest = 0;
    for (double s = 0; s < spine.length(); s += 0.5) {
        double nearest = 1e9;
        for (const Vector3& p : points)
            nearest = std::min(nearest, (p - spine.frameAt(s).translation).norm());
        farthest = std::max(farthest, nearest);
    }
    BOOST_TEST(farthest < 55);
    const Spine wide = Spine::through(points, 1000);  // as wide as fits
    BOOST_TEST((wide.frameAt(wide.length()).translation - points.back()).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(stations_increase_and_hold_every_piece_end) {
    const Spine spine = threeBends();
    const std::vector<double> stations = spine.stations(8, 0.3);
    BOOST_TEST(stations.front() == 0);
    BOOST_TEST(std::abs(stations.back() - spine.length()) < 1e-9);
    for (std::size_t i = 1; i < stations.size(); ++i) {
        BOOST_TEST(stations[i] > stations[i - 1]);
        const double turn = angleBetween(spine.frameAt(stations[i - 1]).rotation.col(0),
                                         spine.frameAt(stations[i]).rotation.col(0));
        BOOST_TEST(turn <= 0.3 + 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_bar_along_a_spine_is_a_closed_solid_of_area_times_length) {
    const Spine spine = threeBends();
    Assembly assembly;
    assembly.add("bar", sweptAlong(spine, fullSection(circle({0, 0}, 4, 64)), spine.stations(50, 0.02)));
    const Mesh mesh = assembly.mesh();
    BOOST_TEST(isClosed(mesh, mesh.components[0]));
    BOOST_TEST(signedVolume(mesh) == M_PI * 16 * spine.length(), boost::test_tools::tolerance(0.005));
}

BOOST_AUTO_TEST_CASE(scales_make_a_bar_thinner) {
    Spine spine;
    spine.straight(10);
    Assembly assembly;
    assembly.add("cone", sweptAlong(spine, rectangleSection({-1, -1}, {1, 1}), {0, 10}, {1, 0.5}));
    const Mesh mesh = assembly.mesh();
    BOOST_TEST(isClosed(mesh, mesh.components[0]));
    BOOST_TEST(signedVolume(mesh) == 10.0 / 3 * (4 + 2 + 1), boost::test_tools::tolerance(1e-6));
}

/// A hat with different corners, both left and right turns.
const Polyline kHat{{120, 2}, {90, 2}, {80, 148}, {-80, 148}, {-90, 2}, {-120, 2}};
const std::vector<double> kRadii{6, 20, 20, 6};

BOOST_AUTO_TEST_CASE(a_profile_runs_from_end_to_end_at_an_even_pace_without_kinks) {
    const Profile profile(kHat, kRadii);
    BOOST_TEST((profile.at(0) - kHat.front()).norm() < 1e-12);
    BOOST_TEST((profile.at(profile.length()) - kHat.back()).norm() < 1e-9);
    constexpr double kStep = 0.01;
    Vector2 before = profile.at(kStep) - profile.at(0);
    for (double w = kStep; w + kStep < profile.length(); w += kStep) {
        const Vector2 step = profile.at(w + kStep) - profile.at(w);
        BOOST_REQUIRE(std::abs(step.norm() - kStep) < 1e-6);
        BOOST_REQUIRE((step - before).norm() < 1.1 * kStep * kStep / 6);  // no sharper than the least radius
        before = step;
    }
}

BOOST_AUTO_TEST_CASE(arcs_are_marked_by_lines_and_touch_their_legs) {
    const Profile profile(kHat, kRadii);
    const std::vector<double> lines = profile.arcLines(3);
    BOOST_TEST(lines.size() == 4 * 4);  // each corner turns by less than 90 degrees
    BOOST_TEST(std::abs(profile.at(lines[4]).y() - 148) > 20 * (1 - std::cos(1.4)));
    BOOST_TEST(std::abs(profile.at(lines[7]).y() - 148) < 1e-9);
    for (int k = 0; k < 4; ++k) {
        BOOST_TEST(profile.corner(k) > lines[4 * k]);
        BOOST_TEST(profile.corner(k) < lines[4 * k + 3]);
    }
}

BOOST_AUTO_TEST_CASE(a_radius_that_does_not_fit_is_lessened) {
    const Profile profile({{0, 0}, {10, 0}, {10, 10}}, {1000});
    BOOST_TEST((profile.at(profile.length()) - Vector2(10, 10)).norm() < 1e-9);
    BOOST_TEST(profile.length() < 20);
    BOOST_TEST(profile.length() > 10 * std::sqrt(2.0));
}

BOOST_AUTO_TEST_SUITE_END()
