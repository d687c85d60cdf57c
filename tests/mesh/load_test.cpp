#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(load_test)

using namespace testing;

const std::string kShow = "<instance_geometry url=\"#shape\"/>";

/// A quarter turn about z, then a step: exact in float.
const std::string kQuarterTurn = "<matrix>0 -1 0 100  1 0 0 20  0 0 1 -3  0 0 0 1</matrix>";
Vector3 quarterTurned(const Vector3& v) {
    return {100 - v.y(), 20 + v.x(), v.z() - 3};
}

LoadOptions as(MeshReading reading) {
    LoadOptions options;
    options.reading = reading;
    return options;
}

using Names = std::vector<std::string>;

BOOST_AUTO_TEST_CASE(transforms_of_nested_nodes_are_applied) {
    const std::string nodes = "<node name=\"outer\">" + kQuarterTurn + kShow + "<node name=\"inner\">" +
                              kQuarterTurn + kShow + "</node></node>";
    const std::string text = daeText(tetrahedron(), nodes);
    const auto twice = [](const Vector3& v) { return quarterTurned(quarterTurned(v)); };
    const Mesh stored = loadText("two.dae", text);
    BOOST_REQUIRE(stored.triangles.size() == 8u);
    requireTetrahedron(stored, 0, quarterTurned);
    requireTetrahedron(stored, 4, twice);
    BOOST_TEST(namesOf(stored) == (Names{"outer/shape", "inner/shape"}));
    // The steps of OMPL.app put inner nodes first.
    const Mesh asOmplApp = loadText("two.dae", text, as(MeshReading::kOmplAppEnvironment));
    BOOST_REQUIRE(asOmplApp.triangles.size() == 8u);
    requireTetrahedron(asOmplApp, 0, twice);
    requireTetrahedron(asOmplApp, 4, quarterTurned);
    BOOST_TEST(namesOf(asOmplApp) == (Names{"inner/shape", "outer/shape"}));
}

BOOST_AUTO_TEST_CASE(stored_coordinates_are_transformed_in_double) {
    // 1 + 2^-20 times 1 + 2^-21, which no float holds.
    const double factor = 1 + std::ldexp(1.0, -20);
    const double coordinate = 1 + std::ldexp(1.0, -21);
    Mesh mesh = tetrahedron();
    mesh.vertices[0].x() = coordinate;
    const std::string node =
        "{\"mesh\":0,\"matrix\":[1.00000095367431640625,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}";
    const Mesh stored = loadText("a.gltf", gltfText(mesh, node));
    BOOST_TEST(stored.vertices[stored.triangles[0][0]].x() == factor * coordinate);
    const Mesh asFloats = loadText("a.gltf", gltfText(mesh, node), as(MeshReading::kOmplAppEnvironment));
    BOOST_TEST(asFloats.vertices[asFloats.triangles[0][0]].x() == static_cast<float>(factor * coordinate));
}

BOOST_AUTO_TEST_CASE(a_mesh_shown_by_several_nodes_is_several_components) {
    const std::string nodes =
        "{\"children\":[1,2,3]},{\"name\":\"left\",\"mesh\":0},"
        "{\"name\":\"right\",\"mesh\":0,\"translation\":[1,2,3]},{\"name\":\"left\",\"mesh\":0}";
    const Mesh mesh = loadText("pair.gltf", gltfText(tetrahedron(), nodes));
    BOOST_REQUIRE(mesh.triangles.size() == 12u);
    requireTetrahedron(mesh, 0, unchanged);
    requireTetrahedron(mesh, 4, [](const Vector3& v) { return Vector3(v + Vector3(1, 2, 3)); });
    requireTetrahedron(mesh, 8, unchanged);
    for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST(mesh.components[i].firstTriangle == 4 * i);
        BOOST_TEST(mesh.components[i].triangleCount == 4u);
    }
    BOOST_TEST(mesh.components[1].name == "right/shape");
}

