// Checks of mesh files before they are read, and of meshes before anything is built from them.
#include "mesh/check.h"

#include <fmt/format.h>
#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/text.h"
#include "mesh/clean.h"
#include "mesh/components.h"

namespace clearway {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHead = 4096;   ///< bytes that are looked at
constexpr std::size_t kZipName = 30;  ///< where the name of an archive's first file begins

struct SurfaceFormat {
    std::string_view start;  ///< of the file
    const char* name;
};

constexpr SurfaceFormat kSurfaceFormats[] = {
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "a CAD program's own file (SolidWorks, Inventor or Solid Edge)"},
    {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, "a Parasolid file"},
    {"PS\0\0"sv, "a Parasolid file"},
    {"ACIS BinaryFile"sv, "an ACIS file"},
    {"ASM BinaryFile"sv, "an ACIS file"},
    {"V5_CFV2"sv, "a CATIA file"},
    {"#UGC:2"sv, "a Creo file"},
    {"3D Geometry File Format"sv, "a Rhino file"},
    {"AC10"sv, "an AutoCAD drawing"},
    {"DBRep_DrawableShape"sv, "an Open CASCADE file"},
    {"CASCADE Topology"sv, "an Open CASCADE file"},
};

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

/// The text form of ACIS (.sat). The first line has three or four whole numbers: release, records, entities, flags. The
/// second names the program, the modeller ("ACIS 7.0" or Autodesk's "ASM 208.0.4") and the time.
bool isAcisText(std::string_view head) {
    const std::size_t end = head.find('\n');
    if (end == std::string_view::npos) return false;
    const std::vector<std::string_view> numbers = words(head.substr(0, end));
    if (numbers.size() < 3 || numbers.size() > 4) return false;
    for (const std::string_view number : numbers) {
        if (!parseInteger(number)) return false;
    }
    const std::string_view rest = head.substr(end + 1);
    for (const std::string_view word : words(rest.substr(0, rest.find('\n')))) {
        if (word == "ACIS" || word == "ASM") return true;
    }
    return false;
}

/// The first line of an IGES file ends with its section, S, in column 73, and the line's number.
bool isIges(std::string_view head) {
    const std::string_view line = head.substr(0, head.find_first_of("\r\n"));
    return line.size() >= 74 && line.size() <= 80 && line[72] == 'S' && trimmed(line.substr(73)) == "1";
}

bool isJt(std::string_view head) {
    const std::string_view version = head.substr(0, 80);
    return startsWith(version, "Version ") && version.find(" JT ") != std::string_view::npos;
}

bool isStep(std::string_view head) {
    if (!startsWith(trimmed(head), "ISO-10303-21")) return false;
    const std::size_t schema = head.find("FILE_SCHEMA");
    return schema == std::string_view::npos || head.find("IFC", schema) == std::string_view::npos;
}

