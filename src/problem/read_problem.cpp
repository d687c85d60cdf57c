// Reads .cfg files: [problem], [benchmark] and [planner] as OMPL.app's benchmark program does, and clearway's
// own [clearway].
#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>

#include "clearway/problem.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "problem/config.h"
#include "problem/known_keys.h"
#include "problem/obstacle_rules.h"
#include "problem/planner_choices.h"
#include "problem/rotation.h"

namespace clearway {

namespace {

constexpr double kTurnRounding = 1e-4;  ///< of a turn: people write 2 pi as 6.2832

constexpr double kLargestCoordinate = 1e30;  ///< of poses and bounds: sums and floats still hold it

/// The mesh file's path: in the .cfg's folder or, with a warning, in the current folder. OMPL.app looks in
/// the current folder first; the order here keeps a problem from depending on the current folder.
std::string meshFile(const std::string& name, const std::string& config, std::vector<std::string>& warnings) {
    namespace fs = std::filesystem;
    const fs::path beside = fs::path(config).parent_path() / name;  // name itself when it is absolute
    std::error_code ignored;
    if (!fs::exists(beside, ignored) && fs::exists(name, ignored)) {
        warnings.push_back(config + ": " + quote(name) +
                           " is not in the problem's folder, read from the current folder");
        return name;
    }
    return beside.string();
}

bool exists(const std::string& name, const std::string& config) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    return fs::exists(fs::path(config).parent_path() / name, ignored) || fs::exists(name, ignored);
}

void requireEachOnce(const ConfigValues& values, const std::string& key,
                     const std::vector<std::string>& files) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (isSameFile(files[i], files[j]))
                values.refuse(key, "each file once, but " + files[i] + " stands twice");
        }
    }
}

/// Reads `world`. As in OMPL.app it is one file if it has no comma or if a file of this name exists;
/// otherwise it is a list.
void readWorlds(ConfigValues& values, Problem& problem) {
    const std::string key = "problem.world";
    problem.meshes.partNames = readNames(values, "clearway.part");
    const bool isAssembly = !problem.meshes.partNames.empty();
    if (isAssembly && !values.has(key)) {
        problem.meshes.world = problem.meshes.robot;
        return;
    }
    const std::string text = values.requiredText(key, "the environment's mesh file");
    std::vector<std::string> names = {text};
    const bool isList = text.find(',') != std::string::npos || (text.front() == '"' && text.back() == '"');
    if (isList && !exists(text, problem.file)) {
        const std::optional<std::vector<std::string>> split = splitNames(text);
        if (!split) values.refuse(key, "mesh files, separated by commas");
        names = *split;
    }
    for (std::string& name : names) name = meshFile(name, problem.file, problem.warnings);
    requireEachOnce(values, key, names);
    if (isAssembly) {
        const auto rest = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
            return isSameFile(name, problem.meshes.robot);
        });
        if (rest != names.end())
            *rest = problem.meshes.robot;
        else
            names.insert(names.begin(), problem.meshes.robot);
    }
    problem.meshes.world = names[0];
    problem.meshes.furtherWorlds.assign(names.begin() + 1, names.end());
}

/// SE(2) if no z or axis key is given, otherwise SE(3). If only some of these keys are given, reading the
/// states names the first missing key.
Space spaceOf(const ConfigValues& values) {
    for (const char* state : {"problem.start.", "problem.goal."}) {
        for (const char* key : {"z", "axis.x", "axis.y", "axis.z"}) {
            if (values.has(std::string(state) + key)) return Space::kSe3;
        }
    }
    return Space::kSe2;
}

double readCoordinate(ConfigValues& values, const std::string& key, const std::string& expected) {
    const double value = values.requiredNumber(key, expected);
    if (std::abs(value) > kLargestCoordinate)
        values.refuse(key, "a coordinate of at most " + shortNumber(kLargestCoordinate) + " in size");
    return value;
}