BOOST_AUTO_TEST_CASE(names_are_kept_and_told_apart) {
    const std::string one = "f 1 2 3\n";
    const std::string file =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\ng rib\n" + one + "g rib#2\n" + one + "g boss\n" + one;
    BOOST_TEST(namesOf(loadText("names.obj", file)) == (Names{"rib", "rib#2", "boss"}));
    const std::string shown = "<node name=\"rib\">" + kShow + "</node>";
    const std::string other =
        "<node name=\"rib\"><instance_geometry url=\"#shape\"/></node><node>" + kShow + "</node>";
    BOOST_TEST(namesOf(loadText("names.dae", daeText(tetrahedron(), shown + other))) ==
               (Names{"rib/shape", "rib/shape#2", "shape"}));
    BOOST_TEST(namesOf(loadText("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + one)) == Names{"bare"});
}

BOOST_AUTO_TEST_CASE(polygons_are_triangulated_and_points_and_lines_left_out_and_counted) {
    const std::string corners = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 2 0\nv 2 9 0\n";
    const std::string faces = "o plate\nf 1 2 3 4\nl 1 2\nf 1 2 3 6 4\np 5\nf 1 2 5\nl 2 3\n";
    for (const MeshReading reading : {MeshReading::kAsStored, MeshReading::kOmplAppRobot}) {
        const Mesh mesh = loadText("plate.obj", corners + faces, as(reading));
        BOOST_TEST(mesh.triangles.size() == 2u + 3u + 1u);
        BOOST_TEST(mesh.origin.ignoredFaces == 3u);
        BOOST_TEST(areaOf(mesh) == 16 + (16 + 10) + 4, boost::test_tools::tolerance(1e-6));
    }
}

BOOST_AUTO_TEST_CASE(a_concave_quad_stays_within_its_outline) {
    const Mesh mesh = loadText("dart.off", "OFF\n4 1 0\n0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 0 1 2 3\n");
    BOOST_REQUIRE(mesh.triangles.size() == 2u);
    for (const TriangleIndices& t : mesh.triangles) {
        const Vector3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]],
                      v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
        BOOST_TEST(u.cross(v).z() > 0);
    }
    BOOST_TEST(areaOf(mesh) == 4);
}

BOOST_AUTO_TEST_CASE(degenerate_and_repeated_triangles_are_loaded_as_they_stand) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nf 1 2 4\nf 4 2 1\nf 1 2 4\n";
    BOOST_TEST(loadText("a.obj", text).triangles.size() == 5u);
    BOOST_TEST(loadText("a.obj", text, as(MeshReading::kOmplAppEnvironment)).triangles.size() == 5u);
}

BOOST_AUTO_TEST_CASE(the_scale_is_applied_in_double_and_reported) {
    LoadOptions options;
    options.scale = 0.0254;
    const Mesh mesh = loadText("inches.obj", objText(tetrahedron(), "a"), options);
    requireTetrahedron(mesh, 0, [](const Vector3& v) { return Vector3(0.0254 * v); });
    BOOST_TEST(mesh.origin.scale == 0.0254);
    options.reading = MeshReading::kOmplAppRobot;
    const Mesh robot = loadText("inches.obj", objText(tetrahedron(), "a"), options);
    const Mesh unscaled = loadText("inches.obj", objText(tetrahedron(), "a"), as(MeshReading::kOmplAppRobot));
    BOOST_REQUIRE(robot.vertices.size() == unscaled.vertices.size());
    for (std::size_t i = 0; i < robot.vertices.size(); ++i) {
        BOOST_TEST((robot.vertices[i] == 0.0254 * unscaled.vertices[i]));
    }
    BOOST_TEST((robot.origin.shift == 0.0254 * unscaled.origin.shift));
    for (const double scale : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        options.scale = scale;
        BOOST_CHECK_THROW(loadText("inches.obj", objText(tetrahedron(), "a"), options),
                          std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(the_unit_and_up_axis_of_a_collada_file_are_left_out_or_applied_and_said) {
    const std::string asset = "<unit name=\"quarter\" meter=\"0.25\"/><up_axis>Z_UP</up_axis>";
    const std::string text = daeText(tetrahedron(), "<node name=\"a\">" + kShow + "</node>", asset);
    const Mesh stored = loadText("a.dae", text);
    requireTetrahedron(stored, 0, unchanged);
    BOOST_TEST(stored.origin.unitMetres == 0.25);
    BOOST_TEST(stored.origin.upAxis == 'z');
    const Mesh asOmplApp = loadText("a.dae", text, as(MeshReading::kOmplAppEnvironment));
    requireTetrahedron(asOmplApp, 0,
                       [](const Vector3& v) { return Vector3(0.25 * v.x(), 0.25 * v.z(), -0.25 * v.y()); });
    BOOST_REQUIRE(asOmplApp.origin.notes.size() == 1u);
    BOOST_TEST(holds(asOmplApp.origin.notes[0], "applied", "x' = 0.25 x, y' = 0.25 z, z' = -0.25 y"));
    const Mesh nearly = loadText("a.dae", daeText(tetrahedron(), "<node name=\"a\">" + kShow + "</node>",
                                                  "<unit meter=\"1.0009765625\"/>"));
    requireTetrahedron(nearly, 0, unchanged);
    BOOST_TEST(nearly.origin.unitMetres == 1.0009765625);
    const Mesh plain = loadText("a.dae", daeText(tetrahedron(), "<node name=\"a\">" + kShow + "</node>"));
    BOOST_TEST(plain.origin.unitMetres == 0);
    BOOST_TEST(plain.origin.upAxis == 0);
    BOOST_TEST(plain.origin.notes.empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