/// The format of a file that holds curved surfaces, or a CAD program's own model, in place of triangles: "a STEP
/// file". Empty for all others; these are left to the reader of meshes. IFC files, which assimp reads, are written as
/// STEP is and count among the others. stream: at the file's beginning, is moved.
std::string surfaceFormat(std::istream& stream) {
    std::string bytes(kHead, '\0');
    stream.read(&bytes[0], kHead);
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    std::string_view head = bytes;
    if (startsWith(head, kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
    for (const SurfaceFormat& format : kSurfaceFormats) {
        if (startsWith(head, format.start)) return format.name;
    }
    // A zip archive whose first file is FreeCAD's.
    const bool isZip = startsWith(head, "PK\3\4"sv) && head.size() > kZipName;
    if (isZip && startsWith(head.substr(kZipName), "Document.xml")) return "a FreeCAD file";
    if (isAcisText(head)) return "an ACIS file";
    if (isIges(head)) return "an IGES file";
    if (isJt(head)) return "a JT file";
    return isStep(head) ? "a STEP file" : "";
}

}  // namespace

void refuseMeshFile(const std::string& file, std::string reason) {
    for (char& character : reason) {
        if (character == '\n' || character == '\r') character = ' ';
    }
    while (!reason.empty() && (reason.back() == ' ' || reason.back() == '.')) reason.pop_back();
    if (reason.empty()) reason = "the reader gives no reason";
    throw FileError(
        "cannot read mesh '" + file + "': " + reason +
        ", expected a mesh file (stl, obj, ply, off, gltf, glb, 3mf, dae, or what else assimp reads)");
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
    if (boost::iends_with(file, ".cfg")) refuseMeshFile(file, "it is a problem file");
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (bytes == 0) refuseMeshFile(file, "it is empty");
    const std::string format = surfaceFormat(stream);
    if (!format.empty()) {
        const bool isExchanged = format == "a STEP file" || format == "an IGES file";
        const std::string mesh = std::filesystem::path(file).replace_extension(".3mf").string();
        throw FileError(
            "cannot read mesh '" + file + "': it is " + format +
            ", which holds surfaces, not triangles, expected a mesh: " +
            (isExchanged ? fmt::format("clearway-cad '{}' --out '{}' makes one, or ", file, mesh) : "") +
            "export STL, OBJ, 3MF or "
            "glTF from the CAD program");
    }
}

namespace {

constexpr std::size_t kMostNamed = 3;  ///< components in a warning

std::string inFile(const Mesh& mesh) {
    return mesh.origin.file.empty() ? std::string() : " in '" + mesh.origin.file + "'";
}

}  // namespace

void requireComponents(const Mesh& mesh) {
    if (mesh.components.empty()) return;
    std::uint64_t expectedFirst = 0;
    for (std::size_t i = 0; i < mesh.components.size(); ++i) {
        const Component& component = mesh.components[i];
        if (component.firstTriangle != expectedFirst) {
            throw ArgumentError(fmt::format(
                "component {} ('{}'){} begins at triangle {}, expected {}, the end of the component before",
                i, component.name, inFile(mesh), component.firstTriangle, expectedFirst));
        }
        expectedFirst += component.triangleCount;
    }
    if (expectedFirst != mesh.triangles.size()) {
        throw ArgumentError(fmt::format("the components{} hold {} triangles, expected {}, all of the mesh",
                                        inFile(mesh), expectedFirst, mesh.triangles.size()));
    }
}

namespace {

bool hasArea(const Mesh& mesh, const Component& component) {
    for (std::size_t i = 0; i < component.triangleCount; ++i) {
        const TriangleIndices& corners = mesh.triangles[component.firstTriangle + i];
        if (!isDegenerate(mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]))
            return true;
    }
    return false;
}

/// "'line', 'dot' and 3 more": the components without a triangle that has area.
std::string namesWithoutArea(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const Component& component : componentsOf(mesh)) {
        if (component.triangleCount == 0 || hasArea(mesh, component)) continue;
        names.push_back(component.name.empty() ? "the mesh" : "'" + component.name + "'");
    }
    const std::size_t more = names.size() - std::min(names.size(), kMostNamed);
    names.resize(names.size() - more);
    return joined(names) + (more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace

std::string nameOfTriangle(const Mesh& mesh, std::size_t triangle) {
    std::string name = fmt::format("triangle {}", triangle);
    if (!mesh.components.empty()) {
        name += " of component '" + mesh.components[componentOf(mesh, triangle)].name + "'";
    }
    return name + inFile(mesh);
}

void requireSoundMesh(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        throw ArgumentError("the mesh" + inFile(mesh) + " holds 0 triangles, expected at least 1");
    }
    requireComponents(mesh);
    for (std::size_t id = 0; id < mesh.triangles.size(); ++id) {
        for (const std::uint32_t vertex : mesh.triangles[id]) {
            if (vertex >= mesh.vertices.size()) {
                throw ArgumentError(fmt::format("{} refers to vertex {}, expected one below {}",
                                                nameOfTriangle(mesh, id), vertex, mesh.vertices.size()));
            }
            const Vector3& at = mesh.vertices[vertex];
            if (at.allFinite()) continue;
            throw ArgumentError(
                fmt::format("{} has a vertex at ({:g}, {:g}, {:g}), expected finite coordinates",
                            nameOfTriangle(mesh, id), at.x(), at.y(), at.z()));
        }
    }
}

std::vector<std::string> readingWarnings(const Mesh& mesh) {
    const MeshOrigin& origin = mesh.origin;
    std::vector<std::string> warnings;
    if (!origin.isChecked) {
        warnings.push_back(origin.file + ": not checked: " + origin.format + " is read by assimp alone");
    }
    if (const std::size_t count = origin.crossingFaces; count > 0) {
        warnings.push_back(fmt::format("{}: {}{}; nothing is kept clear there", origin.file, count,
                                       count == 1 ? " face left out, whose outline crosses itself"
                                                  : " faces left out, whose outlines cross themselves"));
    }
    if (const std::size_t count = origin.bentFaces; count > 0) {
        warnings.push_back(
            fmt::format("{}: {}{} not flat, by up to {:.3g}; triangles fill them in one of several ways",
                        origin.file, count, count == 1 ? " face" : " faces", origin.bentBy));
    }
    if (const std::string names = namesWithoutArea(mesh); !names.empty()) {
        warnings.push_back(origin.file + ": zero area: every triangle of " + names +
                           " is a line or a point, and only these are kept clear");
    }
    return warnings;
}

std::string turnedByAssimp(const MeshOrigin& origin) {
    for (const std::string& note : origin.notes) {
        const std::size_t at = note.find(kAssimpsTurn);
        if (at != note.npos) return note.substr(at + std::string(kAssimpsTurn).size());
    }
    return "";
}

void requireSoundMeshFile(const Mesh& mesh, const std::string& file) {
    try {
        requireSoundMesh(mesh);
    } catch (const std::invalid_argument& error) {
        std::string reason = error.what();
        const std::size_t at = reason.find(inFile(mesh));  // the message names the file already
        if (at != reason.npos) reason.erase(at, inFile(mesh).size());
        throw FileError("cannot read mesh '" + file + "': " + reason);
    }
}

}  // namespace clearway
