// Reads mesh files through the library assimp, which checks little of what it reads.
#pragma once

#include <string>

#include "mesh/read/collector.h"

namespace clearway {

inline bool readsAsOmplApp(MeshReading reading) {
    return reading != MeshReading::kAsStored;
}

struct AssimpMesh {
    Mesh mesh;          ///< not scaled; origin.isChecked is false
    Placement applied;  ///< the unit and up axis of a COLLADA file; identity for other formats
};

/// Reads the file in any format that assimp reads, without the scale. kAsStored: transforms are applied in double, and the format is not
/// COLLADA. The other readings take OMPL.app's steps, in float. Throws as loadMesh does.
AssimpMesh readByAssimp(const std::string& file, MeshReading reading);

}  // namespace clearway
