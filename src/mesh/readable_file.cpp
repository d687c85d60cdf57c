#include "mesh/readable_file.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace clearway {

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
    if (!std::ifstream(file, std::ios::binary)) refuseMeshFile(file, "it may not be opened");
    if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(file, error) == 0) {
        refuseMeshFile(file, "it is empty");
    }
}

}  // namespace clearway
