// The formats that clearway answers for, and how a file's format is recognised.
#pragma once

#include <string>
#include <string_view>

#include "mesh/read/collector.h"

namespace clearway {

struct MeshFormat {
    const char* name;
    std::string_view ending;       ///< in lower case, with the dot
    std::string_view otherEnding;  ///< may be empty
    void (*read)(std::string_view bytes, MeshCollector& mesh);
    bool hasNodes;  ///< which place meshes by transforms
};

/// The format that the file's first bytes or, where they do not tell, its ending names; null for all others.
const MeshFormat* meshFormatOf(const std::string& file, std::string_view bytes);

/// Reads the file, as stored. Throws FileError when it is not what its format prescribes.
Mesh readMesh(const MeshFormat& format, const std::string& file, std::string_view bytes);

}  // namespace clearway
