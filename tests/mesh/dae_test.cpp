#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(dae_test)

using namespace testing;

const std::string kShow = "<instance_geometry url=\"#shape\"/>";
const std::string kInput = "<input semantic=\"VERTEX\" source=\"#corners\" offset=\"0\"/>";
const std::string kTriangles =
    "<triangles count=\"4\">" + kInput + "<p>0 1 2 0 3 1 1 3 2 2 3 0 </p></triangles>";
const std::string kText = daeText(tetrahedron(), "<node name=\"a\">" + kShow + "</node>");

Mesh load(const std::string& text) {
    const TemporaryFolder folder;
    return loadMesh(folder.write("part.dae", text));
}

void requireRefused(const std::string& text, const std::string& words) {
    testing::requireRefused("part.dae", text, words);
}

std::string withPrimitives(const std::string& primitives) {
    return replaced(kText, kTriangles, primitives);
}

std::string withNodes(const std::string& nodes) {
    return daeText(tetrahedron(), nodes);
}

std::string withLibrary(const std::string& text, const std::string& library) {
    return replaced(text, "<library_visual_scenes>", library + "<library_visual_scenes>");
}

template <typename Map>
void requireVertices(const std::string& text, Map map) {
    const Mesh mesh = load(text);
    BOOST_REQUIRE(mesh.vertices.size() == 4u);
    for (std::size_t v = 0; v < 4; ++v) {
        const Vector3 wanted = map(tetrahedron().vertices[v]);
        BOOST_TEST(((mesh.vertices[v] - wanted).norm() < 1e-12), mesh.vertices[v].transpose()
                                                                     << ", expected " << wanted.transpose());
    }
}

void requireTriangles(const std::string& text, const std::vector<TriangleIndices>& triangles) {
    const Mesh mesh = load(text);
    BOOST_TEST((mesh.triangles == triangles));
    BOOST_TEST(mesh.components.size() == 1u);
}

std::string array(const std::string& kind, const std::string& id, int count, int width,
                  const std::string& text) {
    return "<source id=\"" + id + "\"><" + kind + " id=\"" + id + "-a\" count=\"" +
           std::to_string(count * width) + "\">" + text + "</" + kind +
           "><technique_common><accessor source=\"#" + id + "-a\" count=\"" + std::to_string(count) +
           "\" stride=\"" + std::to_string(width) + "\"><param name=\"A\" type=\"" +
           (width == 16 ? "float4x4" : "float") + "\"/></accessor></technique_common></source>";
}

/// A skin of one joint, whose inverse bind matrix moves by -x; the bind shape moves by 10 in x.
std::string skin(const std::string& source, const std::string& x) {
    return "<controller id=\"skin\"><skin source=\"#" + source +
           "\"><bind_shape_matrix>1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>" +
           array("Name_array", "names", 1, 1, "bone") +
           array("float_array", "binds", 1, 16, "1 0 0 -" + x + " 0 1 0 0 0 0 1 0 0 0 0 1") +
           "<joints><input semantic=\"JOINT\" source=\"#names\"/><input semantic=\"INV_BIND_MATRIX\" "
           "source=\"#binds\"/></joints></skin></controller>";
}

std::string morph(const std::string& method, const std::string& weight) {
    return "<controller id=\"morph\"><morph source=\"#shape\" method=\"" + method + "\">" +
           array("IDREF_array", "ids", 1, 1, "shape") + array("float_array", "weights", 1, 1, weight) +
           "<targets><input semantic=\"MORPH_TARGET\" source=\"#ids\"/><input semantic=\"MORPH_WEIGHT\" "
           "source=\"#weights\"/></targets></morph></controller>";
}

std::string controlled(const std::string& controllers, const std::string& url) {
    const std::string nodes =
        "<node sid=\"bone\"><translate>3 0 0</translate></node><node name=\"a\"><instance_controller "
        "url=\"#" +
        url + "\"/></node>";
    return withLibrary(withNodes(nodes), "<library_controllers>" + controllers + "</library_controllers>");
}

BOOST_AUTO_TEST_CASE(every_kind_of_primitive_is_read) {
    const std::string other = "<input semantic=\"NORMAL\" source=\"#none\" offset=\"1\"/>";
    requireTriangles(withPrimitives("<triangles count=\"2\">" + kInput + other +
                                    "<p>0 9 1 9 2 9 <!-- c -->0 9 3 9 1 9</p></triangles>"),
                     {{0, 1, 2}, {0, 3, 1}});
    requireTriangles(withPrimitives("<polylist count=\"2\">" + kInput +
                                    "<vcount>3 3</vcount><p>0 1 2 3 1 0</p></polylist>"),
                     {{0, 1, 2}, {3, 1, 0}});
    requireTriangles(
        withPrimitives("<polygons count=\"2\">" + kInput + "<p>0 1 2</p><p>3 1 0</p></polygons>"),
        {{0, 1, 2}, {3, 1, 0}});
    requireTriangles(
        withPrimitives("<tristrips count=\"2\">" + kInput + "<p>0 1 2 3</p><p>3 1 0</p></tristrips>"),
        {{0, 1, 2}, {2, 1, 3}, {3, 1, 0}});
    requireTriangles(withPrimitives("<trifans count=\"1\">" + kInput + "<p>0 1 2 3</p></trifans>"),
                     {{0, 1, 2}, {0, 2, 3}});
    const Mesh mesh = load(withPrimitives(kTriangles + "<lines count=\"2\">" + kInput +
                                          "<p>0 1 2 3</p></lines><linestrips count=\"1\">" + kInput +
                                          "<p>0 1 2 3</p></linestrips>"));
    BOOST_TEST(mesh.triangles.size() == 4u);
    BOOST_TEST(mesh.origin.ignoredFaces == 5u);
}

