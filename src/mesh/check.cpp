// Checks of mesh files before assimp reads them, and of meshes before anything is built from them.
#include "mesh/check.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "mesh/surface_formats.h"

namespace clearway {

namespace {

void requirePlyHeader(const std::string& file, std::istream& stream) {
    const std::string end = "end_header";
    std::string line;
    while (std::getline(stream, line)) {
        if (line.compare(0, end.size(), end) != 0) continue;
        if (line.find_first_not_of(" \t\r", end.size()) == std::string::npos) return;
    }
    refuseMeshFile(file, "its PLY header has no end_header");
}

/// Refuses counts above the file's bytes: a vertex takes at least six bytes ("0 0 0" and the line's end), a
/// face two.
void requireOffCounts(const std::string& file, std::istream& stream, std::uintmax_t bytes) {
    std::string word;
    for (const char* const things : {"vertices", "faces"}) {
        do {
            if (!(stream >> word)) return;
            if (word[0] == '#') std::getline(stream, word), word = "#";
        } while (word[0] == '#');
        if (word.find_first_not_of("0123456789") != std::string::npos) return;
        if (word.size() > 18 || std::stoull(word) > bytes) {
            refuseMeshFile(file, "its header states " + word + " " + things + ", the file has " +
                                     std::to_string(bytes) + " bytes");
        }
    }
}

/// Refuses a binary STL file that ends too soon, for which assimp says only that it is no STL.
void requireWholeStl(const std::string& file, std::istream& stream, std::uintmax_t bytes) {
    constexpr std::uintmax_t kHeader = 84, kPerTriangle = 50;
    unsigned char header[kHeader] = {};
    stream.read(reinterpret_cast<char*>(header), kHeader);
    if (std::none_of(header, header + std::min(bytes, kHeader),
                     [](unsigned char c) { return c < 9 || c > 126; }))
        return;  // a text
    const std::string isCut = "it ends after " + std::to_string(bytes) + " bytes of ";
    if (bytes < kHeader) refuseMeshFile(file, isCut + "the 84 with which a binary STL file begins");
    const std::uintmax_t triangles =
        header[80] + 256u * header[81] + 65536u * header[82] + 16777216u * std::uintmax_t(header[83]);
    const std::uintmax_t whole = kHeader + kPerTriangle * triangles;
    if (bytes >= whole) return;
    refuseMeshFile(
        file, isCut + std::to_string(whole) + ", which its " + std::to_string(triangles) + " triangles take");
}

/// assimp searches for the end of a PLY header forever, and allocates as many vertices and faces as an OFF
/// header states.
void requireSoundHeader(const std::string& file, std::istream& stream, std::uintmax_t bytes) {
    std::string start(10, ' ');
    stream.read(&start[0], 10);
    stream.clear();
    const std::string word = start.substr(0, start.find_first_of(" \t\r\n"));
    const std::string magic = word.substr(0, 3),
                      ending = word.substr(std::max<std::size_t>(word.size(), 3) - 3);
    stream.seekg(static_cast<std::streamoff>(word.size()));
    if (magic == "ply" || magic == "PLY") requirePlyHeader(file, stream);
    if (ending == "OFF") requireOffCounts(file, stream, bytes);
}

}  // namespace

void refuseMeshFile(const std::string& file, std::string reason) {
    for (char& character : reason) {
        if (character == '\n' || character == '\r') character = ' ';
    }
    while (!reason.empty() && (reason.back() == ' ' || reason.back() == '.')) reason.pop_back();
    if (reason.empty()) reason = "the reader gives no reason";
    throw std::runtime_error(
        "cannot read mesh '" + file + "': " + reason +
        ", expected a mesh file that assimp reads (stl, obj, ply, dae, gltf, glb, off, ...)");
}

void requireReadableMeshFile(const std::string& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) refuseMeshFile(file, "there is no such file");
    if (std::filesystem::is_directory(status)) refuseMeshFile(file, "it is a folder");
    // Opening a pipe may never end, and assimp recognises formats by the file's ending and reads the file
    // repeatedly.
    if (!std::filesystem::is_regular_file(status))
        refuseMeshFile(file, "it is a pipe or a device, not a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuseMeshFile(file, "it may not be opened");
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (bytes == 0) refuseMeshFile(file, "it is empty");
    const std::string format = surfaceFormat(stream);
    if (!format.empty()) {
        throw std::runtime_error(
            "cannot read mesh '" + file + "': it is " + format +
            ", which holds surfaces, not triangles, expected a mesh: export STL, OBJ, 3MF or "
            "glTF from the CAD program");
    }
    stream.clear();
    stream.seekg(0);
    requireSoundHeader(file, stream, bytes);
    stream.clear();
    stream.seekg(0);
    if (boost::iends_with(file, ".stl")) requireWholeStl(file, stream, bytes);
}

namespace {

std::string inFile(const Mesh& mesh) {
    return mesh.origin.file.empty() ? std::string() : " in '" + mesh.origin.file + "'";
}

void requireComponents(const Mesh& mesh) {
    if (mesh.components.empty()) return;
    std::uint64_t expectedFirst = 0;
    for (std::size_t i = 0; i < mesh.components.size(); ++i) {
        const Component& component = mesh.components[i];
        if (component.firstTriangle != expectedFirst) {
            std::ostringstream message;
            message << "component " << i << " ('" << component.name << "')" << inFile(mesh)
                    << " begins at triangle " << component.firstTriangle << ", expected " << expectedFirst
                    << ", the end of the component before";
            throw std::invalid_argument(message.str());
        }
        expectedFirst += component.triangleCount;
    }
    if (expectedFirst != mesh.triangles.size()) {
        std::ostringstream message;
        message << "the components" << inFile(mesh) << " hold " << expectedFirst << " triangles, expected "
                << mesh.triangles.size() << ", all of the mesh";
        throw std::invalid_argument(message.str());
    }
}

[[noreturn]] void refuseIndex(const Mesh& mesh, std::size_t triangle, std::uint32_t vertex) {
    std::ostringstream message;
    message << nameOfTriangle(mesh, triangle) << " refers to vertex " << vertex << ", expected one below "
            << mesh.vertices.size();
    throw std::invalid_argument(message.str());
}

[[noreturn]] void refuseVertex(const Mesh& mesh, std::size_t triangle, const Vector3& vertex) {
    std::ostringstream message;
    message << nameOfTriangle(mesh, triangle) << " has a vertex at (" << vertex.x() << ", " << vertex.y()
            << ", " << vertex.z() << "), expected finite coordinates";
    throw std::invalid_argument(message.str());
}

}  // namespace

std::string nameOfTriangle(const Mesh& mesh, std::size_t triangle) {
    std::string name = "triangle " + std::to_string(triangle);
    if (!mesh.components.empty()) {
        name += " of component '" + mesh.components[componentOf(mesh, triangle)].name + "'";
    }
    return name + inFile(mesh);
}

void requireSoundMesh(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("the mesh" + inFile(mesh) + " holds 0 triangles, expected at least 1");
    }
    requireComponents(mesh);
    for (std::size_t id = 0; id < mesh.triangles.size(); ++id) {
        for (const std::uint32_t vertex : mesh.triangles[id]) {
            if (vertex >= mesh.vertices.size()) refuseIndex(mesh, id, vertex);
            if (!mesh.vertices[vertex].allFinite()) refuseVertex(mesh, id, mesh.vertices[vertex]);
        }
    }
}

}  // namespace clearway
