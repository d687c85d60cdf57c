// The findings of a subcommand: one table of facts, which is printed as rows and written as JSON. JSON has stable names, and
// numbers with all digits.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/obstacle_groups.h"
#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "core/json.h"
#include "core/number.h"
#include "program/options/command_line.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

/// The facts of this run. docs/program.md lists the names.
Json& facts();

/// One finding: a row on screen, a value in JSON, or both.
struct Fact {
    std::string label, shown;  ///< without a label there is no row
    std::string name = {};     ///< without a name there is no value
    Json value = {};
};
using Facts = std::vector<Fact>;  ///< in the order of rows and of values

/// A value without a row.
Fact kept(const std::string& name, Json value);

/// Leaves out the fact's row unless isShown. Its value stays.
Fact shownIf(bool isShown, Fact fact);

/// A number with its unit. Without the number there is no row, and the value is null.
template <class Number>
Fact optionalFact(const std::string& label, const std::string& name, const std::optional<Number>& number,
                  const std::string& unit = "") {
    if (!number) return kept(name, {});
    return {label, withUnit(readable(static_cast<double>(*number)), unit), name, *number};
}

Rows rowsOf(const Facts& table);
Json toJson(const Facts& table);

/// Prints the table's rows, and keeps its values among the facts.
void tell(const Facts& table);

/// Declares --json FILE. With `-` the facts go to standard output, and rows are not printed.
void addJson(CommandLine& commandLine);

/// Checks the file of --json among the other files to write.
void requireFactsFile(OutputFiles& files);

/// Writes the facts to the file of --json, if it was given. Throws std::runtime_error when that fails.
void writeFacts();

/// For a process whose findings another one collects: writeFacts() writes none.
void dropFacts();

/// Records the problem's name, unit and deflection in the JSON; rows show the unit from now on.
void tellProblem(const Problem& problem);

/// Records the deflection of the meshes in the JSON, null for 0; deflectionRows() shows it from now on. isInMargin: see useDeflection().
void tellDeflection(double deflection, bool isInMargin = false);

/// Tells the part's mesh, the obstacles (by name when rules tell them apart), the margin and the contact zones.
void tellScene(const Problem& problem, const Scene& scene);

/// "'lid', 'screw_1' of " where the part is a part of an assembly, whose file is named next; otherwise empty.
std::string movingNames(const Problem& problem, const Model& part);

/// Tells the obstacles that the rules make, and prints which they ignore.
void tellObstacles(const ObstacleGroups& obstacles);

/// Names and triangles of the components.
Json toJson(const std::vector<Component>& components);

Json toJson(double number);  ///< null for a number that is not finite, which JSON lacks
Json toJson(const Vector3& point);
Json toJson(const Box& box);
Json toJson(const PartState& state);  ///< position, and quaternion in the order x, y, z, w
Json toJson(const Pose& pose);        ///< as of its state
Json toJson(const Model& model);
Json toJson(const planning::PathAudit& audit, const Scene& scene);

/// Two closest triangles, counted from 0, and their closest points in the environment's frame; null without any.
Json closestPair(const SceneDistance& closest, const std::string& partMesh,
                 const std::string& environmentMesh);

}  // namespace clearway::cli