BOOST_AUTO_TEST_CASE(transforms_apply_in_the_order_of_the_document) {
    const auto node = [](const std::string& transforms) {
        return withNodes("<node name=\"a\">" + transforms + kShow + "</node>");
    };
    requireVertices(node("<translate>1 2 3</translate><scale>2 3 4</scale>"),
                    [](const Vector3& v) { return Vector3(2 * v.x() + 1, 3 * v.y() + 2, 4 * v.z() + 3); });
    requireVertices(node("<scale>2 3 4</scale><translate>1 2 3</translate>"), [](const Vector3& v) {
        return Vector3(2 * (v.x() + 1), 3 * (v.y() + 2), 4 * (v.z() + 3));
    });
    requireVertices(node("<rotate>0 0 2 90</rotate><rotate>0 0 0 0</rotate>"),
                    [](const Vector3& v) { return Vector3(-v.y(), v.x(), v.z()); });
    requireVertices(node("<matrix>0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1</matrix>"),
                    [](const Vector3& v) { return Vector3(5 - v.y(), v.x() + 6, v.z() + 7); });
    requireVertices(node("<lookat>1 2 3 2 2 3 0 1 0</lookat>"),
                    [](const Vector3& v) { return Vector3(1 - v.z(), v.y() + 2, v.x() + 3); });
    requireRefused(node("<skew>45 0 1 0 1 0 0</skew>"), "node 'a' has a <skew>, which is not read");
    requireRefused(node("<translate>1 2</translate>"), "<translate> of node 'a' has 2 numbers, expected 3");
    requireRefused(node("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix>"),
                   "has another last row than 0 0 0 1");
    BOOST_TEST((load(node("<scale>-1 1 1</scale>")).triangles[0] == TriangleIndices{0, 2, 1}));
}

BOOST_AUTO_TEST_CASE(nodes_of_libraries_are_shown_as_often_as_they_are_named) {
    const std::string library =
        "<library_nodes><node id=\"n\" name=\"lib\">" + kShow + "</node></library_nodes>";
    const std::string nodes =
        "<node id=\"shape\"><instance_node url=\"#n\"/></node><instance_node url=\"#n\"/>";
    const Mesh mesh = load(withLibrary(withNodes(nodes), library));
    BOOST_REQUIRE(mesh.components.size() == 2u);
    BOOST_TEST(mesh.components[0].name == "lib/shape");
    requireRefused(withNodes("<node id=\"n\">" + kShow + "<instance_node url=\"#n\"/></node>"),
                   "node 'n' contains itself");
}

BOOST_AUTO_TEST_CASE(references_to_nothing_are_refused_by_name) {
    requireRefused(withNodes("<node id=\"b\"><instance_geometry url=\"#nope\"/></node>"),
                   "node 'b' refers to 'nope', expected the id of a <geometry>, which none has");
    requireRefused(withNodes("<node id=\"b\"><instance_geometry url=\"other.dae#shape\"/></node>"),
                   "node 'b' refers to 'other.dae#shape'");
    requireRefused(replaced(kText, "source=\"#corners\"", "source=\"#corner\""),
                   "refers to 'corner', expected the id of a <vertices>");
    requireRefused(withNodes("<node id=\"b\"><instance_mesh url=\"#shape\"/></node>"),
                   "node 'b' holds <instance_mesh>, which is not read");
}

BOOST_AUTO_TEST_CASE(the_scene_that_is_shown_must_be_clear) {
    const std::string shown = "<scene><instance_visual_scene url=\"#scene\"/></scene>",
                      end = "</visual_scene>";
    const std::string two = replaced(kText, end, end + "<visual_scene id=\"t\"><node/></visual_scene>");
    BOOST_TEST(load(two).triangles.size() == 4u);
    requireRefused(replaced(two, shown, ""),
                   "it has 2 visual scenes, expected a <scene> that tells which to show");
    BOOST_TEST(load(replaced(kText, shown, "")).origin.notes.empty());
    const std::size_t first = kText.find("<library_visual_scenes>");
    const Mesh bare = load(kText.substr(0, first) + "</COLLADA>");
    BOOST_TEST(bare.components[0].name == "shape");
    BOOST_TEST(bare.origin.notes ==
               std::vector<std::string>{"the file has no scene: all of its geometries are read"});
}

