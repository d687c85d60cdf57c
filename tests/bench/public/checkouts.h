// The problems that others published, found in a user's checkouts of their repositories.
#pragma once

#include <string>
#include <vector>

namespace clearway::testing::public_problems {

/// A problem that the program can read, and the paths published for it.
struct PublicProblem {
    std::string name;  ///< "omplapp/3D/alpha-1.0"
    std::string file;  ///< the .cfg, in the checkout or among what was converted
    std::vector<std::string> paths = {};
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

/// Looks for problems in these folders of `checkouts`, each a checkout of the repository named:
///
/// | folder | repository |
/// | omplapp | github.com/ompl/omplapp |
/// | PuzzleTunnelDiscovery | github.com/xinyazhang/PuzzleTunnelDiscovery |
/// | PuzzleTunnelDiscovery-6bee290 | the same at commit 6bee290b4688e545c77bde0ac85e3b9bd778b330, for the Elk |
/// | open-ppl-env | github.com/parasollab/open-ppl-env |
/// | IPPP | github.com/tobiaskohlbau/IPPP |
/// | AutomatedAssemblyPlanner | github.com/atulmishrachdi/AutomatedAssemblyPlanner |
///
/// Problems in formats that the program does not read are converted: problem files and meshes (as .ply, so with
/// float coordinates) go to the folder `converted`. What is missing is skipped and said so. Throws as the readers
/// of the formats do.
PublicProblems findPublicProblems(const std::string& checkouts, const std::string& converted);

}  // namespace clearway::testing::public_problems
