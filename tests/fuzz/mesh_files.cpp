// Mesh files of several formats are refused in one line that names the file, or read to a mesh that can be
// built.
#include <stdexcept>

#include "clearway/model.h"
#include "fuzz/bytes.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
namespace {

/// The formats whose damaged files assimp reads without corrupting its own memory.
constexpr const char* kEndings[] = {"stl", "obj", "ply"};
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
    const std::string ending = kEndings[bytes.below(3)];
    LoadOptions options;
    options.reading = kReadings[bytes.below(4)];
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

std::vector<std::string> seeds() {
    std::vector<std::string> result;
    const std::string texts[] = {binaryStl(tetrahedron()), objText(tetrahedron(), "a"),
                                 plyText(tetrahedron())};
    for (int format = 0; format < 3; ++format) {
        for (const char reading : {'\0', '\2'}) result.push_back(char(format) + (reading + texts[format]));
    }
    result.push_back(std::string(2, '\0') + asciiStl(tetrahedron(), "a"));
    return result;
}

}  // namespace clearway::testing
