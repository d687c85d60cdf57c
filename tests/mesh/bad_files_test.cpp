#include <sys/stat.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(bad_files_test)

using namespace testing;

constexpr MeshReading kReadings[] = {MeshReading::kAsStored, MeshReading::kOmplAppEnvironment,
                                     MeshReading::kOmplAppRobot, MeshReading::kOmplAppPlanarRobot};

std::string refusalOf(const std::string& file, MeshReading reading = MeshReading::kAsStored) {
    LoadOptions options;
    options.reading = reading;
    try {
        loadMesh(file, options);
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        BOOST_TEST(message.find("cannot read mesh '" + file + "': ") == 0u, message);
        BOOST_TEST(message.size() > file.size() + 30, message);  // with a reason
        BOOST_TEST(message.find('\n') == std::string::npos, message);
        BOOST_TEST_MESSAGE(message);
        return message;
    }
    return "accepted";
}

BOOST_AUTO_TEST_CASE(a_missing_file_a_folder_and_an_empty_file_are_refused) {
    const TemporaryFolder folder;
    BOOST_TEST(holds(refusalOf(folder.file("none.stl")), "there is no such file"));
    BOOST_TEST(holds(refusalOf(""), "there is no such file"));
    std::filesystem::create_directory(folder.file("folder.stl"));
    BOOST_TEST(holds(refusalOf(folder.file("folder.stl")), "it is a folder"));
    BOOST_TEST_REQUIRE(mkfifo(folder.file("pipe.stl").c_str(), 0600) == 0);
    BOOST_TEST(holds(refusalOf(folder.file("pipe.stl")), "it is a pipe or a device"));
    for (const char* const ending : {"stl", "obj", "ply", "off", "dae", "gltf", "glb", "txt"}) {
        BOOST_TEST(holds(refusalOf(folder.write(std::string("empty.") + ending, "")), "it is empty"), ending);
    }
}

