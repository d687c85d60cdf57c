#include "program/scenes/sheet_metal.h"

#include <boost/test/unit_test.hpp>

#include "program/scenes/scene_checks.h"
#include "support/convex_hull.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

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

}  // namespace
