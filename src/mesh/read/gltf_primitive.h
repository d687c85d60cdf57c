// The primitives of a glTF mesh as one node shows them: deformed by morph targets and a skin, then placed.
// Source: Khronos Group, glTF 2.0 Specification, 3.7 "Concepts", Geometry.
#pragma once

#include <string>
#include <vector>

#include "mesh/read/collector.h"
#include "mesh/read/gltf_accessor.h"

namespace clearway {

/// How a node shows its mesh.
struct GltfShowing {
    Placement X_fileMesh;           ///< unless there is a skin
    std::vector<Placement> joints;  ///< of the skin: from coordinates of the mesh to those of the file
    std::string skin;               ///< name for messages; empty without a skin
    std::vector<double> weights;    ///< of morph targets; empty: all are 0
    bool isMirrored = false;        ///< the triangles are turned over, so that fronts stay outside
};

/// Adds the primitives of a mesh to the component that has begun. Primitives that have equal vertices share them.
void addGltfPrimitives(GltfFile& file, const GltfShowing& showing, const std::vector<GltfItem>& primitives,
                       MeshCollector& mesh);

}  // namespace clearway
