// Small mesh files, written by hand in the formats that matter. All hold one tetrahedron of exact floats.
#pragma once

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "clearway/mesh.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {

/// Loads a file with this name and content.
inline Mesh loadText(const std::string& name, const std::string& content, const LoadOptions& options = {}) {
    const TemporaryFolder folder;
    return loadMesh(folder.write(name, content), options);
}

/// Why the file is refused, without its name; "accepted" when it is not.
inline std::string refusalOfText(const std::string& name, const std::string& content) {
    const TemporaryFolder folder;
    const std::string file = folder.write(name, content), begin = "cannot read mesh '" + file + "': ";
    try {
        loadMesh(file);
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        if (message.compare(0, begin.size(), begin) != 0) return "without the file's name: " + message;
        return message.substr(begin.size());
    }
    return "accepted";
}

/// The text with its first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::invalid_argument("there is no '" + from + "' in the text");
    return text.replace(at, from.size(), to);
}

/// Texts of files of one name, each with a part of the reason for which it is refused.
using Refused = std::vector<std::pair<std::string, const char*>>;

inline void requireRefused(const std::string& name, const Refused& cases) {
    for (const auto& [text, reason] : cases) {
        const std::string refusal = refusalOfText(name, text);
        BOOST_TEST(holds(refusal, reason), refusal << " does not hold " << reason);
    }
}

/// Checks that the reason for which the file is refused holds the words.
inline void requireRefused(const std::string& name, const std::string& text, const std::string& words) {
    requireRefused(name, {{text, words.c_str()}});
}

/// The sum of the triangles' areas.
inline double areaOf(const Mesh& mesh) {
    double area = 0;
    for (const TriangleIndices& t : mesh.triangles) {
        const Vector3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]],
                      v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
        area += u.cross(v).norm() / 2;
    }
    return area;
}

inline std::vector<std::string> namesOf(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const Component& component : mesh.components) names.push_back(component.name);
    return names;
}

/// Four triangles with different coordinates everywhere, so that a swap of axes is noticed.
inline Mesh tetrahedron() {
    Mesh mesh;
    mesh.vertices = {{0.5, -1.25, 2}, {10, 0.125, -3}, {-4, 7.75, 1.5}, {6, 3.0625, -8}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    return mesh;
}

/// Checks that the tetrahedron's triangles begin at `first`, each corner mapped; turned over if mirrored.
template <typename Map>
void requireTetrahedron(const Mesh& mesh, std::size_t first, Map map, bool isMirrored = false) {
    const Mesh expected = tetrahedron();
    BOOST_REQUIRE(mesh.triangles.size() >= first + 4);
    for (std::size_t t = 0; t < 4; ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3 wanted =
                map(expected.vertices[expected.triangles[t][isMirrored ? (3 - i) % 3 : i]]);
            const Vector3& corner = mesh.vertices[mesh.triangles[first + t][i]];
            BOOST_TEST((corner == wanted), "corner " << i << " of " << first + t << ": " << corner.transpose()
                                                     << ", expected " << wanted.transpose());
        }
    }
}

inline Vector3 unchanged(const Vector3& v) {
    return v;
}

inline std::string words(const Vector3& vertex) {
    return std::to_string(vertex.x()) + " " + std::to_string(vertex.y()) + " " + std::to_string(vertex.z());
}

inline std::string words(const TriangleIndices& triangle, unsigned first = 0) {
    return std::to_string(triangle[0] + first) + " " + std::to_string(triangle[1] + first) + " " +
           std::to_string(triangle[2] + first);
}