/// Reads theta, in radians, or its form in degrees. isClearways: the file has a section [clearway].
double readAngle(ConfigValues& values, const std::string& state, bool isClearways,
                 const std::string& expected, std::vector<std::string>& warnings) {
    const std::string theta = "problem." + state + ".theta", degrees = "clearway." + state + ".degrees";
    if (const std::optional<double> angle = values.number(degrees)) {
        if (values.has(theta)) values.refuse(degrees, "it or [problem] " + state + ".theta, not both");
        return *angle * M_PI / 180;
    }
    const std::string misplaced = "problem." + state + ".degrees";
    if (!values.has(theta) && values.has(misplaced))
        values.refuse(misplaced,
                      "this key in the section [clearway], or [problem] " + state + ".theta in radians");
    const double angle = values.requiredNumber(theta, expected);
    if (std::abs(angle) <= 2 * M_PI * (1 + kTurnRounding)) return angle;
    const std::string inDegrees = "[clearway] " + state + ".degrees = " + shortNumber(angle);
    if (isClearways) values.refuse(theta, "radians, at most 2 pi (degrees are written " + inDegrees + ")");
    warnings.push_back(values.placeOf(theta) + shown(theta) + " = " + shortNumber(angle) +
                       " is in radians, more than a turn; degrees are written " + inDegrees);
    return angle;
}

PartState readState(ConfigValues& values, const std::string& name, bool isClearways, Problem& problem) {
    const Space space = problem.space;
    const std::string prefix = "problem." + name + ".";
    const std::string expected =
        std::string(space == Space::kSe3
                        ? "x, y, z, axis.x, axis.y, axis.z and theta of start and goal (SE(2): "
                          "x, y and theta alone)"
                        : "x, y and theta of start and goal (SE(3): z, axis.x, axis.y and axis.z "
                          "too)") +
        (name == "goal" ? ", or [clearway] goal = outside" : "");
    const auto number = [&](const std::string& key) { return values.requiredNumber(prefix + key, expected); };
    const auto coordinate = [&](const std::string& key) {
        return readCoordinate(values, prefix + key, expected);
    };
    PartState state;
    AxisAngle rotation{Vector3::UnitZ(), 0};
    const int dimensions = space == Space::kSe3 ? 3 : 2;
    for (int i = 0; i < dimensions; ++i) state.position[i] = coordinate(kAxisNames[i]);
    if (space == Space::kSe3) {
        for (int i = 0; i < 3; ++i) rotation.axis[i] = number(std::string("axis.") + kAxisNames[i]);
    }
    rotation.angle = readAngle(values, name, isClearways, expected, problem.warnings);
    const std::optional<Rotation> quaternion = fromAxisAngle(rotation);
    if (!quaternion) values.refuse(prefix + "axis.x", "an axis (x, y, z) of length above 0");
    state.rotation = *quaternion;
    return state;
}

void readGoal(ConfigValues& values, bool isClearways, Problem& problem) {
    problem.goal = readState(values, "goal", isClearways, problem);
    problem.planning.goalThreshold = values.number("problem.threshold");
    if (problem.planning.goalThreshold && *problem.planning.goalThreshold < 0) {
        values.refuse("problem.threshold", "a number of at least 0");
    }
}

/// Empty if no key is given. Throws unless all keys of the space are given.
std::optional<Box> readVolume(ConfigValues& values, Space space) {
    const int dimensions = space == Space::kSe3 ? 3 : 2;
    bool any = false;
    for (int i = 0; i < dimensions; ++i) {
        any = any || values.has(std::string("problem.volume.min.") + kAxisNames[i]) ||
              values.has(std::string("problem.volume.max.") + kAxisNames[i]);
    }
    if (!any) return std::nullopt;
    Box volume(Vector3::Zero(), Vector3::Zero());
    for (int i = 0; i < dimensions; ++i) {
        const std::string expected = std::string("all of volume.min and volume.max ") +
                                     (dimensions == 3 ? "x, y, z" : "x, y") + " or none";
        const std::string low = std::string("problem.volume.min.") + kAxisNames[i];
        const std::string high = std::string("problem.volume.max.") + kAxisNames[i];
        volume.min()[i] = readCoordinate(values, low, expected);
        volume.max()[i] = readCoordinate(values, high, expected);
        if (!(volume.min()[i] < volume.max()[i])) {
            values.refuse(low, "less than " + keyOf(high) + " = " + shortNumber(volume.max()[i]));
        }
    }
    return volume;
}

