// Writes a problem so that readProblem reads it back to equal values.
#include <fmt/format.h>
#include <cmath>
#include <filesystem>
#include <optional>
#include <ostream>
#include <sstream>

#include "clearway/errors.h"
#include "clearway/problem.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "problem/config.h"
#include "problem/obstacle_rules.h"
#include "problem/outside.h"
#include "problem/rotation.h"

namespace clearway {

namespace {

/// Refuses keys that a reader would change: readers trim white space and split keys at the dot.
void requireWritableKey(const std::string& what, const std::string& key, const std::string& forbidden) {
    if (!key.empty() && trimmed(key) == key && key.find_first_of(forbidden) == std::string::npos) return;
    throw ArgumentError(what + " is " + quote(key) + ", expected text without any of " +
                        forbidden.substr(0, forbidden.find('\n')) + ", line ends or white space at its ends");
}

/// Collects key = value lines. Throws ArgumentError naming the key of a line that could not be read
/// back.
class ConfigText {
  public:
    void section(const std::string& name) { text_ << (text_.tellp() > 0 ? "\n[" : "[") << name << "]\n"; }

    void line(const std::string& key, const std::string& value) {
        if (trimmed(value) != value || value.find_first_of("#\n\r") != std::string::npos) {
            throw ArgumentError(key + " is " + quote(value) +
                                ", expected text without #, line ends or white space at its ends");
        }
        text_ << key << (value.empty() ? " =" : " = ") << value << "\n";
    }

    /// Adds a line with names that are already in quotes where necessary.
    void quotedLine(const std::string& key, const std::string& value) {
        text_ << key << " = " << value << "\n";
    }

    void line(const std::string& key, double value) {
        if (!std::isfinite(value)) {
            throw ArgumentError(key + " is " + formatNumber(value) + ", expected a finite number");
        }
        line(key, formatNumber(value));
    }

    void vector(const std::string& key, const Vector3& value, int dimensions) {
        for (int i = 0; i < dimensions; ++i) line(key + "." + kAxisNames[i], value[i]);
    }

    std::string str() const { return text_.str(); }

