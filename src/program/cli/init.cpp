// clearway init: writes a problem file for two meshes or more, and says what it saw in them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "mesh/check.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"
#include "model/obstacle_names.h"
#include "problem/config.h"
#include "problem/obstacle_rules.h"
#include "problem/start_remedies.h"
#include "program/cli/enclosure.h"
#include "program/cli/from_cad.h"
#include "program/cli/lift.h"
#include "program/cli/overlaps.h"
#include "program/options/facts.h"
#include "program/options/load_guard.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNamed = 6;  ///< obstacles in one row
constexpr double kRoom = 1.25;         ///< of the part's diagonal, around both meshes: so it can turn outside
constexpr std::size_t kValueColumn = 34;  ///< where the comments begin

struct InitArguments {
    std::string part, out;
    std::vector<std::string> environment;
    std::vector<std::string> partNames;  ///< of --part; the first file is then an assembly
    Rows made{};                         ///< meshes of STEP and IGES files
    std::string moves{};                 ///< the names of the parts that move, for people
};

/// Makes the first file with a part named the part's, and all files the environment's, but for one that moves alone and as a whole. Keeps the
/// names unless it does so.
void takePartsOut(InitArguments& given) {
    std::vector<std::string> files = assemblyFiles(given.part);
    files.insert(files.end(), given.environment.begin(), given.environment.end());
    std::vector<Mesh> meshes;
    for (const std::string& file : files) meshes.push_back(guardedLoadMesh(file, {}));
    const ObstacleNames names(meshes);
    std::set<std::size_t> moving, movingFiles;
    for (const std::string& name : given.partNames) {
        for (const std::size_t component : names.find("--part", name)) {
            moving.insert(component);
            movingFiles.insert(names.components()[component].file);
        }
    }
    if (moving.size() == names.components().size())
        throw std::invalid_argument("--part names all parts of '" + given.part +
                                    "', expected one that stands still");
    std::vector<std::string> moves;
    for (const std::size_t component : moving) moves.push_back(names.components()[component].name);
    given.moves = listed(moves, kMostNamed);
    const std::size_t file = *movingFiles.begin();
    given.part = files[file];
    given.environment = files;
    const auto isInFile = [&](const ObstacleNames::Component& component) { return component.file == file; };
    const auto all = std::count_if(names.components().begin(), names.components().end(), isInFile);
    if (movingFiles.size() == 1 && moving.size() == static_cast<std::size_t>(all)) {
        given.partNames.clear();
        given.environment.erase(given.environment.begin() + static_cast<std::ptrdiff_t>(file));
    }
    if (!given.partNames.empty()) namesOf("--part", given.partNames);  // refused before anything is said
}

bool readArguments(const Arguments& words, InitArguments& given) {
    CommandLine line(
        "clearway init PART ENVIRONMENT... --out PROBLEM.cfg",
        "Writes a problem file for a part and the meshes around it, with a comment beside each key. The "
        "part\n"
        "starts where its file puts it, and the goal is anywhere outside: on the far side, if the part "
        "starts\n"
        "outside. Says what it saw in the meshes.\n"
        "With --part, the first file is an assembly, or a folder of mesh files: the parts named move, all "
        "others stand still.");
    line.argument("PART", to(given.part));
    line.argument("[ENVIRONMENT...]", appendedTo(given.environment));
    line.option(
        "--part NAME",
        "a part of the assembly that moves, or several by wildcards; may be repeated; they move as one",
        appendedTo(given.partNames), CommandLine::Count::kRepeatable);
    line.option("--out FILE", "the problem file, .cfg", to(given.out), CommandLine::Count::kRequired);
    addJson(line);
    if (!line.parse(words)) return false;
    if (given.partNames.empty() && given.environment.empty()) {
        throw std::invalid_argument(
            "no ENVIRONMENT, expected: clearway init PART ENVIRONMENT... --out PROBLEM.cfg, or --part NAME "
            "for a "
            "part of an assembly");
    }
    OutputFiles files({});
    files.add("--out", given.out, {".cfg"});  // refused before a mesh is made
    std::vector<std::string*> meshes = {&given.part};
    for (std::string& file : given.environment) meshes.push_back(&file);
    given.made = makeMeshesOfCad(meshes, given.out);
    if (!given.partNames.empty()) takePartsOut(given);
    return true;
}

