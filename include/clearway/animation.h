// Writes moving parts as an animated 3D file for Blender and other viewers.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

#pragma GCC visibility push(default)

namespace clearway {

/// A part that moves along a path at an even pace, as OMPL interpolates between the states.
struct MovingPart {
    Mesh mesh;                     ///< in its own coordinates, which the states move
    std::vector<PartState> path;   ///< at least one state
    double begin = 0;              ///< seconds, >= 0; before, the part stands at its first state
    double end = 12;               ///< seconds, > begin; from then on, the part stands at its last state
    bool disappearsAtEnd = false;  ///< the part is not shown from `end` on
    std::string name{};            ///< of the node that moves; empty: "moving part"
};

/// Writes a .glb file: a mesh that stands still, which may be empty, and parts that move. Coordinates and poses are rounded to float.
/// metresPerUnit: the unit of the coordinates, 1 when it is not known: glTF's lengths are metres. z is up. The file is written under a temporary name, then
/// renamed. Throws ArgumentError when the file does not end in .glb, there is no mesh at all, a mesh is broken, a path has no state, a time
/// is out of its range or a coordinate is beyond the range of float, and FileError when the file cannot be written.
void saveAnimation(const Mesh& still, const std::vector<MovingPart>& moving, double metresPerUnit,
                   const std::string& file);

}  // namespace clearway

#pragma GCC visibility pop
