// PLY files as programs write them, sound ones and damaged ones.
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "mesh/mesh_files.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(ply_test)

using namespace testing;

const std::string kVertices = "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kSquare = "0.3 0 0\n1.3 0 0\n1.3 1 0\n0.3 1 0\n";

std::string ply(const std::string& elements, const std::string& data, const std::string& format = "ascii") {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + data;
}

/// A value in either order of bytes.
template <class Value>
std::string ordered(Value value, bool isBig) {
    std::string bytes = bytesOf(value);
    if (isBig) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

BOOST_AUTO_TEST_CASE(texts_are_read_in_double_and_other_elements_passed_over) {
    const std::string camera =
        "element camera 1\nproperty float view_px\nproperty float view_py\nproperty list uchar int ids\n";
    const std::string more =
        "element face 1\nproperty uchar red\nproperty list uchar float texcoord\nproperty list uchar int "
        "vertex_index\n";
    for (const std::string& text : std::vector<std::string>{
             ply(kVertices + kFaces, kSquare + "4 0 1 2 3\n"),
             ply(kFaces + kVertices, "4 0 1 2 3\n" + kSquare),
             ply(camera + kVertices + kFaces, "7 7 2 1 1\n" + kSquare + "4 0 1 2 3"),
             ply(kVertices + camera + more, kSquare + "\n7 7 0\n\n9 2 0.5 0.5 4 0 1 2 3\n"),
             ply("comment made by hand\n" + kVertices + "obj_info 1\n" + kFaces, kSquare + "4 0 1 2 3\n")}) {
        const Mesh mesh = loadText("a.ply", text);
        BOOST_TEST(mesh.triangles.size() == 2u, text);
        BOOST_TEST(areaOf(mesh) == 1, boost::test_tools::tolerance(1e-15));
        BOOST_TEST((mesh.vertices[0] == Vector3(0.3, 0, 0)));
    }
}

BOOST_AUTO_TEST_CASE(binary_data_in_both_orders_are_read_whatever_their_first_byte) {
    for (const bool isBig : {false, true}) {
        // 10 is the byte of "\n".
        std::string data = ordered(std::uint16_t(isBig ? 0x0A00 : 0x000A), isBig);
        for (const double coordinate : {0.3, 0., 0., 1.3, 0., 0., 1.3, 1., 0., 0.3, 1., 0.})
            data += ordered(coordinate, isBig);
        data += std::string(1, 4);
        for (const std::int32_t corner : {0, 1, 2, 3}) data += ordered(corner, isBig);
        const std::string format = isBig ? "binary_big_endian" : "binary_little_endian";
        const std::string text =
            ply("element mark 1\nproperty ushort value\n" + kVertices + kFaces, data, format);
        BOOST_TEST(loadText("a.ply", text).triangles.size() == 2u);
        BOOST_TEST((loadText("a.ply", text + "\n").vertices[2] == Vector3(1.3, 1, 0)));
        BOOST_TEST(holds(refusalOfText("a.ply", text.substr(0, text.size() - 1)), "the file ends at face 0"));
        BOOST_TEST(holds(refusalOfText("a.ply", text + std::string(13, 'x')), "13 bytes after the elements"));
    }
}

BOOST_AUTO_TEST_CASE(strips_are_triangles_whose_sides_all_face_the_same_way) {
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    const std::string vertices = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
    const Mesh mesh = loadText(
        "a.ply", ply(vertices + strips, "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 0 1 2\n"));
    BOOST_TEST_REQUIRE(mesh.triangles.size() == 4u);
    for (const TriangleIndices& t : mesh.triangles) {
        const Vector3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]],
                      v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
        BOOST_TEST(u.cross(v).z() == 1);
    }
}

BOOST_AUTO_TEST_CASE(what_is_not_whole_is_refused) {
    const std::string bad = "element face 1\nproperty list uchar int corners\n";
    requireRefused(
        "a.ply",
        {
            {ply(kVertices + kFaces, kSquare), "the file ends at face 0"},
            {ply(kVertices + kFaces, kSquare + "4 0 1 2\n"), "face 0 ends too soon"},
            {ply(kVertices + kFaces, kSquare + "4 0 1 2 4\n"),
             "face 0 refers to vertex 4, expected one below 4"},
            {ply(kVertices + kFaces, kSquare + "4 0 1 2 -1\n"), "face 0 refers to vertex -1"},
            {ply(kVertices + kFaces, kSquare + "0\n"), "face 0 has no corner"},
            {ply(kVertices + kFaces, kSquare + "4 0 1 2 3\n3 0 1 2\n"),
             "a row follows those that the header states"},
            {ply(kVertices + kFaces, kSquare + "4 0 1 2 3 7\n"), "face 0 has '7' after its properties"},
            {ply(kVertices + bad, kSquare + "4 0 1 2 3\n"), "lacks the list vertex_indices"},
            {ply("element vertex 1\nproperty float x\n" + kFaces, "0\n4 0 0 0 0\n"),
             "lack one of the properties x, y and z"},
            {ply("element vertex 400000000\nproperty float x\nproperty float y\nproperty float z\n" + kFaces,
                 kSquare),
             "element 'vertex' has the count 400000000, and "},
            {ply(kVertices + "element range_grid 1\nproperty list uchar int vertex_indices\n",
                 kSquare + "1 0\n"),
             "range_grid"},
            {ply(kVertices + "element face 0\nproperty list uchar int vertex_indices\n", kSquare),
             "it holds no triangle"},
            {ply(kVertices + kFaces, kSquare + "4 0 1 2 3\n", "binary"), "the format is 'binary'"},
            {ply(kVertices + kFaces + "element triangle 1\nproperty list uchar int vertex_indices\n",
                 kSquare + "4 0 1 2 3\n3 0 1 2\n"),
             "element 'triangle' has a list of vertices"},
            {ply(kVertices + kFaces + kFaces, kSquare + "4 0 1 2 3\n4 0 1 2 3\n"),
             "it has two elements 'face'"},
            {"ply\nformat ascii 1.0\nelement vertex 4\nproperty half x\nend_header\n",
             "a property has the type 'half'"},
            {"ply\n" + kVertices + kFaces + "end_header\n" + kSquare, "the header has no format"},
        });
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