/// A number as people write it, rounded up to four digits if `up`, else down.
std::string rounded(double value, bool up) {
    return shortNumber(up == (value > 0) ? awayFromZero(value, 4) : towardsZero(value, 4));
}

/// "1234 triangles, closed, 120 x 40 x 35"
Fact meshFact(const std::string& label, const Mesh& mesh) {
    const EdgeReport edges = checkEdges(clean(mesh).triangles);
    const bool isClosed = edges.isClosed() && edges.closedEdges > 0;
    const Vector3 size = boundingBox(mesh).sizes();
    return {label,
            fmt::format("{}, {}, {} x {} x {}", counted(mesh.triangles.size(), "triangle"),
                        isClosed ? "closed" : "open", rounded(size.x(), true), rounded(size.y(), true),
                        rounded(size.z(), true)),
            label,
            {{"reading", readingWord(mesh.origin)},
             {"triangles", mesh.triangles.size()},
             {"closed", isClosed},
             {"box", toJson(boundingBox(mesh))}}};
}

std::string clearanceAtStart(const Scene& scene) {
    const SceneClearance clearance(scene);
    const SceneDistance nearest = clearance.distance({});
    facts()["clearance_at_start"] = toJson(nearest.lower);
    return fmt::format("free, {} from '{}'", readable(nearest.distance),
                       meshNames(scene, nearest).environment);
}

class ProblemText {
  public:
    void comment(const std::string& text) { text_ += "# " + text + "\n"; }
    void section(const std::string& name) { text_ += "\n[" + name + "]\n"; }
    void line(const std::string& key, const std::string& value, const std::string& about,
              const std::string& before = "") {
        std::string line = before + key + " = " + value;
        if (!about.empty())
            line +=
                std::string(line.size() < kValueColumn ? kValueColumn - line.size() : 1, ' ') + "# " + about;
        text_ += line + "\n";
    }
    /// A line that counts once its first "# " is taken out.
    void choice(const std::string& key, const std::string& value, const std::string& about) {
        line(key, value, about, "# ");
    }
    const std::string& str() const { return text_; }

  private:
    std::string text_;
};

/// The file's name as the problem file holds it. Throws if that cannot hold it.
std::string relativeTo(const std::string& config, const std::string& file) {
    const fs::path folder = fs::absolute(config).parent_path();
    const std::string name =
        fs::absolute(file).lexically_normal().lexically_proximate(folder.lexically_normal()).string();
    if (name.find_first_of("#\"\n\r") != std::string::npos || trimmed(name) != name) {
        throw std::invalid_argument("mesh file is '" + name +
                                    "', expected a name without # (which begins a comment in problem files), "
                                    "quotes, line breaks and white space at its ends");
    }
    return name;
}

/// The side of the surroundings where the part is not, as problem files name sides, and the one where it is.
struct FarSide {
    std::string far, near;
};

/// Nothing when the boxes touch. Where the part is outside along several axes, the widest gap decides.
std::optional<FarSide> farSideOf(const Box& part, const Box& environment) {
    std::optional<FarSide> side;
    double widest = 0;
    for (int i = 0; i < 3; ++i) {
        const double below = environment.min()[i] - part.max()[i],
                     above = part.min()[i] - environment.max()[i];
        if (std::max(below, above) <= widest) continue;
        widest = std::max(below, above);
        const std::string minus = std::string("-") + kAxisNames[i], plus = std::string("+") + kAxisNames[i];
        side = below > above ? FarSide{plus, minus} : FarSide{minus, plus};
    }
    return side;
}

struct Seen {
    std::string part, environment;  ///< what they hold
    Box bounds;
    std::vector<std::string> touched;
    std::vector<StartRemedy> remedies;  ///< of what is touched
    std::optional<FarSide> farSide;     ///< of the surroundings, when the part starts outside of them
    std::string unit;       ///< that all files state; empty when one of them states none, or another
    bool isTurned;          ///< whether assimp turned a mesh
    double deflection = 0;  ///< the largest that a file states
};

/// The unit that all of the meshes state, as problem files name it.
std::string commonUnit(const std::vector<Mesh>& meshes) {
    for (const LengthUnit& unit : lengthUnits()) {
        const bool isCommon = std::all_of(meshes.begin(), meshes.end(), [&](const Mesh& mesh) {
            return std::abs(mesh.origin.unitMetres - unit.metres) <= 1e-9 * unit.metres;
        });
        if (isCommon) return unit.name;
    }
    return "";
}

