// The readers of the formats that clearway answers for. Each reads what the file holds, in double where the file has it, counts it against
// what the file declares, and refuses the file by its element's name and number otherwise.
#pragma once

#include <string_view>

#include "mesh/read/collector.h"

namespace clearway {

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

}  // namespace clearway
