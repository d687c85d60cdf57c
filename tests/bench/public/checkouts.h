// The problems that others published, found in a user's checkouts of their repositories.
#pragma once

#include <string>
#include <vector>

#include "bench/public/manifest.h"

namespace clearway::testing::public_problems {

/// A problem that the program can read, and the paths published for it.
struct PublicProblem {
    std::string name;  ///< "omplapp/3D/alpha-1.0"
    std::string file;  ///< the .cfg, in the checkout or among what was converted
    std::vector<std::string> paths = {};
    bool isOmplApps =
        true;  ///< its goal is a pose and no obstacle may reach into the part: OMPL.app can pose it
};

/// The parts of an assembly, one mesh file each, all in the assembly's coordinates.
struct Assembly {
    std::string name;
    std::vector<std::string> files;
};

struct PublicProblems {
    std::vector<PublicProblem> puzzles;
    std::vector<Assembly> assemblies;
    std::vector<std::string> skipped;  ///< one line for each thing that a checkout lacks
};

/// Looks for the problems of each manifest in the folder of `checkouts` that has its name. Problems of which the
/// repository has no problem file that the program reads are written to the folder `converted`; so are meshes that
/// it does not read (as .ply, so with float coordinates). What is missing is skipped and said so. Throws as the
/// readers of the formats do.
PublicProblems findPublicProblems(const std::vector<Manifest>& manifests, const std::string& checkouts,
                                  const std::string& converted);

}  // namespace clearway::testing::public_problems
