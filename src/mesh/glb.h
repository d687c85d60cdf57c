// Binary glTF 2.0 (.glb) with floats, order and names kept exactly; assimp's own exporter joins vertices
// within 1e-5 of each other. Here too: the parts of a mesh, in float, that all writers of mesh files take.
#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// A component for writing.
struct SavePart {
    std::string name;
    std::vector<std::array<float, 3>> vertices;
    std::vector<TriangleIndices> triangles;  ///< into vertices, in the mesh's order
};

/// The mesh's components that have triangles, in order. Each has the vertices it uses, in the order of their
/// first use and rounded to float. Throws ArgumentError when the mesh is not sound (see
/// requireSoundMesh) or a coordinate is beyond float's range.
std::vector<SavePart> savePartsOf(const Mesh& mesh, const std::string& namelessName);

/// Writes one node with one mesh for each part, both with the part's name. Throws ArgumentError when
/// the parts need more than the 4 GiB that the format can address.
void writeGlb(const std::vector<SavePart>& parts, std::ostream& stream);

/// Where a mover is at one time. Between two keys it moves straight and turns evenly, the shorter way.
struct GlbKey {
    float seconds = 0;
    std::array<float, 3> position{};
    std::array<float, 4> rotation{0, 0, 0, 1};  ///< x y z w, unit length
};

/// Parts that move as one.
struct GlbMover {
    std::string name;             ///< of the node that moves
    std::vector<SavePart> parts;  ///< at least one, in coordinates of the node
    std::vector<GlbKey> keys;     ///< at least one, times rising
    float hiddenFrom = -1;        ///< seconds; negative: always shown
};

/// Writes the still parts and the movers, with one animation of all movers, under a root that scales to metres (metres: in one unit of the
/// coordinates) and turns z (up in clearway) to y (up in glTF). Throws as writeGlb does.
void writeMovingGlb(const std::vector<SavePart>& still, const std::vector<GlbMover>& movers, double metres,
                    std::ostream& stream);

}  // namespace clearway