std::optional<double> readPositive(ConfigValues& values, const std::string& name) {
    const std::optional<double> value = values.number(name);
    if (value && !(*value > 0)) values.refuse(name, "a number above 0");
    return value;
}

void readSettings(ConfigValues& values, Problem& problem) {
    for (const ConfigEntry& entry : values.unread()) {
        const std::string key = boost::to_lower_copy(keyOf(entry.name));
        if (sectionOf(entry.name) != "problem" || !isSetting(key)) continue;
        problem.planning.settings.emplace_back(key, *values.text(entry.name));
    }
}

/// Like OMPL.app, accepts every value that begins with one of the words.
SavedPaths readSavedPaths(ConfigValues& values) {
    const std::string name = "benchmark.save_paths";
    const std::string which = values.text(name).value_or("none");
    if (boost::starts_with(which, "none")) return SavedPaths::kNone;
    if (boost::starts_with(which, "all")) return SavedPaths::kAll;
    if (boost::starts_with(which, "shortest") || boost::starts_with(which, "best")) {
        return SavedPaths::kShortest;
    }
    values.refuse(name, "none, all, shortest or best");
}

void readBenchmark(ConfigValues& values, Problem& problem) {
    problem.benchmark.timeLimit = readPositive(values, "benchmark.time_limit");
    problem.benchmark.memoryLimit = readPositive(values, "benchmark.mem_limit");
    problem.benchmark.outputFolder = values.text("benchmark.output").value_or("");
    problem.benchmark.savedPaths = readSavedPaths(values);
    problem.benchmark.simplify = values.flag("benchmark.simplify").value_or(true);
    const std::string name = "benchmark.run_count";
    const std::optional<std::string> text = values.text(name);
    if (!text) return;
    constexpr std::int64_t kMostRuns = 1000000;
    const std::optional<std::int64_t> count = parseInteger(*text);
    if (!count || *count < 1 || *count > kMostRuns) values.refuse(name, "an integer from 1 to 1000000");
    problem.benchmark.runCount = static_cast<int>(*count);
}

std::string readUnit(ConfigValues& values) {
    const std::string key = "clearway.unit";
    const std::optional<std::string> unit = values.text(key);
    std::vector<std::string> names;
    for (const LengthUnit& known : lengthUnits()) names.push_back(known.name);
    if (unit && std::find(names.begin(), names.end(), *unit) == names.end())
        values.refuse(key, "one of " + joined(names) + didYouMean(*unit, names));
    return unit.value_or("");
}

/// Reads the deflection and the margin, which may be the word deflection: both surfaces, the part's and the obstacle's, may be as far
/// from their triangles.
void readMargin(ConfigValues& values, Problem& problem) {
    const std::string deflection = "clearway.deflection", margin = "clearway.margin";
    problem.deflection = values.number(deflection).value_or(0);
    if (!(problem.deflection >= 0)) values.refuse(deflection, "a number of at least 0");
    if (values.text(margin) == "deflection") {
        if (!values.has(deflection)) values.refuse(margin, "the key deflection beside it, or a number");
        problem.margin = 2 * problem.deflection;
        return;
    }
    problem.margin = values.number(margin).value_or(0);
    if (!(problem.margin >= 0)) values.refuse(margin, "a number of at least 0");
}

