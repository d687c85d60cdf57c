// Solids that OpenCASCADE makes, and files of them.
#pragma once

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::testing {

struct NamedSolid {
    std::string name;
    TopoDS_Shape shape;
};

/// Ten solids with curved surfaces: quadrics, splines, a blend, a cut and a thread.
std::vector<NamedSolid> curvedSolids();

TopoDS_Shape boxSolid(double x, double y, double z);
TopoDS_Shape cutBlock();  ///< a block with two holes that cross

struct PlacedSolid {
    NamedSolid solid;
    TopLoc_Location place;
};

/// Writes an assembly of that name. Equal shapes become instances of one part.
void writeStep(const std::string& file, const std::string& name, const std::vector<PlacedSolid>& placed);
void writeStep(const std::string& file, const NamedSolid& solid);
void writeIges(const std::string& file, const NamedSolid& solid, bool asSolid);

double exactVolume(const TopoDS_Shape& shape);
double exactArea(const TopoDS_Shape& shape);

/// Points on the faces, about `count` of them, evenly in the parameters of each.
std::vector<Vector3> surfacePoints(const TopoDS_Shape& shape, int count);

}  // namespace clearway::testing