BOOST_AUTO_TEST_CASE(counts_that_differ_from_what_is_there_are_refused) {
    requireRefused(replaced(kText, "count=\"12\"", "count=\"15\""),
                   "float_array 'numbers' holds 12 numbers, expected its count, 15");
    requireRefused(replaced(kText, "count=\"4\" stride", "count=\"5\" stride"),
                   "takes 5 rows of 3 numbers after 0 from 12");
    requireRefused(replaced(kText, "triangles count=\"4\"", "triangles count=\"5\""),
                   "holds 4, expected its count, 5");
    requireRefused(replaced(kText, "0 3 1", "0 3 4"),
                   "index 5 in <p> of primitive 0 (<triangles>) of geometry 'shape' refers to vertex 4 of 4");
    requireRefused(replaced(kText, "0 3 1", "0 3 -1"),
                   "number 5 of <p> of primitive 0 (<triangles>) of geometry 'shape' is '-1'");
    requireRefused(replaced(kText, "10.000000", "10,0"),
                   "number 3 of float_array 'numbers' is '10,0', expected a number");
    requireRefused(
        withPrimitives("<polylist count=\"1\">" + kInput + "<vcount>4</vcount><p>0 1 2</p></polylist>"),
        "has 3 corners in <p>, expected the sum of its vcount, 4");
    requireRefused(withPrimitives("<polygons count=\"1\">" + kInput + "<ph><p>0 1 2</p></ph></polygons>"),
                   "has a polygon with holes (<ph>)");
    requireRefused(withPrimitives("<quads count=\"1\"/>" + kTriangles),
                   "(<quads>) of geometry 'shape' is not read");
    requireRefused(replaced(replaced(kText, "<mesh>", "<spline>"), "</mesh>", "</spline>"),
                   "geometry 'shape' is a <spline>");
}

BOOST_AUTO_TEST_CASE(a_skin_is_read_in_its_bind_pose) {
    const auto moved = [](const Vector3& v) { return Vector3(v + Vector3(10, 0, 0)); };
    requireVertices(controlled(skin("shape", "3"), "skin"), moved);
    BOOST_TEST(load(controlled(skin("shape", "3"), "skin")).components[0].name == "a/shape");
    requireVertices(controlled(morph("RELATIVE", "0") + skin("morph", "3"), "skin"), moved);
    // A joint that stands elsewhere than when the skin was bound does not move it.
    requireVertices(controlled(skin("shape", "0"), "skin"), moved);
    BOOST_TEST(load(controlled(skin("shape", "0"), "skin")).origin.notes.size() == 1u);
    requireRefused(controlled(skin("skin", "3"), "skin"), "or refers to itself");
    // The joints place a skin, not the node that shows it.
    const std::string text = controlled(skin("shape", "3"), "skin"), node = "<node name=\"a\">";
    requireVertices(replaced(text, node, node + "<translate>100 0 0</translate>"), moved);
}

BOOST_AUTO_TEST_CASE(transforms_without_a_direction_are_refused) {
    const std::string node = "<node name=\"a\">";
    requireRefused(replaced(kText, node, node + "<rotate>0 0 0 45</rotate>"),
                   "<rotate> of node 'a' has no direction");
    requireRefused(replaced(kText, node, node + "<lookat>1 2 3 1 2 3 0 1 0</lookat>"),
                   "<lookat> of node 'a' has no direction");
}

BOOST_AUTO_TEST_CASE(a_morph_is_read_with_its_weights) {
    requireVertices(controlled(morph("NORMALIZED", "0.5"), "morph"), unchanged);
    requireVertices(controlled(morph("RELATIVE", "0.5"), "morph"),
                    [](const Vector3& v) { return Vector3(1.5 * v); });
    requireRefused(controlled(replaced(morph("RELATIVE", "1"), ">shape<", ">none<"), "morph"),
                   "refers to 'none'");
}

BOOST_AUTO_TEST_CASE(a_unit_of_one_element_that_differs_is_refused) {
    const std::string text =
        daeText(tetrahedron(), "<node name=\"a\"><asset><unit meter=\"1\"/></asset>" + kShow + "</node>",
                "<unit meter=\"0.01\"/><up_axis>Z_UP</up_axis>");
    requireRefused(text, "the asset of node 'a' has a unit of '1' metres, expected the file's, 0.01");
    const Mesh mesh = load(replaced(text, "<unit meter=\"1\"/>", ""));
    BOOST_TEST(mesh.origin.unitMetres == 0.01);
    BOOST_TEST(mesh.origin.upAxis == 'z');
    requireRefused(replaced(kText, "version=\"1.4.1\"", "version=\"1.3.0\""),
                   "its COLLADA version is '1.3.0'");
    requireRefused(replaced(kText, "<COLLADA", "<!DOCTYPE COLLADA [<!ENTITY n \"x\">]><COLLADA"),
                   "has a DOCTYPE with declarations");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
