// Source: Khronos Group, glTF 2.0 Specification: a JSON chunk that describes the views of one binary chunk.
#include "mesh/glb.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace clearway {

namespace {

constexpr int kFloat = 5126;  // glTF's component types
constexpr int kUnsigned = 5125;
constexpr int kVertexBuffer = 34962;  // and targets of buffer views
constexpr int kIndexBuffer = 34963;

std::string quoted(const std::string& text) {
    std::string json = "\"";
    for (const char character : text) {
        if (character == '"' || character == '\\') {
            json += '\\';
            json += character;
        } else if (static_cast<unsigned char>(character) < 0x20) {
            char escape[7];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(character));
            json += escape;
        } else {
            json += character;
        }
    }
    return json + '"';
}

std::uint64_t vertexBytes(const SavePart& part) {
    return part.vertices.size() * sizeof(part.vertices[0]);
}

std::uint64_t indexBytes(const SavePart& part) {
    return part.triangles.size() * sizeof(part.triangles[0]);
}

std::string list(const std::array<float, 3>& values) {
    std::ostringstream json;
    json.precision(std::numeric_limits<float>::max_digits10);
    json << '[' << values[0] << ',' << values[1] << ',' << values[2] << ']';
    return json.str();
}

/// The accessor of a part's positions, whose bounds the format asks for.
std::string positionAccessor(const SavePart& part, std::size_t view) {
    std::array<float, 3> least = part.vertices[0];
    std::array<float, 3> most = part.vertices[0];
    for (const std::array<float, 3>& vertex : part.vertices) {
        for (int i = 0; i < 3; ++i) {
            least[i] = std::min(least[i], vertex[i]);
            most[i] = std::max(most[i], vertex[i]);
        }
    }
    std::ostringstream json;
    json << "{\"bufferView\":" << view << ",\"componentType\":" << kFloat
         << ",\"count\":" << part.vertices.size() << ",\"type\":\"VEC3\",\"min\":" << list(least)
         << ",\"max\":" << list(most) << '}';
    return json.str();
}

struct Lists {
    std::ostringstream roots, nodes, meshes, accessors, views;
};

void describe(const SavePart& part, std::size_t number, std::uint64_t offset, Lists& lists) {
    const char* const comma = number == 0 ? "" : ",";
    const std::size_t view = 2 * number;  // positions, then indices; accessors are numbered like the views
    lists.roots << comma << number;
    lists.nodes << comma << "{\"name\":" << quoted(part.name) << ",\"mesh\":" << number << '}';
    lists.meshes << comma << "{\"name\":" << quoted(part.name)
                 << ",\"primitives\":[{\"attributes\":{\"POSITION\":" << view << "},\"indices\":" << view + 1
                 << "}]}";
    lists.accessors << comma << positionAccessor(part, view) << ",{\"bufferView\":" << view + 1
                    << ",\"componentType\":" << kUnsigned << ",\"count\":" << 3 * part.triangles.size()
                    << ",\"type\":\"SCALAR\"}";
    lists.views << comma << "{\"buffer\":0,\"byteOffset\":" << offset
                << ",\"byteLength\":" << vertexBytes(part) << ",\"target\":" << kVertexBuffer
                << "},{\"buffer\":0,\"byteOffset\":" << offset + vertexBytes(part)
                << ",\"byteLength\":" << indexBytes(part) << ",\"target\":" << kIndexBuffer << '}';
}

/// Padded with spaces to whole words of 4 bytes.
std::string jsonOf(const std::vector<SavePart>& parts) {
    Lists lists;
    std::uint64_t offset = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        describe(parts[i], i, offset, lists);
        offset += vertexBytes(parts[i]) + indexBytes(parts[i]);
    }
    std::string json =
        "{\"asset\":{\"version\":\"2.0\",\"generator\":\"clearway\"},\"scene\":0,\"scenes\":[{\"nodes\":[" +
        lists.roots.str() + "]}],\"nodes\":[" + lists.nodes.str() + "],\"meshes\":[" + lists.meshes.str() +
        "],\"accessors\":[" + lists.accessors.str() + "],\"bufferViews\":[" + lists.views.str() +
        "],\"buffers\":[{\"byteLength\":" + std::to_string(offset) + "}]}";
    json.append((4 - json.size() % 4) % 4, ' ');
    return json;
}

void writeWord(std::ostream& stream, std::uint64_t word) {
    const char bytes[4] = {static_cast<char>(word), static_cast<char>(word >> 8),
                           static_cast<char>(word >> 16), static_cast<char>(word >> 24)};
    stream.write(bytes, sizeof bytes);
}

}  // namespace

void writeGlb(const std::vector<SavePart>& parts, std::ostream& stream) {
    const std::string json = jsonOf(parts);
    std::uint64_t binaryBytes = 0;
    for (const SavePart& part : parts) binaryBytes += vertexBytes(part) + indexBytes(part);
    const std::uint64_t bytes = 12 + 8 + json.size() + 8 + binaryBytes;
    if (bytes > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("the mesh takes " + std::to_string(bytes) +
                                    " bytes, expected at most 2^32 - 1 for a .glb file");
    }
    writeWord(stream, 0x46546c67);  // "glTF"
    writeWord(stream, 2);
    writeWord(stream, bytes);
    writeWord(stream, json.size());
    writeWord(stream, 0x4e4f534a);  // "JSON"
    stream.write(json.data(), static_cast<std::streamsize>(json.size()));
    writeWord(stream, binaryBytes);
    writeWord(stream, 0x004e4942);  // "BIN"
    for (const SavePart& part : parts) {
        stream.write(reinterpret_cast<const char*>(part.vertices.data()), vertexBytes(part));
        stream.write(reinterpret_cast<const char*>(part.triangles.data()), indexBytes(part));
    }
}

}  // namespace clearway