BOOST_AUTO_TEST_CASE(text_under_the_name_of_a_mesh_is_refused) {
    const TemporaryFolder folder;
    for (const char* const ending : {"stl", "obj", "ply", "off", "dae", "gltf", "glb", "txt", "3ds", "fbx"}) {
        BOOST_TEST_CONTEXT(ending) {
            for (const char* const text :
                 {"These are minutes\nof a meeting.\n", "solid advice, but no mesh\n"}) {
                const std::string file = folder.write(std::string("minutes.") + ending, text);
                for (const MeshReading reading : kReadings) {
                    BOOST_TEST(holds(refusalOf(file, reading), "cannot read mesh"));
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_truncated_file_is_refused) {
    const TemporaryFolder folder;
    const std::string stl = binaryStl(tetrahedron());
    BOOST_TEST(holds(refusalOf(folder.write("cut.stl", stl.substr(0, stl.size() - 30))),
                     "it ends after 254 bytes of 284, which its 4 triangles take"));
    BOOST_TEST(
        holds(refusalOf(folder.write("cut.stl", stl.substr(0, 82))), "it ends after 82 bytes of the 84"));
    const std::string ply = plyText(tetrahedron());
    for (std::size_t size = 1; size < ply.find("end_header") + 10; ++size) {
        BOOST_TEST(refusalOf(folder.write("cut.ply", ply.substr(0, size))) != "accepted");
    }
    BOOST_TEST(refusalOf(folder.write("cut.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n")) != "accepted");
    BOOST_TEST(refusalOf(folder.write("cut.gltf", gltfText(tetrahedron(), "{\"mesh\":0}").substr(0, 400))) !=
               "accepted");
    const std::string dae = daeText(tetrahedron(), "<node/>");
    BOOST_TEST(refusalOf(folder.write("cut.dae", dae.substr(0, dae.size() / 2))) != "accepted");
}

BOOST_AUTO_TEST_CASE(headers_that_the_reader_would_never_end_on_are_refused) {
    const TemporaryFolder folder;
    const std::string ply = plyText(tetrahedron());
    for (const char* const end : {"end_header9\n", "end_header\x10", "end_headers\n"}) {
        const std::string file = folder.write("a.ply", replaced(ply, "end_header\n", end));
        BOOST_TEST(holds(refusalOf(file), "end_header"));
    }
    const std::string points = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    BOOST_TEST(loadMesh(folder.write("a.off", "OFF\n# 9\n3 1 0" + points)).triangles.size() == 1u);
    for (const char* const start : {"OFF\n", "COFF\r\n", "OFF # a comment, 4 1\n# 4 1\n"}) {
        for (const char* const counts : {"353535235358 1 0", "3 99999999999999999999 0", "3 1000 0"}) {
            BOOST_TEST(holds(refusalOf(folder.write("a.off", start + (counts + points))), "line "),
                       start << counts);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_node_that_the_reader_leaves_out_is_refused_or_read) {
    // A sound file, but assimp 5.2 gives its root one child for each group and makes only one of these
    // children.
    const TemporaryFolder folder;
    const std::string group = "0.5 0.5 0.5 0 0 0 0 1 0 1 0 0\n0.1 0 0 0 0 3 0 1 3 1 0 3\n";
    const std::string file = folder.write("a.raw", "one\n" + group + "\n\ntwo\n" + group);
    try {
        BOOST_TEST(loadMesh(file).triangles.size() == 4u);
    } catch (const std::runtime_error& error) {
        BOOST_TEST(holds(error.what(), "the reader left out child 1 of node"), error.what());
    }
}

BOOST_AUTO_TEST_CASE(a_file_without_triangles_is_refused) {
    const TemporaryFolder folder;
    const std::string none = "it holds no triangle";
    for (const MeshReading reading : kReadings) {
        BOOST_TEST(
            holds(refusalOf(folder.write("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\np 1\n"), reading), none));
        BOOST_TEST(holds(refusalOf(folder.write("points.obj", "v 0 0 0\nv 1 0 0\n"), reading), none));
        BOOST_TEST(
            holds(refusalOf(folder.write("empty.dae", daeText(tetrahedron(), "<node name=\"a\"/>")), reading),
                  none));
        BOOST_TEST(
            holds(refusalOf(folder.write("empty.gltf", gltfText(tetrahedron(), "{\"name\":\"a\"}")), reading),
                  none));
    }
}

BOOST_AUTO_TEST_CASE(an_index_out_of_range_is_refused) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.ply", replaced(plyText(tetrahedron()), "3 2 3 0", "3 2 9 0"));
    for (const MeshReading reading : kReadings) {
        BOOST_TEST(holds(refusalOf(file, reading), "face 3 refers to vertex 9, expected one below 4"));
    }
}

BOOST_AUTO_TEST_CASE(a_vertex_that_is_not_finite_is_refused_naming_the_first_such_triangle) {
    const TemporaryFolder folder;
    for (const char* const value : {"nan", "inf", "-inf", "1e309"}) {
        const std::string text = replaced(objText(tetrahedron(), "bracket"), "3.062500", value);
        for (const MeshReading reading : kReadings) {
            const std::string message = refusalOf(folder.write("bad.obj", text), reading);
            BOOST_TEST(holds(message, "triangle 1", "'bracket'", "(6, ", "finite coordinates"), message);
        }
    }
}

BOOST_AUTO_TEST_CASE(joining_vertices_never_hides_one_that_is_not_finite) {
    // assimp treats a NaN as equal to any vertex that its hash table compares it with, which depends on the
    // bits.
    const TemporaryFolder folder;
    for (int i = 0; i < 40; ++i) {
        const std::string text = replaced(objText(tetrahedron(), "a"), "3.062500", "nan");
        const std::string file = folder.write("bad.obj", replaced(text, "-1.250000", std::to_string(i)));
        BOOST_TEST(holds(refusalOf(file, MeshReading::kOmplAppEnvironment), "(6, nan, -8)"));
    }
}

BOOST_AUTO_TEST_CASE(an_unused_vertex_that_is_not_finite_does_no_harm) {
    const TemporaryFolder folder;
    const std::string text = replaced(plyText(tetrahedron()), "element vertex 4", "element vertex 5");
    const std::string file = folder.write("a.ply", replaced(text, "3 0 1 2\n", "nan 0 0\n3 0 1 2\n"));
    for (const MeshReading reading : kReadings) {
        LoadOptions options;
        options.reading = reading;
        const Mesh mesh = loadMesh(file, options);
        BOOST_TEST(mesh.triangles.size() == 4u);
        BOOST_TEST(boundingBox(mesh).sizes().allFinite());
    }
}

BOOST_AUTO_TEST_CASE(coordinates_that_the_scale_makes_infinite_are_refused) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.obj", objText(tetrahedron(), "bracket"));
    LoadOptions options;
    options.scale = 1e308;
    BOOST_CHECK_THROW(loadMesh(file, options), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(files_that_hold_surfaces_are_named_whatever_their_ending) {
    using namespace std::string_literals;
    const std::string igesLine = "exported by a CAD program" + std::string(47, ' ') + "S      1\n";
    const std::pair<std::string, const char*> cases[] = {
        {"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n", "a STEP file"},
        {"\n ISO-10303-21;\n", "a STEP file"},
        {"\xEF\xBB\xBFISO-10303-21;\n", "a STEP file"},
        {"700 0 1 0\n@8 unknown 8 ACIS 7.0 24\n", "an ACIS file"},
        {"20800 0 1 0\r\n16 Autodesk AutoCAD 19 ASM 208.0.4.7009 NT 24 Mon Jan 1\r\n", "an ACIS file"},
        {igesLine, "an IGES file"},
        {"Version 9.5 JT  DM 7.3.1.3" + std::string(60, ' '), "a JT file"},
        {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s + std::string(504, '\0'), "SolidWorks"},
        {"**ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefgh", "a Parasolid file"},
        {"V5_CFV2\0\0"s, "a CATIA file"},
        {"#UGC:2 PART 1000", "a Creo file"},
        {"3D Geometry File Format        4", "a Rhino file"},
        {"PK\3\4\x14\0\0\0\0\0"s + std::string(20, '\0') + "Document.xml", "a FreeCAD file"},
    };
    const TemporaryFolder folder;
    for (const auto& [text, name] : cases) {
        for (const char* file : {"a.stl", "a.step", "a.obj"}) {
            const std::string refusal = refusalOf(folder.write(file, text));
            BOOST_TEST(holds(refusal, "it is ", name, "holds surfaces", "expected a mesh"), refusal);
        }
    }
    const std::string zip = refusalOf(folder.write("zip.stl", "PK\3\4"));
    BOOST_TEST(holds(zip, "cannot read mesh"), zip);
    BOOST_TEST(!holds(zip, "holds surfaces"), zip);
    const std::string ifc =
        folder.write("a.ifc", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\n");
    BOOST_TEST(!holds(refusalOf(ifc), "holds surfaces"));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