/// Warns when two files state different units.
void warnOfUnits(const std::vector<Mesh>& meshes) {
    const Mesh* first = nullptr;
    for (const Mesh& mesh : meshes) {
        const double metres = mesh.origin.unitMetres;
        if (metres == 0) continue;
        if (!first) first = &mesh;
        if (std::abs(metres - first->origin.unitMetres) <= 1e-9 * metres) continue;
        printWarnings({"'" + first->origin.file + "' states the unit " + unitName(first->origin.unitMetres) +
                       " and '" + mesh.origin.file + "' the unit " + unitName(metres) +
                       "; robot.scale and world.scale in [clearway] are factors for their coordinates"});
    }
}

std::string textOf(const InitArguments& given, const Seen& seen) {
    ProblemText text;
    text.comment("A problem for clearway: clearway plan '" + fs::path(given.out).filename().string() +
                 "' --path out.path");
    text.section("problem");
    const std::string robot = relativeTo(given.out, given.part);
    text.line("robot", robot, "the part: " + seen.part);
    std::vector<std::string> worlds;
    for (const std::string& file : given.environment) worlds.push_back(relativeTo(given.out, file));
    const std::optional<std::string> written = writtenNames(worlds);
    text.line("world", written.value(), "what stands still: " + seen.environment);
    text.comment(
        "The start: where the files put the part. Its position, and the axis and angle of its rotation.");
    for (const char* axis : kAxisNames) text.line(std::string("start.") + axis, "0", "");
    for (const char* axis : kAxisNames)
        text.line(std::string("start.axis.") + axis, axis == std::string("z") ? "1" : "0", "");
    text.line("start.theta", "0", "radians; or start.degrees in [clearway]");
    text.comment("A goal pose, in place of goal = outside below:");
    text.comment("goal.x = 0, and so on, the keys that start has");
    text.comment(
        "The bounds: on its way, the part's origin, the point (0, 0, 0) of its file, stays in this box.");
    text.comment(
        "It holds all meshes, and room to turn the part beside them. A smaller box is searched faster and");
    text.comment("keeps the part out of places; one that is too small leaves no way.");
    for (int i = 0; i < 3; ++i)
        text.line(std::string("volume.min.") + kAxisNames[i], rounded(seen.bounds.min()[i], false), "");
    for (int i = 0; i < 3; ++i)
        text.line(std::string("volume.max.") + kAxisNames[i], rounded(seen.bounds.max()[i], true), "");
    text.section("clearway");
    if (seen.unit.empty()) {
        text.choice("unit", "mm",
                    "the unit of all lengths here, um, mm, cm, m, km, in or ft: shown beside them");
    } else {
        text.line("unit", seen.unit, "the unit that the files state; shown beside all lengths here");
    }
    if (!given.partNames.empty())
        text.line("part", namesOf("part", given.partNames), "what moves as one; all other parts stand still");
    text.line("reading", "stored",
              std::string("coordinates as the files hold them") +
                  (seen.isTurned ? ", but for what assimp turns" : ""));
    text.line("goal", "outside", "any pose at which the boxes of part and surroundings are apart");
    if (seen.farSide) {
        text.line("outside", seen.farSide->far,
                  "on this side; the part starts outside on " + seen.farSide->near);
    } else {
        text.choice("outside", "+z", "on this side only; +x, -x, +y, -y, +z or -z");
    }
    const bool hasDeflection = seen.deflection > 0;
    text.line("margin", "0",
              std::string("distance to keep from everything") +
                  (hasDeflection ? "; the word deflection: 2 x deflection, once for each surface" : ""));
    if (hasDeflection)
        text.line("deflection", shortNumber(seen.deflection),
                  "how far triangles may be from the CAD surfaces, as the files say");
    if (!seen.touched.empty()) {
        text.comment(
            "The part touches other meshes at its start. If they are assembled so, choose one of these:");
        for (const StartRemedy& remedy : seen.remedies) {
            text.choice(remedy.key, remedy.value, remedy.effect);
        }
    }
    return text.str();
}

}  // namespace

