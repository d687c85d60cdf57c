#include "demos/scenes/sheet_metal.h"

#include <boost/test/unit_test.hpp>

#include "demos/scenes/scene_checks.h"
#include "support/convex_hull.h"

BOOST_AUTO_TEST_SUITE(sheet_metal_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

PanelShape flat(double width, double depth, double thickness) {
    PanelShape shape;
    shape.surface = [](double u, double v) { return Vector3(u, v, 7); };
    shape.low = {0, 0};
    shape.high = {width, depth};
    shape.thickness = thickness;
    return shape;
}

Mesh panelMesh(const Panel& panel) {
    Assembly assembly;
    assembly.add("panel", panel.piece());
    return assembly.mesh();
}

void requirePanel(const Panel& panel, double volume, double relative) {
    const Mesh mesh = panelMesh(panel);
    BOOST_TEST(mesh.triangles.size() == panel.triangleCount());
    BOOST_TEST(isClosed(mesh, mesh.components[0]));
    BOOST_TEST(signedVolume(mesh) == volume, boost::test_tools::tolerance(relative));
}

BOOST_AUTO_TEST_CASE(a_flat_panel_is_a_plate) {
    requirePanel(Panel(flat(100, 60, 2), {20, 2}), 100 * 60 * 2, 1e-6);
    const Box box = boundingBox(panelMesh(Panel(flat(100, 60, 2), {7, 2})));
    BOOST_TEST((box.min() - Vector3(0, 0, 6)).norm() < 1e-6);
    BOOST_TEST((box.max() - Vector3(100, 60, 8)).norm() < 1e-6);
}

BOOST_AUTO_TEST_CASE(openings_take_their_area_away) {
    PanelShape round = flat(200, 160, 2), slot = flat(200, 160, 2);
    round.openings = {{{60, 80}, {20, 20}, 2}, {{140, 80}, {15, 15}, 2}};
    requirePanel(Panel(round, {3, 16}), 2 * (200 * 160 - M_PI * (20 * 20 + 15 * 15)), 2e-3);
    slot.openings = {{{100, 80}, {50, 20}, 40}};
    requirePanel(Panel(slot, {3, 16}), 2 * (200 * 160 - 100 * 40), 5e-3);
}

BOOST_AUTO_TEST_CASE(the_rim_of_a_round_opening_lies_on_its_circle_and_no_point_within) {
    PanelShape shape = flat(200, 160, 2);
    shape.openings = {{{90, 70}, {20, 20}, 2}};
    for (const double step : {2.0, 9.0, 60.0}) {
        int onRim = 0;
        for (const Vector3& v : panelMesh(Panel(shape, {step, 3})).vertices) {
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
    requirePanel(Panel(shape, {3, 16}), 2 * (200 * 160 - M_PI * 20 * 20), 2e-3);
}

BOOST_AUTO_TEST_CASE(large_openings_are_kept_however_coarse_the_panel) {
    PanelShape shape = flat(900, 500, 2);
    shape.openings = {{{250, 250}, {150, 150}, 40}, {{620, 250}, {150, 150}, 40}};  // 70 mm apart
    for (const double step : {5.0, 40.0, 120.0, 400.0, 1000.0}) {
        requirePanel(Panel(shape, {step, 2}), 2 * (900 * 500 - 2 * 300 * 300), 0.02);
    }
}

BOOST_AUTO_TEST_CASE(curved_panels_in_layers_are_closed_and_keep_their_distance) {
    PanelShape shape = flat(300, 200, 1);
    shape.surface = [](double u, double v) {
        return Vector3(u, v, 0.0004 * u * u - 0.001 * v * v + 6 * beadAt(v, 100, 15, 20));
    };
    shape.openings = {{{150, 40}, {18, 12}, 4}};
    shape.vLines = {65, 80, 85, 115, 120, 135};
    const Model lower = Model::build(panelMesh(Panel(shape, {4, 3})));
    BOOST_TEST(isClosed(panelMesh(Panel(shape, {4, 3})),
                        {"panel", 0, static_cast<std::uint32_t>(Panel(shape, {4, 3}).triangleCount())}));
    shape.offset = 4;
    const Model upper = Model::build(panelMesh(Panel(shape, {4, 3})));
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

void addSome(SheetMetal& metal) {
    metal.onBothSides([&] {
        metal.panel("plate", {[](double u, double v) { return Vector3(u, 100 + v, 0.01 * v * v); },
                              {0, 0},
                              {200, 90},
                              1,
                              0,
                              {{{80, 45}, {20, 15}, 2}}});
        metal.beam("hat", across(110, 190), sheetSection(metal.rounded(hatLine(40, 20, 10), 4), 1.5));
        metal.turnedPart("stud", domeOutline(4, 5, 3), {10, 150, 40}, Vector3::UnitZ());
        metal.turnedPart("stud", domeOutline(4, 5, 3), {30, 150, 40}, Vector3::UnitX());
    });
    metal.part("stud", turned(domeOutline(4, 5, 3), 8));
}

BOOST_AUTO_TEST_CASE(what_is_only_counted_has_as_many_triangles_as_what_is_made) {
    for (const double step : {10.0, 33.0, 120.0}) {
        Detail detail;
        detail.step = step;
        SheetMetal made(detail, false), counted(detail, true);
        addSome(made);
        addSome(counted);
        BOOST_TEST(made.triangleCount() == made.assembly().triangleCount());
        BOOST_TEST(counted.triangleCount() == made.triangleCount());
        BOOST_TEST(counted.assembly().triangleCount() == 0);
    }
}

BOOST_AUTO_TEST_CASE(both_sides_are_solids_that_mirror_each_other) {
    SheetMetal metal(Detail{}, false);
    addSome(metal);
    const Mesh mesh = metal.assembly().mesh();
    BOOST_REQUIRE(mesh.components.size() == 9);
    for (const Component& component : mesh.components) {
        BOOST_TEST(isClosed(mesh, component));
        BOOST_TEST(signedVolume(mesh, component) > 0);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const Component &right = mesh.components[i], &left = mesh.components[i + 4];
        BOOST_TEST(right.name.find("_right") != std::string::npos);
        BOOST_TEST(left.name.find("_left") != std::string::npos);
        BOOST_TEST(signedVolume(mesh, right) == signedVolume(mesh, left), boost::test_tools::tolerance(1e-9));
        const Vector3 a = mesh.vertices[mesh.triangles[right.firstTriangle][0]],
                      b = mesh.vertices[mesh.triangles[left.firstTriangle][0]];
        BOOST_TEST((a - Vector3(b.x(), -b.y(), b.z())).norm() == 0);
    }
}

BOOST_AUTO_TEST_SUITE_END()
