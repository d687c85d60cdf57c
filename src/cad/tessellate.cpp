#include "cad/cad_file.h"

#include <fmt/format.h>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "core/number.h"
#include "core/text.h"
#include "mesh/components.h"

namespace clearway::cad {
namespace {

constexpr double kAngle =
    0.5;  ///< radians between neighbours along an edge; finer where the deflection asks for it

using VertexNumbers =
    std::map<std::tuple<double, double, double>, std::uint32_t>;  ///< by the point in the part

/// Adds a face's triangles, if it has any. Faces that share an edge have equal points on it, which become one vertex.
bool addFace(const TopoDS_Face& face, const gp_Trsf& X_filePart, VertexNumbers& numbers, Mesh& mesh) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, place);
    if (triangles.IsNull() || triangles->NbTriangles() == 0) return false;
    std::vector<std::uint32_t> vertices;
    for (int i = 1; i <= triangles->NbNodes(); ++i) {
        const gp_Pnt inPart = triangles->Node(i).Transformed(place), inFile = inPart.Transformed(X_filePart);
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        vertices.push_back(
            numbers.emplace(std::tuple(inPart.X(), inPart.Y(), inPart.Z()), next).first->second);
        if (vertices.back() == next) mesh.vertices.emplace_back(inFile.X(), inFile.Y(), inFile.Z());
    }
    const bool isMirrored = place.Transformation().IsNegative() != X_filePart.IsNegative();
    const bool isFlipped = isMirrored != (face.Orientation() == TopAbs_REVERSED);
    for (int i = 1; i <= triangles->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        triangles->Triangle(i).Get(a, b, c);
        if (isFlipped) std::swap(b, c);
        const TriangleIndices corners = {vertices[a - 1], vertices[b - 1], vertices[c - 1]};
        const bool isLine = corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        if (!isLine) mesh.triangles.push_back(corners);
    }
    return true;
}

}  // namespace

Mesh tessellate(const CadFile& file, std::optional<double> deflection, const std::string& stem) {
    Mesh mesh;
    mesh.origin.unitMetres = 1e-3;
    for (const CadPart& part : file.parts) {
        Bnd_Box box;
        BRepBndLib::Add(part.shape, box, false);
        const double ofPart =
            deflection.value_or(towardsZero(kUsualDeflection * std::sqrt(box.SquareExtent()), 3));
        BRepMesh_IncrementalMesh(part.shape, ofPart, false, kAngle, true);
        const std::size_t first = mesh.triangles.size();
        VertexNumbers numbers;
        std::size_t faces = 0, lost = 0;
        for (TopExp_Explorer face(part.shape, TopAbs_FACE); face.More(); face.Next(), ++faces)
            lost += !addFace(TopoDS::Face(face.Current()), part.X_filePart, numbers, mesh);
        if (lost > 0)
            throw std::runtime_error(
                fmt::format("part {}: OpenCASCADE makes no triangles for {} of its {} "
                            "faces, expected triangles for all",
                            quote(part.name.empty() ? stem : part.name), lost, faces));
        mesh.components.push_back({part.name, static_cast<std::uint32_t>(first),
                                   static_cast<std::uint32_t>(mesh.triangles.size() - first),
                                   ofPart * std::abs(part.X_filePart.ScaleFactor())});
    }
    makeNamesDistinct(mesh.components, stem);
    return mesh;
}

}  // namespace clearway::cad
