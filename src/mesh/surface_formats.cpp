#include "mesh/surface_formats.h"

#include <string_view>

#include "core/text.h"

namespace clearway {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHead = 4096;  ///< bytes that are looked at

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

}  // namespace

std::string surfaceFormat(std::istream& stream) {
    std::string head(kHead, '\0');
    stream.read(&head[0], kHead);
    head.resize(static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    for (const SurfaceFormat& format : kSurfaceFormats) {
        if (startsWith(head, format.start)) return format.name;
    }
    // A zip archive whose first file is FreeCAD's.
    if (startsWith(head, "PK\3\4"sv) && head.compare(30, 12, "Document.xml") == 0) return "a FreeCAD file";
    if (isIges(head)) return "an IGES file";
    if (isJt(head)) return "a JT file";
    return isStep(head) ? "a STEP file" : "";
}

}  // namespace clearway
