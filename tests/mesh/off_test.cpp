// OFF files as programs write them, sound ones and damaged ones.
#include <boost/test/unit_test.hpp>

#include "mesh/mesh_files.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(off_test)

using namespace testing;

const std::string kSquare = "0.3 0 0\n1.3 0 0\n1.3 1 0\n0.3 1 0\n";

BOOST_AUTO_TEST_CASE(files_as_programs_write_them_are_read) {
    for (const std::string& text : std::vector<std::string>{
             "OFF\n4 1 0\n" + kSquare + "4 0 1 2 3\n", "OFF 4 1 0\n" + kSquare + "4 0 1 2 3",
             "OFF\n4 1\n" + kSquare + "4 0 1 2 3\n", "4 1 4\n" + kSquare + "4 0 1 2 3\n",
             "OFF # 9 9 9\n# 9\n4 1 0 # counts\n" + kSquare + "# between\n\n4 0 1 2 3 # the face\n# end\n",
             "OFF\n4 1 0\n" + kSquare + "4 0 1 2 3 255 0 0\n",
             "OFF\n4 1 0\n" + kSquare + "4 0 1 2 3  0.5 0.5 0.5 1\n",
             std::string("COFF\n4 1 0\n0.3 0 0 1 0 0 1\n1.3 0 0 1 0 0 1\n1.3 1 0 1 0 0 1\n0.3 1 0 1 0 0 1\n4 "
                         "0 1 2 3\n"),
             std::string(
                 "NOFF\n4 1 0\n0.3 0 0 0 0 1\n1.3 0 0 0 0 1\n1.3 1 0 0 0 1\n0.3 1 0 0 0 1\n4 0 1 2 3\n"),
             std::string(
                 "OFF\r\n4 1 0\r\n0.3 0 0 255 0 0\r\n1.3 0 0 255 0 0\r\n1.3 1 0 255 0 0\r\n0.3 1 0 255 "
                 "0 0\r\n4 0 1 2 3\r\n")}) {
        const Mesh mesh = loadText("a.off", text);
        BOOST_TEST(mesh.triangles.size() == 2u, text);
        BOOST_TEST((mesh.vertices[0] == Vector3(0.3, 0, 0)));
        BOOST_TEST(areaOf(mesh) == 1, boost::test_tools::tolerance(1e-15));
    }
}

BOOST_AUTO_TEST_CASE(what_is_not_whole_is_refused_by_its_line) {
    requireRefused(
        "a.off",
        {
            {"OFF\n4 2 0\n" + kSquare + "4 0 1 2 3\n", "the file ends before face 1, expected the 2 faces"},
            {"OFF\n4 1 0\n0 0 0\n1 0 0\n", "the file ends before vertex 2"},
            {"OFF\n4 1 0\n" + kSquare + "4 0 1 2 3\n3 0 1 2\n", "line 8: '3' stands after the 1 faces"},
            {"OFF\n4 1 0\n" + kSquare + "4 0 1 2 4\n", "face 0 refers to vertex 4, expected one below 4"},
            {"OFF\n4 1 0\n" + kSquare + "0\n", "face 0 has 0 corners"},
            {"OFF\n4 1 0\n" + kSquare + "5 0 1 2 3\n", "face 0 ends too soon"},
            {"OFF\n4 1 0\n0 0\n0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "line 3: vertex 0 ends too soon"},
            {"OFF\n4 1 0\n0 0 0 1 0 0 1 1 0 0 1 0\n4 0 1 2 3\n", "vertex 0 has 12 numbers"},
            {"OFF\n4 1 0\n" + kSquare + "4 0 1 2 x\n", "face 0 has 'x', expected a whole number"},
            {"OFF BINARY\n4 1 0\n", "the header has 'BINARY' after 'OFF'"},
            {"4OFF\n4 1 0\n", "the header is '4OFF', expected OFF"},
            {"OFF\n400000 1 0\n" + kSquare, "the header states 400000 vertices, and "},
        });
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
