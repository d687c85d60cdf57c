// The files that hold shapes, by their endings.
#pragma once

#include <string>

namespace clearway {

/// "a mesh file" for the ending of a format that clearway checks, "a CAD or scene file" for those of other programs' formats; otherwise empty.
std::string shapeFileWord(const std::string& file);

}  // namespace clearway
