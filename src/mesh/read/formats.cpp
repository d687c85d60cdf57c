#include "mesh/read/formats.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>

#include "core/text.h"

namespace clearway {
namespace {

using namespace std::string_view_literals;

enum { kStl, kObj, kPly, kOff, kGltf, kGlb, k3mf, kDae };

constexpr MeshFormat kFormats[] = {
    {"STL", ".stl", "", readStl, false},   {"OBJ", ".obj", "", readObj, false},
    {"PLY", ".ply", "", readPly, false},   {"OFF", ".off", "", readOff, false},
    {"glTF", ".gltf", "", readGltf, true}, {"GLB", ".glb", ".vrm", readGltf, true},
    {"3MF", ".3mf", "", read3mf, true},    {"DAE", ".dae", ".collada", readDae, true}};

/// The format that the first bytes name for certain; null when they do not.
const MeshFormat* formatOfBytes(std::string_view bytes) {
    if (boost::algorithm::starts_with(bytes, "glTF"sv)) return &kFormats[kGlb];
    for (const std::string_view magic : {"ply\n"sv, "ply\r"sv, "PLY\n"sv, "PLY\r"sv}) {
        if (boost::algorithm::starts_with(bytes, magic)) return &kFormats[kPly];
    }
    if (boost::algorithm::starts_with(bytes, "PK\3\4"sv) && bytes.find("3D/") != bytes.npos)
        return &kFormats[k3mf];
    std::string_view head = bytes.substr(0, 4096);
    if (boost::algorithm::starts_with(head, kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
    head = trimmed(head);
    if (boost::algorithm::starts_with(head, "<"sv) && head.find("<COLLADA") != head.npos)
        return &kFormats[kDae];
    const std::string_view word = head.substr(0, head.find_first_of(" \t\r\n"));
    const bool isOff =
        word.size() >= 3 && word[0] != '#' && word.size() <= 8 && word.substr(word.size() - 3) == "OFF";
    return isOff ? &kFormats[kOff] : nullptr;
}

}  // namespace

const MeshFormat* meshFormatOf(const std::string& file, std::string_view bytes) {
    if (const MeshFormat* const format = formatOfBytes(bytes)) return format;
    for (const MeshFormat& format : kFormats) {
        if (boost::algorithm::iends_with(file, format.ending)) return &format;
        if (!format.otherEnding.empty() && boost::algorithm::iends_with(file, format.otherEnding))
            return &format;
    }
    return nullptr;
}

Mesh readMesh(const MeshFormat& format, const std::string& file, std::string_view bytes) {
    MeshCollector collector(file);
    format.read(bytes, collector);
    Mesh mesh = collector.take();
    mesh.origin.format = format.name;
    return mesh;
}

}  // namespace clearway
