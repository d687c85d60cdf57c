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

/// What the loader did between the file and the stored coordinates: stored = scale * (file coordinates) + shift.
struct MeshOrigin {
    std::string file;                 ///< empty for a mesh made in memory
    double scale = 1.0;
    Vector3 shift = Vector3::Zero();  ///< applied after the scale
    std::size_t ignoredFaces = 0;     ///< points, lines and what could not be triangulated
};

/// Triangles over shared vertices, in doubles. These stored doubles are the truth that every query answers for.
/// A triangle's id is its position in `triangles`.
struct Mesh {
    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
    /// Consecutive runs that cover `triangles` in order; empty means one nameless component.
    std::vector<Component> components;
    MeshOrigin origin;
};

/// How the file is read.
enum class MeshReading {
    kAsStored,             ///< coordinates as the file holds them
    kOmplAppEnvironment,   ///< as OMPL.app reads its world: not shifted
    kOmplAppRobot,         ///< as OMPL.app reads an SE(3) robot: shifted by minus the float mean of its vertices
    kOmplAppPlanarRobot,   ///< as OMPL.app reads an SE(2) robot: the same, but z keeps its place
};

struct LoadOptions {
    MeshReading reading = MeshReading::kAsStored;
    double scale = 1.0;  ///< > 0; stored = scale * file coordinates
};

/// Reads any format assimp reads: node transforms applied, polygons triangulated, points and lines left out and
/// counted, node and mesh names kept as components. Debian's assimp holds coordinates in float: the mesh returned is
/// exactly what assimp returned (times the scale, plus the shift, in double), its equal vertices not yet welded.
/// Throws std::runtime_error when the file is missing, cannot be read or holds no triangle, and std::invalid_argument
/// when the scale is not a finite number above 0.
Mesh loadMesh(const std::string& file, const LoadOptions& options = {});

/// Writes the mesh in the format of the file's ending (.obj, .ply, .stl, .glb, ...), components as named nodes.
/// Coordinates are rounded to float, as the formats hold them. Written to a temporary name, then renamed.
/// Throws std::runtime_error when it cannot be written and std::invalid_argument for an unknown ending.
void saveMesh(const Mesh& mesh, const std::string& file);

/// The smallest box that holds every vertex a triangle uses; empty for a mesh without triangles.
Box boundingBox(const Mesh& mesh);

/// Index into mesh.components of the component that holds the triangle; 0 when components is empty.
std::size_t componentOf(const Mesh& mesh, std::size_t triangle);

}  // namespace clearway
