// STL files as programs write them, sound ones and damaged ones.
#include <boost/test/unit_test.hpp>

#include "mesh/mesh_files.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(stl_test)

using namespace testing;

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string solid(const std::string& facets, const std::string& name = "a") {
    return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

BOOST_AUTO_TEST_CASE(texts_as_programs_write_them_are_read) {
    std::string upper = solid(kFacet);
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    std::string oneLine = solid(kFacet);
    for (char& c : oneLine) c = c == '\n' ? ' ' : c;
    oneLine[oneLine.find(" facet")] = '\n';  // the name ends with its line
    for (const std::string& text : std::vector<std::string>{
             solid(kFacet), upper, oneLine, "\xEF\xBB\xBF" + solid(kFacet),
             solid(kFacet,
                   "pi\xC3\xA8"
                   "ce \xC3\xA9"),
             solid(kFacet, ""), "\n\n " + solid("\n" + kFacet + "\n\n"),
             replaced(solid(kFacet), "endloop", "endloop 1"),
             replaced(solid(kFacet), "outer loop", "outer loop first"),
             replaced(solid(kFacet), "facet normal 0 0 1", "facet"),
             replaced(solid(kFacet), "normal 0 0 1", "normal nan nan nan"), solid("color 1 0 0\n" + kFacet),
             solid(kFacet) + std::string("\0\x1A", 2), replaced(solid(kFacet), "endloop", "\n\nendloop"),
             replaced(solid(kFacet), "vertex 1 0 0", "vertex\t+1.0e0   0.  .0")}) {
        const Mesh mesh = loadText("a.stl", text);
        BOOST_TEST(mesh.triangles.size() == 1u, text);
        BOOST_TEST(areaOf(mesh) == 0.5, text);
        BOOST_TEST(mesh.origin.format == "STL");
        BOOST_TEST(mesh.origin.isChecked);
    }
}

BOOST_AUTO_TEST_CASE(each_solid_is_a_component_and_keeps_its_whole_name) {
    const Mesh mesh = loadText(
        "a.stl", solid(kFacet, "Tub floor") + solid("", "empty") + solid(kFacet + kFacet, "Tub left"));
    BOOST_TEST(namesOf(mesh) == (std::vector<std::string>{"Tub floor", "Tub left"}));
    BOOST_TEST(mesh.components[1].triangleCount == 2u);
}

BOOST_AUTO_TEST_CASE(coordinates_of_a_text_are_the_nearest_doubles) {
    const Mesh mesh =
        loadText("a.stl", replaced(solid(kFacet), "vertex 1 0 0", "vertex 0.3 1755.1234567890123 1e-5000"));
    BOOST_TEST((mesh.vertices[1] == Vector3(0.3, 1755.1234567890123, 0)));
}

BOOST_AUTO_TEST_CASE(a_binary_file_may_begin_like_a_text_and_end_with_a_few_bytes_more) {
    std::string file = binaryStl(tetrahedron());
    for (const std::string tail : {"", "\n", "\r\n\r\n"}) {
        BOOST_TEST(loadText("a.stl", file + tail).triangles.size() == 4u);
    }
    file.replace(0, 12, "solid facet ");
    BOOST_TEST(loadText("a.stl", file).triangles.size() == 4u);
    BOOST_TEST(loadText("a.stl", file + "end").origin.notes.size() == 1u);
    BOOST_TEST(loadText("a.stl", file + std::string(2000, '\0')).triangles.size() == 4u);
    BOOST_TEST(holds(refusalOfText("a.stl", file + std::string(50, 'x')), "50 bytes after its 4 triangles"));
    file[80] = 0;
    BOOST_TEST(holds(refusalOfText("a.stl", file), "200 bytes after its 0 triangles"));
}

BOOST_AUTO_TEST_CASE(what_is_not_whole_is_refused_by_its_line) {
    requireRefused(
        "a.stl",
        {
            {"solid a\n" + kFacet, "line 9: the file ends at facet 1, expected endsolid"},
            {"solid a\n" + kFacet.substr(0, kFacet.find("vertex 1")), "the file ends at facet 0"},
            {replaced(solid(kFacet), "endloop", "vertex 1 1 0\nendloop"),
             "line 7: facet 0 has 'vertex', expected endloop"},
            {replaced(solid(kFacet), "vertex 1 0 0\n", ""), "facet 0 has 'endloop', expected vertex"},
            {replaced(solid(kFacet), "vertex 1 0 0", "vertex 1 0"),
             "line 5: a vertex of facet 0 ends too soon"},
            {replaced(solid(kFacet), "vertex 1 0 0", "vertex 1,5 0 0"), "has '1,5', expected a number"},
            {replaced(solid(kFacet), "vertex 1 0 0", "vertex 1 0 0 5"), "has '5' after its three numbers"},
            {replaced(solid(kFacet), "vertex 1 0 0", "vertex 1e5000 0 0"), "has a vertex at (inf, 0, 0)"},
            {"\xFF\xFEs\0o\0l\0i\0d\0", "it is text in UTF-16"},
            {"# made by hand\n" + solid(kFacet), "its text begins with '#', expected solid"},
            {solid(kFacet) + "facet", "'facet' stands after facet 1, expected solid"},
            {solid(""), "it holds no triangle"},
        });
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
