// A triangle mesh with its named components, as a file holds it or as arrays in memory give it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "clearway/types.h"

namespace clearway {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// A named run of triangles: one mesh of one node of a file. Results name it.
struct Component {
    std::string name;
    std::uint32_t firstTriangle = 0;
    std::uint32_t triangleCount = 0;
};

/// What the loader did between the file and the stored coordinates: stored = scale * (file coordinates) +
/// shift, where the file's coordinates are those after its node transforms, in file units.
struct MeshOrigin {
    std::string file;  ///< empty for a mesh made in memory
    double scale = 1.0;
    Vector3 shift = Vector3::Zero();  ///< applied after the scale
    std::size_t ignoredFaces = 0;     ///< points, lines and what could not be triangulated
    /// One line each about what else was applied or left out: units, up axis, conversions of assimp's own,
    /// re-centring.
    std::vector<std::string> notes;
};

/// Triangles over shared vertices, in doubles. These stored doubles are the truth that every query answers
/// for. A triangle's id is its position in `triangles`.
struct Mesh {
    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
    /// Consecutive runs that cover `triangles` in order; empty means one nameless component.
    std::vector<Component> components;
    MeshOrigin origin;
};

/// How the file is read.
enum class MeshReading {
    kAsStored,            ///< coordinates as the file holds them
    kOmplAppEnvironment,  ///< as OMPL.app reads its world: not shifted
    kOmplAppRobot,  ///< as OMPL.app reads an SE(3) robot: shifted by minus the float mean of its vertices
    kOmplAppPlanarRobot,  ///< as OMPL.app reads an SE(2) robot: the same, but z keeps its place
};

struct LoadOptions {
    MeshReading reading = MeshReading::kAsStored;
    double scale = 1.0;  ///< > 0; stored = scale * file coordinates
};

/// Reads any format assimp reads: node transforms applied, polygons triangulated, points and lines left out
/// and counted; equal vertices are not yet welded. Debian's assimp holds coordinates and transforms in float.
///
/// kAsStored applies the transforms in double; without transforms the coordinates are exactly assimp's
/// floats, times the scale. A COLLADA file's unit and up axis, which assimp would fold into its root, are
/// left out. The other readings do all arithmetic in float and by assimp's defaults, as OMPL.app does (unit
/// and up axis applied, vertices that agree in all their attributes to 1e-5 may be joined), and scale last.
/// Whatever was applied or left out is in origin.notes.
///
/// Each mesh of each node is a component, in the order of the file's nodes (of the nodes that OMPL.app's
/// steps leave, in the other readings), named by node and mesh: "node/mesh", or the one name when they agree
/// or one has none. Repeated names get #2, #3, ...; without a name it is the file's stem.
///
/// Throws std::runtime_error when the file is missing, cannot be read, holds no triangle or has a triangle
/// with a vertex that is not finite (naming the first such triangle), and std::invalid_argument when the
/// scale is not a finite number above 0.
Mesh loadMesh(const std::string& file, const LoadOptions& options = {});

/// Writes the mesh in the format of the file's ending: .glb, .obj, .ply, .stl or .dae. Coordinates are
/// rounded to float, as the formats hold them. Written to a temporary name, then renamed.
///
/// .glb reads back to the same floats, triangles in the same order and the same component names (when
/// distinct and not empty). .obj and .dae keep order and names; being text, assimp reads a coordinate below
/// 1e-4 or of 1e9 and more back one or two units in the last place off. .ply and .stl (both binary) keep
/// floats and order, and forget the components. Components without triangles are left out.
///
/// Throws std::invalid_argument for an unknown ending, a mesh that Model::build would refuse and a coordinate
/// beyond float's range, and std::runtime_error when the file cannot be written.
void saveMesh(const Mesh& mesh, const std::string& file);

/// The closed surface of a box as one component: 12 triangles that face outwards. A keep-out region, say.
/// Throws std::invalid_argument, naming the box, when it is empty, flat or not finite.
Mesh boxMesh(const Box& box, const std::string& name = "box");

/// The smallest box that holds every vertex a triangle uses; empty for a mesh without triangles.
Box boundingBox(const Mesh& mesh);

/// Index into mesh.components of the component that holds the triangle; 0 when components is empty.
std::size_t componentOf(const Mesh& mesh, std::size_t triangle);

}  // namespace clearway
