#include "mesh/surface_formats.h"

#include <string_view>
#include <vector>

#include "core/number.h"
#include "core/text.h"

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

}  // namespace

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

}  // namespace clearway
