// A path as an animated 3D file, for Blender and other viewers.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::report {

constexpr double kMotionSeconds = 12;

/// Writes a .glb file: the environment, and the part moving from state to state at an even pace in 12 seconds
/// (turnRadius: see PathLine), exactly as OMPL interpolates but for rounding to float. Lengths stay what they
/// are, whatever glTF's unit; z is up. To a temporary name, then renamed. Throws std::invalid_argument when
/// the file's ending is not .glb, a mesh is not sound or a coordinate is beyond float's range, and
/// std::runtime_error when it cannot be written.
void exportMotion(const Mesh& part, const Mesh& environment, const std::vector<PartState>& path,
                  double turnRadius, const std::string& file);

/// Throws std::invalid_argument when exportMotion would for the file's ending: for saying so before long
/// work.
void requireMotionFile(const std::string& file);

}  // namespace clearway::report
