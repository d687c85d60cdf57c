// Writes a path as an animated 3D file for Blender and other viewers.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::report {

constexpr double kMotionSeconds = 12;

/// Writes a .glb file: the environment, and the part moving at an even pace along the path in kMotionSeconds
/// (turnRadius: see PathLine). The part moves as OMPL interpolates, up to rounding to float. metres: in one
/// unit of length, because glTF's lengths are metres; 1 when the unit is not known. z is up. Writes under a temporary
/// name and renames. Throws std::invalid_argument when the file does not end in .glb, a mesh is broken or a coordinate
/// is beyond the range of float, and std::runtime_error when the file cannot be written.
void exportMotion(const Mesh& part, const Mesh& environment, const std::vector<PartState>& path,
                  double turnRadius, double metres, const std::string& file);

/// Writes a mesh that stands still as exportMotion() writes the environment. Throws as it does.
void exportStill(const Mesh& mesh, double metres, const std::string& file);

}  // namespace clearway::report
