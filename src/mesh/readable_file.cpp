#include "mesh/readable_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>

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

/// A vertex takes at least six bytes ("0 0 0", then a line's end), a face two.
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

/// assimp looks for the end of a PLY header for ever, and makes room for as many vertices and faces as an OFF
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
    // Opening a pipe may never end, and assimp tells formats by the file's ending and reads more than once.
    if (!std::filesystem::is_regular_file(status))
        refuseMeshFile(file, "it is a pipe or a device, not a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuseMeshFile(file, "it may not be opened");
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (bytes == 0) refuseMeshFile(file, "it is empty");
    requireSoundHeader(file, stream, bytes);
}

}  // namespace clearway
