#include "mesh/readable_file.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace clearway {

namespace {

/// assimp looks for the end of a PLY header for ever.
void requirePlyHeader(const std::string& file, std::istream& stream) {
    std::string magic(3, ' ');
    stream.read(&magic[0], 3);
    if (magic != "ply" && magic != "PLY") return;
    std::string line;
    while (std::getline(stream, line)) {
        if (line.compare(0, 10, "end_header") == 0) return;
    }
    refuseMeshFile(file, "its PLY header has no end_header");
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
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuseMeshFile(file, "it may not be opened");
    if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(file, error) == 0) {
        refuseMeshFile(file, "it is empty");
    }
    requirePlyHeader(file, stream);
}

}  // namespace clearway
