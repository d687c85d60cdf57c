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

// The readers. Each reads what the file holds, in double where the file has it, counts it against what the file declares, and refuses
// the file by its element's name and number otherwise.
void readStl(std::string_view bytes, MeshCollector& mesh);
void readObj(std::string_view bytes, MeshCollector& mesh);
void readPly(std::string_view bytes, MeshCollector& mesh);
void readOff(std::string_view bytes, MeshCollector& mesh);

/// glTF 2.0, as text or binary (.glb). Buffers may be files beside it.
void readGltf(std::string_view bytes, MeshCollector& mesh);

/// 3MF: a zip archive of models in XML.
void read3mf(std::string_view bytes, MeshCollector& mesh);

/// COLLADA (.dae).
void readDae(std::string_view bytes, MeshCollector& mesh);

/// Reads the file, as stored. Throws FileError when it is not what its format prescribes.
Mesh readMesh(const MeshFormat& format, const std::string& file, std::string_view bytes);

}  // namespace clearway
