// The findings of a subcommand as JSON: the facts of its rows under stable names, numbers with all digits.
#pragma once

#include <string>

#include "clearway/model.h"
#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "core/json.h"
#include "program/options/command_line.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

/// The facts of this run. docs/program.md lists the names.
Json& facts();

/// Declares --json FILE. With `-` the facts go to standard output, and rows are not printed.
void addJson(CommandLine& commandLine);

/// Checks the file of --json among the other files to write.
void requireFactsFile(OutputFiles& files);

/// Writes the facts to the file of --json, if it was given. Throws std::runtime_error when that fails.
void writeFacts();

/// For a process whose findings another one collects: writeFacts() writes none.
void dropFacts();

/// Records the problem's name and unit in the JSON; rows show the unit from now on.
void tellProblem(const Problem& problem);

/// Keeps the facts about part, obstacles and margins.
void tellScene(const Scene& scene);

Json toJson(double number);  ///< null for a number that is not finite, which JSON lacks
Json toJson(const Vector3& point);
Json toJson(const Box& box);
Json toJson(const PartState& state);  ///< position, and quaternion in the order x, y, z, w
Json toJson(const Pose& pose);        ///< as of its state
Json toJson(const Model& model);
Json toJson(const planning::PathAudit& audit);

/// Two closest triangles, counted from 0, and their closest points in the environment's frame; null without any.
Json closestPair(const SceneDistance& closest, const std::string& partMesh,
                 const std::string& environmentMesh);

}  // namespace clearway::cli
