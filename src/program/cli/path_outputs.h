// The report page, the animated 3D file and the swept volume that `plan` and `check` write about a path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/cli/overlaps.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

/// The files of --report, --export and --swept; empty if the option is not given.
struct PathOutputs {
    std::string report, motion, swept;
    std::optional<double> sweptTolerance;
    bool isOfMiss = false;  ///< the path is the nearest miss of planning that found none

    bool isEmpty() const { return report.empty() && motion.empty() && swept.empty(); }
    void require(OutputFiles& files) const;

    /// Writes the files and prints a row about each. Returns false when Ctrl-C left one out. planner: figures of the
    /// planner that found the path; may be empty. audit: the path's audit, with its profile. overlaps: those along the
    /// path.
    bool write(const Problem& problem, const SceneMeshes& meshes, const Scene& scene,
               const std::vector<PartState>& path, const planning::PathAudit& audit, const Rows& planner,
               const std::vector<FoundOverlap>& overlaps) const;

    /// Prints a row about each file that is not written, with the reason.
    void tellUnwritten(const std::string& why) const;
};

/// Why the volume along the path cannot be known as finely as --swept-tolerance asks: the part's places have an error of their
/// own. Empty where it can, or without --swept. A path of the start alone gives what holds for every path from there.
std::string whySweptIsTooFine(const PathOutputs& outputs, const Scene& scene,
                              const std::vector<PartState>& path);

/// Declares --report, --export, --swept and --swept-tolerance.
void addPathOutputs(CommandLine& commandLine, PathOutputs& to);

/// The environment as one mesh to show, without the obstacles that the problem ignores. If the problem
/// ignores all obstacles, all are shown.
Mesh shownEnvironment(const Problem& problem, const std::vector<Mesh>& worlds);

}  // namespace clearway::cli
