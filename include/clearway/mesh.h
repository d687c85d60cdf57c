// A triangle mesh with named components, read from a file or made in memory.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

/// The positions of a triangle's three corners in Mesh::vertices: counter-clockwise as seen from its front,
/// which faces outwards on the surface of a solid.
using TriangleIndices = std::array<std::uint32_t, 3>;

/// A named run of triangles, such as one mesh of one node of a file. Results refer to triangles by component.
struct Component {
    std::string name;                 ///< empty for a nameless component
    std::uint32_t firstTriangle = 0;  ///< position in Mesh::triangles
    std::uint32_t triangleCount = 0;  ///< may be 0
    /// How far the file says its triangles may be from the surface they were made for, in mesh coordinates; 0 if it says nothing.
    double deflection = 0;
};

/// How the loader made the stored coordinates: stored = scale * (file coordinates) + shift, where the file
/// coordinates are those after the file's node transforms, in file units.
struct MeshOrigin {
    std::string file;                 ///< empty for a mesh made in memory
    double scale = 1.0;               ///< LoadOptions::scale
    Vector3 shift = Vector3::Zero();  ///< applied after the scale, in stored units
    std::string format;               ///< of the file, such as "OBJ"; empty for a mesh made in memory
    /// Whether a reader of clearway's counted the file's faces against what the file declares. Other formats are read by assimp alone, which
    /// may lose some of them silently.
    bool isChecked = true;
    double unitMetres = 0;  ///< the unit that the file states, in metres; 0 if it states none
    char upAxis = 0;        ///< 'x', 'y' or 'z' if the file states it, else 0
    std::size_t ignoredFaces =
        0;  ///< points, lines and crossingFaces; a polygon of n corners counts as n - 2
    std::size_t crossingFaces =
        0;  ///< polygons that cross themselves, so that no triangles fill them: they are left out
    std::size_t bentFaces =
        0;              ///< polygons that are not flat; their triangles fill them in one of several ways
    double bentBy = 0;  ///< the largest distance of a corner from its polygon's plane; file units
    /// Warnings to show with every verdict, one line each: assimp alone read the file, polygons were left out or are
    /// not flat, or a component has no area.
    std::vector<std::string> warnings;
    /// One line for each other conversion that was applied or left out: units, up axis, assimp's own
    /// conversions, re-centring.
    std::vector<std::string> notes;
    double deflection =
        0;  ///< the largest one that the file states for a component (3MF alone), in file units; 0 for none
};

/// Triangles over shared vertices. The stored doubles are exact by definition: every query answers for them.
/// A triangle's id is its position in `triangles`.
struct Mesh {
    std::vector<Vector3> vertices;           ///< mesh coordinates; finite where a triangle uses them
    std::vector<TriangleIndices> triangles;  ///< into `vertices`; at least one for Model::build
    /// Consecutive runs that cover `triangles` in order; empty means one nameless component.
    std::vector<Component> components;
    MeshOrigin origin;  ///< only names of meshes and reports depend on it, no distance
};

/// How to read a file's coordinates.
enum class MeshReading {
    kAsStored,            ///< coordinates as the file holds them
    kOmplAppEnvironment,  ///< as OMPL.app reads its environment: not shifted
    kOmplAppRobot,  ///< as OMPL.app reads an SE(3) robot: shifted by minus the float mean of its vertices
    kOmplAppPlanarRobot,  ///< as OMPL.app reads an SE(2) robot: shifted like kOmplAppRobot, but not in z
};

/// How loadMesh reads a file.
struct LoadOptions {
    MeshReading reading = MeshReading::kAsStored;  ///< which conversions are applied, see loadMesh
    double scale = 1.0;                            ///< > 0; stored = scale * file coordinates
};

/// Reads a mesh file. STL, OBJ, PLY, OFF, glTF, GLB, 3MF and COLLADA (.dae) are checked: what is read is counted against what the file
/// declares, in double where the file has it, and what cannot be read is refused by name. All other formats are read by assimp alone, in
/// float, and origin.isChecked is false.
///
/// Node transforms are applied in double. Polygons are triangulated inside their outline; those that cross themselves are left out, and
/// counted in origin with points, lines and polygons that are not flat. Equal vertices are not welded yet.
///
/// kAsStored applies neither the unit nor the up axis that a file states; origin has both. The other readings do as OMPL.app does, in
/// float: assimp applies unit and up axis, may join vertices whose attributes all agree to 1e-5, and the scale comes last. A file of which
/// assimp finds another number of triangles or another box than clearway is then refused. origin.notes lists the conversions.
///
/// Each mesh of each node, each object of a 3MF file, each group or object of an OBJ file and each solid of an STL file is a component, in
/// the order of the file (in the OMPL.app readings, of the nodes that OMPL.app's steps leave). Its name is "node/mesh", or only one of the
/// names when both are equal or one is missing. Repeated names get #2, #3, ...; a component without a name gets the file's stem.
///
/// Throws FileError when the file is missing, is not what its format prescribes, holds no triangle or has a triangle with a vertex
/// that is not finite (naming the first such triangle). Throws ArgumentError when the scale is not a finite number above 0.
Mesh loadMesh(const std::string& file, const LoadOptions& options = {});

/// Writes the mesh in the format of the file's ending: .3mf, .glb, .obj, .ply, .stl or .dae. All but .3mf store coordinates
/// rounded to float. The file is written under a temporary name, then renamed.
///
/// .3mf reads back to equal doubles, triangles in equal order, equal component names (if distinct and not empty), deflections and unit.
/// The unit of the coordinates is origin.unitMetres / origin.scale. Without a unit, other programs take 3MF coordinates for millimetres;
/// loadMesh then finds no unit, as before.
///
/// .glb reads back to equal floats, the triangles in equal order, and equal component names (if distinct and not empty). .obj and .dae keep
/// order and names; their text tells floats apart, with fewer digits than doubles need: coordinates read back within 1e-8 of their size. .ply
/// and .stl (both binary) keep floats and order and lose the components. Components without triangles are left out.
///
/// Throws ArgumentError for an unknown ending, a mesh that Model::build would refuse, a coordinate beyond float's range (not for .3mf) and,
/// for .3mf, a unit other than its own (micron, millimeter, centimeter, inch, foot, meter) or a name with control characters. Throws
/// FileError when the file cannot be written.
void saveMesh(const Mesh& mesh, const std::string& file);

/// The closed surface of a box as one component: 12 triangles that face outwards. Useful as a keep-out
/// region. Throws ArgumentError, naming the box, when it is empty, flat or not finite.
Mesh boxMesh(const Box& box, const std::string& name = "box");

/// The smallest box that holds every vertex of a triangle, in mesh coordinates; empty for a mesh without
/// triangles.
Box boundingBox(const Mesh& mesh);

/// The index of the component with this triangle; 0 if there are no components. components: those of a Mesh or a Model.
std::size_t componentOf(const std::vector<Component>& components, std::size_t triangle);

/// The index into mesh.components of the component with this triangle.
std::size_t componentOf(const Mesh& mesh, std::size_t triangle);

}  // namespace clearway

#pragma GCC visibility pop
