// Motion planning problems in the formats of Parasol Planning Library (PPL): .env, .robot and .query files.
#pragma once

#include <string>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::testing {

/// One free-flying body among one obstacle.
struct PplScene {
    std::string robotFile, obstacleFile;  ///< with their folders
    Vector3 obstaclePosition = Vector3::Zero();
    Box bounds;
    PartState start, goal;
};

/// Reads a scene. robotFile is the .robot file, or the .env file itself where that has the robot. PPL shifts
/// every mesh so that the mean of its vertices is the origin. Its six coordinates are a position and angles
/// about x, y and z in half turns, applied in this order.
///
/// Throws std::runtime_error when a file cannot be read. Throws std::invalid_argument, naming the file, the line
/// and what was expected, when it is not of this form, has several obstacles, or turns its obstacle.
PplScene readPplScene(const std::string& envFile, const std::string& robotFile, const std::string& queryFile);

/// Loads a .g or .obj file as PPL does: shifted by minus the mean of the file's vertices, as
/// its origin says. The vertices of an .obj
/// file must be distinct. Throws as readByuMesh and loadMesh do.
Mesh loadPplMesh(const std::string& file);

}  // namespace clearway::testing
