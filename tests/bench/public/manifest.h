// Manifests: the files of data/problems, each of which lists the public problems of one repository.
#pragma once

#include <string>
#include <vector>

#include "clearway/problem.h"

namespace clearway::testing::public_problems {

/// A mesh file, and how far it is moved.
struct PlacedMesh {
    std::string file;
    Vector3 position = Vector3::Zero();
};

/// A problem as its manifest lists it. Files are named from the repository's top folder.
struct ListedProblem {
    std::string name;    ///< "omplapp/3D/alpha-1.0"
    std::string config;  ///< the repository's own problem file; empty if it has none that clearway reads
    Problem problem;     ///< all but the mesh files; has no meaning with a `config`
    std::string robot;   ///< the part's mesh; empty: as `config` says
    std::vector<PlacedMesh> world;   ///< the environment's meshes; empty: as `config` says
    bool isPpl = false;              ///< meshes are centred and placed as Parasol Planning Library does
    bool hasWalls = false;           ///< the bounds are walls, which no point of the part may pass
    std::vector<std::string> paths;  ///< published solutions
};

/// The public problems of one repository at one commit.
struct Manifest {
    std::string folder;  ///< of the repository among a user's checkouts: the manifest's name without .json
    std::string repository, commit, licence;
    std::vector<ListedProblem> problems;
    std::vector<std::string> assemblies;  ///< folders of mesh files, one a part, in assembled coordinates
};

/// Reads a manifest; docs/public_problems.md says what it holds. Throws std::invalid_argument, naming the file, the
/// problem, the key and what was expected, when a key is missing, unknown or wrong.
Manifest readManifest(const std::string& file);

/// Reads all manifests of data/problems, by name.
std::vector<Manifest> readManifests();

}  // namespace clearway::testing::public_problems
