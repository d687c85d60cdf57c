// STEP and IGES files: their parts, with names and places, as OpenCASCADE reads them, and triangles for these. Lengths are in
// millimetres, whatever the file's unit.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <gp_Trsf.hxx>
#include <optional>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::cad {

/// One placed instance of a part.
struct CadPart {
    std::string name;  ///< "assembly/part"; not always distinct, may be empty
    TopoDS_Shape shape;
    gp_Trsf X_filePart;  ///< from the shape's coordinates to those of the file; may mirror
};

struct CadFile {
    std::vector<CadPart> parts;    ///< each has a face
    std::string unit;              ///< the file's, by its own name; lengths are converted from it
    std::size_t withoutFaces = 0;  ///< parts left out, which are points and curves alone
};

/// Throws std::runtime_error, naming the file, when it cannot be read whole: each face that it holds must be there.
CadFile readCadFile(const std::string& file);

constexpr double kUsualDeflection = 1e-3;  ///< of the diagonal of a part's box

/// A mesh with a component for each part, in the file's coordinates. deflection: how far the triangles may be from a part's surface, in
/// millimetres; by default kUsualDeflection. OpenCASCADE aims at it. Edges are shared: a closed part gets a closed surface. Throws
/// std::runtime_error, naming the part, when a face gets no triangles. stem: names parts without a name.
Mesh tessellate(const CadFile& file, std::optional<double> deflection, const std::string& stem);

}  // namespace clearway::cad
