#include "program/scenes/panel.h"

#include <boost/test/unit_test.hpp>

#include "program/scenes/scene_checks.h"
#include "support/convex_hull.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

PanelShape flat(double width, double depth, double thickness) {
    PanelShape shape;
    shape.surface = [](double u, double v) { return Vector3(u, v, 7); };
    shape.low = {0, 0};
    shape.high = {width, depth};
    shape.thickness = thickness;
    return shape;
}

Mesh meshOf(const Panel& panel) {
    Assembly assembly;
    assembly.add("panel", panel.piece());
    return assembly.mesh();
}

void requireSolid(const Panel& panel, double volume, double relative) {
    const Mesh mesh = meshOf(panel);
    BOOST_TEST(mesh.triangles.size() == panel.triangleCount());
    BOOST_TEST(isClosed(mesh, mesh.components[0]));
    BOOST_TEST(signedVolume(mesh) == volume, boost::test_tools::tolerance(relative));
}

BOOST_AUTO_TEST_CASE(a_flat_panel_is_a_plate) {
    requireSolid(Panel(flat(100, 60, 2), {20, 2}), 100 * 60 * 2, 1e-6);
    const Box box = boundingBox(meshOf(Panel(flat(100, 60, 2), {7, 2})));
    BOOST_TEST((box.min() - Vector3(0, 0, 6)).norm() < 1e-6);
    BOOST_TEST((box.max() - Vector3(100, 60, 8)).norm() < 1e-6);
}

BOOST_AUTO_TEST_CASE(openings_take_their_area_away) {
    PanelShape round = flat(200, 160, 2), slot = flat(200, 160, 2);
    round.openings = {{{60, 80}, {20, 20}, 2}, {{140, 80}, {15, 15}, 2}};
    requireSolid(Panel(round, {3, 16}), 2 * (200 * 160 - M_PI * (20 * 20 + 15 * 15)), 2e-3);
    slot.openings = {{{100, 80}, {50, 20}, 40}};
    requireSolid(Panel(slot, {3, 16}), 2 * (200 * 160 - 100 * 40), 5e-3);
}

BOOST_AUTO_TEST_CASE(the_rim_of_a_round_opening_lies_on_its_circle_and_no_point_within) {
    PanelShape shape = flat(200, 160, 2);
    shape.openings = {{{90, 70}, {20, 20}, 2}};
    for (const double step : {2.0, 9.0, 60.0}) {
        int onRim = 0;
        for (const Vector3& v : meshOf(Panel(shape, {step, 3})).vertices) {
            const double radius = (v - Vector3(90, 70, v.z())).norm();
            BOOST_TEST(radius > 20 - 1e-4);
            if (radius < 20 + 1e-4) ++onRim;
        }
        BOOST_TEST(onRim >= 2 * 12);
    }
}

BOOST_AUTO_TEST_CASE(openings_that_do_not_fit_are_left_out) {
    PanelShape shape = flat(200, 160, 2);
    shape.openings = {{{90, 70}, {20, 20}, 2}, {{115, 70}, {20, 20}, 2}, {{5, 80}, {20, 20}, 2}};
    requireSolid(Panel(shape, {3, 16}), 2 * (200 * 160 - M_PI * 20 * 20), 2e-3);
}

BOOST_AUTO_TEST_CASE(large_openings_are_kept_however_coarse_the_panel) {
    PanelShape shape = flat(900, 500, 2);
    shape.openings = {{{250, 250}, {150, 150}, 40}, {{620, 250}, {150, 150}, 40}};  // 70 mm apart
    for (const double step : {5.0, 40.0, 120.0, 400.0, 1000.0}) {
        requireSolid(Panel(shape, {step, 2}), 2 * (900 * 500 - 2 * 300 * 300), 0.02);
    }
}

BOOST_AUTO_TEST_CASE(curved_panels_in_layers_are_closed_and_keep_their_distance) {
    PanelShape shape = flat(300, 200, 1);
    shape.surface = [](double u, double v) {
        return Vector3(u, v, 0.0004 * u * u - 0.001 * v * v + 6 * beadAt(v, 100, 15, 20));
    };
    shape.openings = {{{150, 40}, {18, 12}, 4}};
    shape.vLines = {65, 80, 85, 115, 120, 135};
    const Model lower = Model::build(meshOf(Panel(shape, {4, 3})));
    BOOST_TEST(isClosed(meshOf(Panel(shape, {4, 3})),
                        {"panel", 0, static_cast<std::uint32_t>(Panel(shape, {4, 3}).triangleCount())}));
    shape.offset = 4;
    const Model upper = Model::build(meshOf(Panel(shape, {4, 3})));
    Workspace workspace;
    const double apart = distance(lower, upper, {}, {}, workspace).distance;
    BOOST_TEST(apart > 2.8);  // 4 less two halves of a sheet, less what chords take
    BOOST_TEST(apart <= 3.001);
}

BOOST_AUTO_TEST_CASE(beads_rise_smoothly_between_their_lines) {
    BOOST_TEST(smoothStep(1, 2, 4) == 0);
    BOOST_TEST(smoothStep(3, 2, 4) == 0.5);
    BOOST_TEST(smoothStep(9, 2, 4) == 1);
    BOOST_TEST(beadAt(10, 12, 3, 2) == 1);
    BOOST_TEST(beadAt(16, 12, 3, 2) == 0.5);
    BOOST_TEST(beadAt(18, 12, 3, 2) == 0);
}

}  // namespace
