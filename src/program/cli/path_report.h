// What the subcommands that have a path share: its report page, and its motion as a 3D file.
#pragma once

#include <string>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/cli/command_line.h"
#include "program/cli/print.h"

namespace clearway::cli {

/// Declares --report and --export.
void addPathOutputs(CommandLine& commandLine);

/// Throws, before long work, when one of the two is no file that may be written, is one of those that are
/// read or written otherwise, or the export's ending is not known.
void requirePathOutputs(const Options& options, const std::vector<std::string>& otherFiles);

/// Writes those of the two that were asked for, and prints a row about each. planner: figures of the planner
/// that found the path; may be empty. audit: of the path, with its profile.
void writePathOutputs(const Options& options, const Problem& problem, const Scene& scene,
                      const std::vector<PartState>& path, const planning::PathAudit& audit,
                      const Rows& planner);

}  // namespace clearway::cli
