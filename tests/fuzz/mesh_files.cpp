// Mesh files of several formats are refused in one line that names the file, or read to a mesh that can be
// built.
#include <boost/crc.hpp>
#include <iterator>
#include <stdexcept>

#include "clearway/model.h"
#include "fuzz/bytes.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
namespace {

/// The formats that clearway reads itself, first those whose damaged files assimp reads without corrupting its own memory.
constexpr const char* kEndings[] = {"stl", "obj", "ply", "off", "gltf", "glb", "3mf", "dae"};
constexpr std::size_t kReadByAssimp = 3;
constexpr MeshReading kReadings[] = {MeshReading::kAsStored, MeshReading::kOmplAppEnvironment,
                                     MeshReading::kOmplAppRobot, MeshReading::kOmplAppPlanarRobot};
constexpr std::size_t kMostTriangles = 500;

void requireSound(const Mesh& mesh) {
    std::uint32_t next = 0;
    for (const Component& component : mesh.components) {
        require(component.firstTriangle == next && component.triangleCount > 0,
                "components follow each other");
        require(!component.name.empty(), "components have names");
        next += component.triangleCount;
    }
    require(next == mesh.triangles.size() && next > 0, "components cover the triangles");
    const Box box = boundingBox(mesh);
    require(box.min().allFinite() && box.max().allFinite(), "coordinates are finite");
    if (mesh.triangles.size() > kMostTriangles) return;  // large meshes are slow and not more likely to fail
    BuildOptions options;
    options.threads = 1;
    const Model model = Model::build(mesh, options);
    require(model.box().min() == box.min() && model.box().max() == box.max(), "the model has the mesh's box");
}

}  // namespace

void fuzzOne(std::string_view input) {
    static const TemporaryFolder folder;
    Bytes bytes(input);
    const std::size_t format = bytes.below(std::size(kEndings));
    const std::string ending = kEndings[format];
    LoadOptions options;
    options.reading = kReadings[bytes.below(format < kReadByAssimp ? 4 : 1)];
    const std::string file = folder.write("mesh." + ending, std::string(bytes.rest()));
    try {
        const Mesh mesh = loadMesh(file, options);
        require(mesh.origin.file == file, "a mesh says where it is from");
        requireSound(mesh);
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        require(message.find("cannot read mesh '" + file + "': ") == 0,
                "a refusal names the file: " + message);
        require(message.find('\n') == std::string::npos, "a refusal is one line: " + message);
    }
}

/// An archive of one file, without compression.
std::string zipOf(const std::string& name, const std::string& text) {
    boost::crc_32_type crc;
    crc.process_bytes(text.data(), text.size());
    const auto word = [](std::size_t value) { return bytesOf(std::uint32_t(value)); };
    const auto half = [](std::size_t value) { return bytesOf(std::uint16_t(value)); };
    const std::string about = half(20) + half(0) + half(0) + half(0) + half(33) + word(crc.checksum()) +
                              word(text.size()) + word(text.size()) + half(name.size()) + half(0);
    const std::string local = "PK\3\4" + about + name + text;
    const std::string central =
        "PK\1\2" + half(20) + about + half(0) + half(0) + half(0) + word(0) + word(0) + name;
    return local + central + "PK\5\6" + half(0) + half(0) + half(1) + half(1) + word(central.size()) +
           word(local.size()) + half(0);
}

std::string threeMf(const Mesh& mesh) {
    std::string vertices, triangles;
    for (const Vector3& v : mesh.vertices) {
        vertices += "<vertex x=\"" + std::to_string(v.x()) + "\" y=\"" + std::to_string(v.y()) + "\" z=\"" +
                    std::to_string(v.z()) + "\"/>";
    }
    for (const TriangleIndices& t : mesh.triangles) {
        triangles += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) +
                     "\" v3=\"" + std::to_string(t[2]) + "\"/>";
    }
    return zipOf(
        "3D/3dmodel.model",
        "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources><object "
        "id=\"1\"><mesh><vertices>" +
            vertices + "</vertices><triangles>" + triangles +
            "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>");
}

std::vector<std::string> seeds() {
    static const TemporaryFolder folder;
    std::vector<std::string> result;
    const auto add = [&](std::size_t format, char reading, const std::string& content) {
        result.push_back(char(format) + (reading + content));
    };
    const std::string glb = folder.file("seed.glb");
    saveMesh(tetrahedron(), glb);
    const std::string contents[] = {
        binaryStl(tetrahedron()),
        objText(tetrahedron(), "a"),
        plyText(tetrahedron()),
        offText(tetrahedron()),
        gltfText(tetrahedron(), "{\"mesh\":0}"),
        readText(glb),
        threeMf(tetrahedron()),
        daeText(tetrahedron(), "<node><instance_geometry url=\"#shape\"/></node>")};
    for (std::size_t format = 0; format < std::size(contents); ++format) add(format, '\0', contents[format]);
    for (std::size_t format = 0; format < kReadByAssimp; ++format) add(format, '\2', contents[format]);
    add(0, '\0', asciiStl(tetrahedron(), "a"));
    return result;
}

}  // namespace clearway::testing