int init(const Arguments& words) {
    InitArguments given;
    if (!readArguments(words, given)) return kDone;
    std::vector<std::string> inputs = given.environment;
    if (std::find(inputs.begin(), inputs.end(), given.part) == inputs.end()) inputs.push_back(given.part);
    if (given.out.find_first_of("\n\r") != std::string::npos)
        throw std::invalid_argument("--out is '" + given.out + "', expected a name without line breaks");
    for (const std::string& file : inputs) relativeTo(given.out, file);  // refused before anything is said
    OutputFiles files(inputs);
    files.add("--out", given.out, {".cfg"});
    requireFactsFile(files);
    printRows(given.made);

    Problem problem;
    problem.meshes.asOmplApp = false;
    problem.meshes.robot = given.part;
    problem.meshes.world = given.environment[0];
    problem.meshes.furtherWorlds.assign(given.environment.begin() + 1, given.environment.end());
    problem.meshes.partNames = given.partNames;
    problem.outside.emplace();
    ProblemScenes scenes(problem, {});
    const Mesh& part = scenes.meshes().part;
    const std::vector<Mesh>& worlds = scenes.meshes().worlds;
    const Mesh environment = joinedEnvironment(worlds);
    std::vector<Mesh> meshes = worlds;
    meshes.push_back(part);

    Seen seen;
    seen.unit = commonUnit(meshes);
    seen.isTurned = std::any_of(meshes.begin(), meshes.end(),
                                [](const Mesh& mesh) { return !turnedByAssimp(mesh.origin).empty(); });
    for (const Mesh& mesh : meshes) seen.deflection = std::max(seen.deflection, deflectionOf(mesh));
    const Fact partFact = meshFact("part", part), environmentFact = meshFact("environment", environment);
    seen.part = partFact.shown;
    seen.environment = environmentFact.shown;
    seen.bounds = boundingBox(environment);
    seen.bounds.extend(boundingBox(part));
    seen.bounds.extend(Vector3::Zero());
    const Vector3 farthest = boundingBox(part).min().cwiseAbs().cwiseMax(boundingBox(part).max().cwiseAbs());
    const Vector3 room = Vector3::Constant(kRoom * farthest.norm());
    seen.bounds = Box(seen.bounds.min() - room, seen.bounds.max() + room);
    seen.farSide = farSideOf(boundingBox(part), boundingBox(environment));
    const Scene scene = scenes.wholeScene(problem);
    seen.touched = touchedObstacles(scene, Pose());
    const double contactLength = kUsualContact * boundingBox(part).diagonal().norm();
    seen.remedies = startRemedies(problem, seen.touched, contactLength, true);

    if (const std::string note = unitNote(boundingBox(part), boundingBox(environment), ""); !note.empty())
        printWarnings(
            {note + " robot.scale and world.scale in [clearway] are factors for their coordinates"});
    for (const Mesh& mesh : meshes) printWarnings(mesh.origin.warnings);
    warnOfUnits(meshes);
    if (!given.moves.empty()) printRow("moves", given.moves);
    tell({kept("problem", given.out), partFact, environmentFact, kept("touched_at_start", seen.touched)});
    tellDeflection(seen.deflection);
    if (seen.touched.empty()) {
        printRow("start", clearanceAtStart(scene));
        printRows(deflectionRows());
    } else {
        printRow("start", "touches " + listed(seen.touched, kMostNamed) +
                              startAdvice(problem, seen.touched, contactLength, true));
        const std::optional<Lift> lift = tellLiftIfAny(problem, scenes);
        for (StartRemedy& remedy : seen.remedies) {
            if (lift && remedy.key == "overlap") remedy.value = depthText(lift->tryFirst);
        }
    }
    if (const std::string note = EnclosureNotes(problem, scenes.meshes()).at({}); !note.empty())
        printWarnings({"at the start " + note});
    printRow("goal", !seen.farSide ? "outside"
                                   : "outside on " + seen.farSide->far + "; the part starts outside on " +
                                         seen.farSide->near);
    const std::string text = textOf(given, seen);
    const std::optional<std::string> old = setAside(given.out);
    replaceFile(given.out, [&](std::ostream& stream) { stream << text; });
    printRow("problem", given.out + (old ? "; the old one is now " + *old : ""));
    return kDone;
}

}  // namespace clearway::cli