inline std::string asciiStl(const Mesh& mesh, const std::string& name) {
    std::string text = "solid " + name + "\n";
    for (const TriangleIndices& triangle : mesh.triangles) {
        text += "facet normal 0 0 1\nouter loop\n";
        for (const unsigned vertex : triangle) text += "vertex " + words(mesh.vertices[vertex]) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

template <typename Value>
std::string bytesOf(const Value& value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

inline std::string binaryStl(const Mesh& mesh) {
    std::string bytes(80, ' ');
    bytes += bytesOf(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const TriangleIndices& triangle : mesh.triangles) {
        bytes.append(3 * sizeof(float), '\0');  // the normal, left for the reader to work out
        for (const unsigned vertex : triangle) {
            for (int i = 0; i < 3; ++i) bytes += bytesOf(static_cast<float>(mesh.vertices[vertex][i]));
        }
        bytes += bytesOf(std::uint16_t(0));
    }
    return bytes;
}

inline std::string objText(const Mesh& mesh, const std::string& name) {
    std::string text;
    for (const Vector3& vertex : mesh.vertices) text += "v " + words(vertex) + "\n";
    text += "o " + name + "\n";
    for (const TriangleIndices& triangle : mesh.triangles) text += "f " + words(triangle, 1) + "\n";
    return text;
}

inline std::string plyText(const Mesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vector3& vertex : mesh.vertices) text += words(vertex) + "\n";
    for (const TriangleIndices& triangle : mesh.triangles) text += "3 " + words(triangle) + "\n";
    return text;
}

inline std::string offText(const Mesh& mesh) {
    std::string text =
        "OFF\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
    for (const Vector3& vertex : mesh.vertices) text += words(vertex) + "\n";
    for (const TriangleIndices& triangle : mesh.triangles) text += "3 " + words(triangle) + "\n";
    return text;
}

/// nodes: XML of <node> elements, which show the mesh by <instance_geometry url="#shape"/>. asset: <unit> and
/// <up_axis>. With a line, the geometry also holds one line primitive.
inline std::string daeText(const Mesh& mesh, const std::string& nodes, const std::string& asset = "",
                           bool hasLine = false) {
    std::string positions, indices;
    for (const Vector3& vertex : mesh.vertices) positions += words(vertex) + " ";
    for (const TriangleIndices& triangle : mesh.triangles) indices += words(triangle) + " ";
    const std::string input = "<input semantic=\"VERTEX\" source=\"#corners\" offset=\"0\"/>";
    return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\">"
           "<asset>" +
           asset +
           "</asset><library_geometries><geometry id=\"shape\" name=\"shape\"><mesh>"
           "<source id=\"positions\"><float_array id=\"numbers\" count=\"" +
           std::to_string(3 * mesh.vertices.size()) + "\">" + positions +
           "</float_array><technique_common><accessor source=\"#numbers\" count=\"" +
           std::to_string(mesh.vertices.size()) +
           "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
           "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
           "<vertices id=\"corners\"><input semantic=\"POSITION\" source=\"#positions\"/></vertices>"
           "<triangles count=\"" +
           std::to_string(mesh.triangles.size()) + "\">" + input + "<p>" + indices + "</p></triangles>" +
           (hasLine ? "<lines count=\"1\">" + input + "<p>0 1</p></lines>" : "") +
           "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"scene\">" +
           nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
           "url=\"#scene\"/></scene></COLLADA>";
}

inline std::string base64(const std::string& bytes) {
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
        }
    }
    return text;
}

/// A .gltf with its buffer inside. nodes: JSON of the nodes, the first of which is the root; mesh 0 is the
/// mesh.
inline std::string gltfText(const Mesh& mesh, const std::string& nodes) {
    std::string bytes;
    for (const Vector3& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) bytes += bytesOf(static_cast<float>(vertex[i]));
    }
    const std::string vertexBytes = std::to_string(bytes.size());
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) bytes += bytesOf(vertex);
    }
    const std::string indexBytes = std::to_string(12 * mesh.triangles.size());
    return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + nodes +
           "],\"meshes\":[{\"name\":\"shape\",\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}"
           "]}],"
           "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":" +
           std::to_string(mesh.vertices.size()) +
           ",\"type\":\"VEC3\"},{\"bufferView\":1,\"componentType\":5125,\"count\":" +
           std::to_string(3 * mesh.triangles.size()) +
           ",\"type\":\"SCALAR\"}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":" +
           vertexBytes + "},{\"buffer\":0,\"byteOffset\":" + vertexBytes + ",\"byteLength\":" + indexBytes +
           "}],\"buffers\":[{\"byteLength\":" + std::to_string(bytes.size()) +
           ",\"uri\":\"data:application/octet-stream;base64," + base64(bytes) + "\"}]}";
}

}  // namespace clearway::testing
