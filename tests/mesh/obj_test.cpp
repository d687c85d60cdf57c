// OBJ files as programs write them, sound ones and damaged ones.
#include <boost/test/unit_test.hpp>

#include "mesh/mesh_files.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(obj_test)

using namespace testing;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

BOOST_AUTO_TEST_CASE(faces_as_programs_write_them_are_read) {
    for (const std::string& text : std::vector<std::string>{
             kSquare + "f 1 2 3 4\n", kSquare + "f 1/1 2/2 3/3 4/4\n", kSquare + "f 1//1 2//1 3//1 4//1\n",
             kSquare + "f 1/1/1 2/2/1 3/3/1 4/4/1", kSquare + "f -4 -3 -2 -1\n", "f 1 2 3 4\n" + kSquare,
             kSquare + "f 1 2 \\\n3 4\n", kSquare + "f 1 2\\\r\n 3 4\r\n", kSquare + "  f\t1 2 3 4  \r\n",
             kSquare + "fo 1 2 3 4\n", kSquare + "f 1 2 3 4 # a square\n\x1A",
             "#OFF\n" + kSquare + "f 1 2 3 4\n", "\xEF\xBB\xBF" + kSquare + "f 1 2 3 4\n",
             "# a comment \\\n" + kSquare + "f 1 2 3 4\n",
             "mtllib C:\\folder\\\n" + kSquare + "usemtl a b\ns off\nvt 0 0\nvn 0 0 1\nf 1 2 3 4\n",
             "v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0 1 0.5 0.5 0.5\nv 0 1 0\nf 1 2 3 4\n",
             "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"}) {
        const Mesh mesh = loadText("a.obj", text);
        BOOST_TEST(mesh.triangles.size() == 2u, text);
        BOOST_TEST(areaOf(mesh) == 1, text);
        BOOST_TEST(mesh.vertices.size() == 4u);
    }
}

BOOST_AUTO_TEST_CASE(groups_and_objects_keep_their_whole_names) {
    const std::string face = "f 1 2 3\n";
    const Mesh mesh = loadText("a.obj", kSquare + face + "g Tub floor\n" + face + "g Tub left\nusemtl red\n" +
                                            face + "usemtl blue\n" + face + "o wall\ng\n" + face +
                                            "o wall\n" + face + "g empty\n");
    BOOST_TEST(namesOf(mesh) == (std::vector<std::string>{"a", "Tub floor", "Tub left", "a#2", "wall"}));
    BOOST_TEST(mesh.components[2].triangleCount == 2u);
}

BOOST_AUTO_TEST_CASE(coordinates_are_the_nearest_doubles) {
    const Mesh mesh = loadText("a.obj", "v 0.3 1755.1234567890123 -1e-7\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    BOOST_TEST((mesh.vertices[0] == Vector3(0.3, 1755.1234567890123, -1e-7)));
}

BOOST_AUTO_TEST_CASE(what_is_not_read_is_refused_by_its_line) {
    requireRefused(
        "a.obj", {
                     {kSquare + "f 1\n", "line 5: face 1 has 1 corners, expected at least 3"},
                     {kSquare + "f 1 2\n", "face 1 has 2 corners"},
                     {kSquare + "f 1 2 3\nf 1 2 5\n", "line 6: face 2 refers to vertex 5, expected 1 to 4"},
                     {kSquare + "f 0 1 2\n", "refers to vertex 0"},
                     {kSquare + "f -5 1 2\n", "refers to vertex -5"},
                     {kSquare + "f 1 2 x\n", "face 1 has 'x', expected a whole number"},
                     {kSquare + "f 1/1/1/1 2 3\n", "a corner of more than three numbers"},
                     {kSquare + "v 1 abc 2\nf 1 2 3\n", "line 5: vertex 5 has 'abc', expected a number"},
                     {kSquare + "v 1 2\nf 1 2 3\n", "vertex 5 ends too soon"},
                     {kSquare + "v 1 2 3 0.5\nf 1 2 3\n", "vertex 5 has 4 numbers, the last of which is 0.5"},
                     {kSquare + "call other.obj\nf 1 2 3\n", "'call' is not read"},
                     {kSquare + "surf 0 1 0 1 1 2 3 4\nf 1 2 3\n", "'surf' is not read"},
                     {kSquare + "f 1 2 3\nface 1 2 4\n", "line 6: 'face' is no statement of an OBJ file"},
                 });
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