void readClearway(ConfigValues& values, bool isClearways, Problem& problem) {
    readMargin(values, problem);
    problem.rules = readObstacleRules(values);
    problem.fineness = readPositive(values, "clearway.fineness");
    if (const auto step = readPositive(values, "clearway.step")) {  // the key's older name
        if (problem.fineness) values.refuse("clearway.step", "only one of step and fineness");
        problem.fineness = step;
    }
    const std::string reading = "clearway.reading";
    const std::optional<std::string> how = values.text(reading);
    if (how && *how != "omplapp" && *how != "stored") values.refuse(reading, "omplapp or stored");
    problem.meshes.isReadingStated = how.has_value();
    problem.meshes.asOmplApp = how ? *how == "omplapp" : !isClearways;
    problem.meshes.partScale = readPositive(values, "clearway.robot.scale").value_or(1);
    problem.meshes.worldScale = readPositive(values, "clearway.world.scale").value_or(1);
    if (!problem.meshes.partNames.empty() && (problem.meshes.asOmplApp || !how))
        values.refuse("clearway.part", "reading = stored beside it: OMPL.app moves the part on reading");
    if (!problem.meshes.partNames.empty() && problem.meshes.partScale != problem.meshes.worldScale)
        values.refuse("clearway.part", "equal robot.scale and world.scale beside it: they read one file");
    problem.unit = readUnit(values);
}

/// Reads the goal `outside`. Empty when the goal is a pose. Keys of a goal's pose contradict it.
std::optional<Outside> readOutside(ConfigValues& values, Space space) {
    const std::string kind = "clearway.goal", which = "clearway.outside";
    const std::optional<std::string> goal = values.text(kind), side = values.text(which);
    if (goal && *goal != "outside")
        values.refuse(kind, "outside, or no such key where [problem] has the goal");
    if (side && !goal) values.refuse(which, "goal = outside beside it");
    if (!goal) return std::nullopt;
    for (const ConfigEntry& entry : values.unread()) {
        if (boost::starts_with(entry.name, "problem.goal.") || entry.name == "clearway.contact.goal" ||
            entry.name == "clearway.goal.degrees") {
            values.refuse(entry.name, "no such key together with [clearway] goal = outside");
        }
    }
    Outside outside;
    if (!side) return outside;
    outside.side = sideNamed(*side);
    const bool isSpatial = space == Space::kSe3;
    if (!outside.side || (!isSpatial && outside.side->axis == 2)) {
        values.refuse(which, isSpatial ? "+x, -x, +y, -y, +z or -z" : "+x, -x, +y or -y");
    }
    return outside;
}

}  // namespace

Problem readProblem(const std::string& file) {
    const ConfigFile config = readConfigFile(file);
    const std::vector<ConfigEntry>& entries = config.entries;
    ConfigValues values(file, entries, {"problem", "benchmark", "clearway"});
    Problem problem;
    problem.file = file;
    judgeSections(file, config, problem);
    problem.name = values.text("problem.name").value_or("");
    problem.meshes.robot =
        meshFile(values.requiredText("problem.robot", "the part's mesh file"), file, problem.warnings);
    readWorlds(values, problem);
    problem.space = spaceOf(values);
    const bool isClearways = config.hasSection("clearway");
    problem.start = readState(values, "start", isClearways, problem);
    problem.outside = readOutside(values, problem.space);
    if (!problem.outside) readGoal(values, isClearways, problem);
    problem.volume = readVolume(values, problem.space);
    problem.planning.objective = values.text("problem.objective").value_or(problem.planning.objective);
    problem.planning.objectiveThreshold = values.number("problem.objective.threshold");
    problem.planning.sampler = values.text("problem.sampler").value_or("");
    readSettings(values, problem);
    readBenchmark(values, problem);
    readClearway(values, isClearways, problem);
    readPlanners(file, entries, isClearways, problem);
    judgeUnread(file, isClearways, values, problem);
    return problem;
}

}  // namespace clearway