  private:
    std::ostringstream text_;
};

void writeState(ConfigText& text, const std::string& name, const PartState& state, Space space) {
    text.vector(name, state.position, space == Space::kSe3 ? 3 : 2);
    if (space == Space::kSe2) return text.line(name + ".theta", yawOf(state.rotation));
    const AxisAngle rotation = toAxisAngle(state.rotation);
    text.vector(name + ".axis", rotation.axis, 3);
    text.line(name + ".theta", rotation.angle);
}

std::string relativeTo(const std::string& folder, const std::string& mesh) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path name = fs::proximate(mesh, folder.empty() ? fs::path(".") : fs::path(folder), failed);
    if (!failed) return name.generic_string();
    throw FileError(
        fmt::format("cannot name the mesh '{}' from the folder '{}': {}, expected paths that can be followed",
                    mesh, folder, failed.message()));
}

std::string writtenWorlds(const Problem& problem, const std::string& folder) {
    std::vector<std::string> names;
    for (const std::string& file : worldFiles(problem)) names.push_back(relativeTo(folder, file));
    const std::string& only = names[0];
    const bool isPlain =
        only.empty() || (only.find(',') == std::string::npos && (only.front() != '"' || only.back() != '"'));
    if (names.size() == 1 && isPlain) return only;
    const std::optional<std::string> written = writtenNames(names);
    if (written) return *written;
    throw ArgumentError("world is " + quote(only) + ", expected a name without quotes");
}

/// what: a description of the texts, for the message when a key cannot be written.
void writeTexts(ConfigText& text, const std::string& what, const std::string& prefix,
                const NamedTexts& texts) {
    for (const auto& [key, value] : texts) {
        requireWritableKey(what, key, "#=\n\r");
        text.line(prefix + key, value);
    }
}

void writeProblemSection(ConfigText& text, const Problem& problem, const std::string& folder) {
    const int dimensions = problem.space == Space::kSe3 ? 3 : 2;
    text.section("problem");
    if (!problem.name.empty()) text.line("name", problem.name);
    text.line("robot", relativeTo(folder, problem.meshes.robot));
    text.line("world", writtenWorlds(problem, folder));
    writeState(text, "start", problem.start, problem.space);
    if (!problem.outside) writeState(text, "goal", problem.goal, problem.space);
    if (problem.volume) {
        text.vector("volume.min", problem.volume->min(), dimensions);
        text.vector("volume.max", problem.volume->max(), dimensions);
    }
    text.line("objective", problem.planning.objective);
    if (problem.planning.objectiveThreshold)
        text.line("objective.threshold", *problem.planning.objectiveThreshold);
    if (problem.planning.goalThreshold && !problem.outside)
        text.line("threshold", *problem.planning.goalThreshold);
    if (!problem.planning.sampler.empty()) text.line("sampler", problem.planning.sampler);
    writeTexts(text, "a setting of the problem", "", problem.planning.settings);
}

void writeBenchmarkSection(ConfigText& text, const Problem& problem) {
    const bool savesPaths = problem.benchmark.savedPaths != SavedPaths::kNone;
    if (!problem.benchmark.timeLimit && !problem.benchmark.memoryLimit && !problem.benchmark.runCount &&
        problem.benchmark.outputFolder.empty() && !savesPaths && problem.benchmark.simplify) {
        return;
    }
    text.section("benchmark");
    if (problem.benchmark.timeLimit) text.line("time_limit", *problem.benchmark.timeLimit);
    if (problem.benchmark.memoryLimit) text.line("mem_limit", *problem.benchmark.memoryLimit);
    if (problem.benchmark.runCount) text.line("run_count", std::to_string(*problem.benchmark.runCount));
    if (!problem.benchmark.outputFolder.empty()) text.line("output", problem.benchmark.outputFolder);
    if (savesPaths) {
        text.line("save_paths",
                  std::string(problem.benchmark.savedPaths == SavedPaths::kAll ? "all" : "shortest"));
    }
    if (!problem.benchmark.simplify) text.line("simplify", std::string("0"));
}

void writePlannerSection(ConfigText& text, const Problem& problem) {
    if (problem.planning.planners.empty()) return;
    text.section("planner");
    for (const PlannerChoice& planner : problem.planning.planners) {
        requireWritableKey("a planner's name", planner.name, "#=[.\n\r");
        text.line(planner.name, std::string());
        writeTexts(text, "a parameter of planner " + quote(planner.name), planner.name + ".",
                   planner.parameters);
        writeTexts(text, "a setting for planner " + quote(planner.name), "problem.", planner.settings);
    }
}

void writeClearwaySection(ConfigText& text, const Problem& problem) {
    text.section("clearway");
    if (problem.outside) {
        requireNoGoalContact(problem);
        text.line("goal", std::string("outside"));
        if (problem.outside->side) text.line("outside", nameOf(*problem.outside->side));
    }
    text.line("margin", problem.margin);
    if (problem.deflection != 0) text.line("deflection", problem.deflection);
    for (const auto& [key, value] : writtenRules(problem.rules)) text.quotedLine(key, value);
    if (problem.fineness) text.line("fineness", *problem.fineness);
    if (!problem.unit.empty()) text.line("unit", problem.unit);
    if (!problem.meshes.partNames.empty()) text.quotedLine("part", namesOf("part", problem.meshes.partNames));
    if (problem.meshes.partScale != 1) text.line("robot.scale", problem.meshes.partScale);
    if (problem.meshes.worldScale != 1) text.line("world.scale", problem.meshes.worldScale);
    if (problem.meshes.isReadingStated || problem.meshes.asOmplApp)
        text.line("reading", std::string(problem.meshes.asOmplApp ? "omplapp" : "stored"));
}

}  // namespace

void writeProblem(const Problem& problem, const std::string& file) {
    ConfigText text;
    writeProblemSection(text, problem, std::filesystem::path(file).parent_path().string());
    writeBenchmarkSection(text, problem);
    writePlannerSection(text, problem);
    writeClearwaySection(text, problem);
    replaceFile(file, [&](std::ostream& stream) { stream << text.str(); });
}

}  // namespace clearway
