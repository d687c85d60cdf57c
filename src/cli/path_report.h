// What the subcommands that have a path share: its report page.
#pragma once

#include <string>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "cli/print.h"

namespace clearway {

/// Writes the page and prints a row about it. planner: figures of the planner that found the path; may be
/// empty.
void writePathReport(const Problem& problem, const Scene& scene, const std::vector<PartState>& path,
                     const planning::PathAudit& audit, const Rows& planner, const std::string& file);

}  // namespace clearway
