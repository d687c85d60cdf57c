#include "program/options/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/text.h"
#include "model/obstacle_names.h"
#include "problem/clearance_word.h"

namespace clearway::cli {

namespace {

std::string& factsFile() {
    static std::string file;
    return file;
}

constexpr std::size_t kMostNames = 6;  ///< most names of obstacles in one row

const char* wordFor(planning::MotionVerdict verdict) {
    switch (verdict) {
        case planning::MotionVerdict::kValid:
            return "valid";
        case planning::MotionVerdict::kUndecided:
            return "undecided";
        default:
            return "invalid";
    }
}

Fact meshFact(const std::string& label, const Model& model) {
    const std::size_t leftOut = model.report().unreachableTriangles;
    return {label,
            fmt::format("{}, {}{}", model.origin().file, counted(model.report().triangles, "triangle"),
                        leftOut > 0 ? fmt::format(", {} out of range left out", leftOut) : ""),
            label, toJson(model)};
}

/// Obstacles that count alike. json: what is known of them beside how they count. The fact has no name, because it belongs in
/// a list.
template <class Group>
Fact obstacleFact(const std::vector<Component>& components, std::size_t triangles, double overlap,
                  const Group& group, Json json) {
    json["solid"] = group.solids != nullptr;
    json["ignored_near_start"] = group.isIgnoredAtStart;
    json["ignored_near_goal"] = group.isIgnoredAtGoal;
    std::vector<std::string> names;
    for (const Component& component : components) names.push_back(component.name);
    const bool atStart = group.isIgnoredAtStart, atGoal = group.isIgnoredAtGoal;
    const char* const where = atStart && atGoal ? ", ignored near the start and the goal"
                              : atStart         ? ", ignored near the start"
                              : atGoal          ? ", ignored near the goal"
                                                : "";
    const std::string rule = overlap > 0
                                 ? "overlap " + statedLength(overlap)
                                 : "margin " + statedLength(group.margin) + (group.solids ? ", solid" : "");
    return {
        "obstacle",
        fmt::format("{}: {}, {}{}", listed(names, kMostNames), counted(triangles, "triangle"), rule, where),
        "", std::move(json)};
}

}  // namespace

Json& facts() {
    static Json all = Json::object();
    return all;
}

void addJson(CommandLine& commandLine) {
    commandLine.option("--json FILE", "writes the facts as JSON; - is standard output, in place of the rows",
                       to(factsFile()));
}

void requireFactsFile(OutputFiles& files) {
    files.addOrStandardOutput("--json", factsFile());
}

void dropFacts() {
    factsFile().clear();
}

void writeFacts() {
    if (factsFile().empty()) return;
    writeOut(factsFile(), [](std::ostream& stream) {
        stream << facts().dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
    });
}

void tellProblem(const Problem& problem) {
    useUnit(problem.unit);
    facts()["problem"] = problem.file;
    facts()["unit"] = problem.unit.empty() ? Json() : Json(problem.unit);
    tellDeflection(problem.deflection, problem.margin >= 2 * problem.deflection);
}

void tellDeflection(double deflection, bool isInMargin) {
    useDeflection(deflection, isInMargin);
    facts()["deflection"] = deflection > 0 ? Json(deflection) : Json();
}

Fact kept(const std::string& name, Json value) {
    return {"", "", name, std::move(value)};
}

Fact shownIf(bool isShown, Fact fact) {
    if (!isShown) fact.label.clear();
    return fact;
}

Rows rowsOf(const Facts& table) {
    Rows rows;
    for (const Fact& fact : table) {
        if (!fact.label.empty()) rows.push_back({fact.label, fact.shown});
    }
    return rows;
}

Json toJson(const Facts& table) {
    Json json = Json::object();
    for (const Fact& fact : table) {
        if (!fact.name.empty()) json[fact.name] = fact.value;
    }
    return json;
}

void tell(const Facts& table) {
    printRows(rowsOf(table));
    facts().update(toJson(table));
}

std::string movingNames(const Problem& problem, const Model& part) {
    if (problem.meshes.partNames.empty()) return "";
    std::vector<std::string> names;
    for (const Component& component : part.components()) names.push_back(component.name);
    return listed(names, kMostNames) + " of ";
}

void tellScene(const Problem& problem, const Scene& scene) {
    const bool isPlain = scene.obstacles.size() == 1 && !scene.obstacles[0].solids && !scene.startContact &&
                         !scene.goalContact && scene.ignoredBox.isEmpty();
    Fact part = meshFact("part", scene.part);
    part.shown = movingNames(problem, scene.part) + part.shown;
    for (const Component& component : scene.part.components()) part.value["names"].push_back(component.name);
    tell({part});
    Json& obstacles = facts()["obstacles"] = Json::array();
    for (const Obstacle& obstacle : scene.obstacles) {
        Fact fact = meshFact("environment", obstacle.model);
        printRow(fact.label, fact.shown);
        const std::vector<Component>& components = obstacle.model.components();
        for (const Component& component : components) fact.value["names"].push_back(component.name);
        fact.value["margin"] = toJson(obstacle.margin);
        if (obstacle.overlap() > 0) fact.value["overlap"] = toJson(obstacle.overlap());
        fact = obstacleFact(components, obstacle.model.report().triangles, obstacle.overlap(), obstacle,
                            fact.value);
        if (!isPlain) printRow(fact.label, fact.shown);
        obstacles.push_back(fact.value);
    }
    if (scene.obstacles.empty()) printRow("environment", "every obstacle is ignored");
    printRow("margin", (scene.obstacles.size() == 1 ? "" : "by obstacle, at most ") +
                           statedLength(scene.largestMargin()));
    if (scene.startContact) printRow("contact at start", statedLength(scene.startContact->distance));
    if (scene.goalContact) printRow("contact at goal", statedLength(scene.goalContact->distance));
}

void tellObstacles(const ObstacleGroups& obstacles) {
    Json& all = facts()["obstacles"] = Json::array();
    for (const ObstacleGroup& group : obstacles.groups) {
        const Fact fact =
            obstacleFact(group.mesh.components, group.mesh.triangles.size(), group.overlap, group,
                         {{"components", toJson(group.mesh.components)},
                          {"triangles", group.mesh.triangles.size()},
                          {"margin", toJson(group.margin)},
                          {"overlap", toJson(group.overlap)}});
        printRow(fact.label, fact.shown);
        all.push_back(fact.value);
    }
    for (const std::string& name : obstacles.ignored) printRow("ignored", "'" + name + "'");
    for (const std::string& note : obstacles.notes) printRow("note", note);
}

Json toJson(const std::vector<Component>& components) {
    Json json = Json::array();
    for (const Component& component : components)
        json.push_back({{"name", component.name}, {"triangles", component.triangleCount}});
    return json;
}

Json toJson(double number) {
    return std::isfinite(number) ? Json(number + 0.0) : Json();  // -0 + 0 is 0
}

Json toJson(const Vector3& point) {
    return {toJson(point.x()), toJson(point.y()), toJson(point.z())};
}

Json toJson(const Box& box) {
    return {{"min", toJson(Vector3(box.min()))}, {"max", toJson(Vector3(box.max()))}};
}

Json toJson(const PartState& state) {
    const auto& q = state.rotation;
    return {{"position", toJson(state.position)},
            {"quaternion_xyzw", {toJson(q.x()), toJson(q.y()), toJson(q.z()), toJson(q.w())}}};
}

Json toJson(const Pose& pose) {
    const Eigen::Quaterniond q(pose.rotation);
    return {{"position", toJson(pose.translation)},
            {"quaternion_xyzw", {toJson(q.x()), toJson(q.y()), toJson(q.z()), toJson(q.w())}}};
}

Json toJson(const Model& model) {
    Json json = {{"file", model.origin().file},
                 {"reading", readingWord(model.origin())},
                 {"triangles", model.report().triangles}};
    if (model.report().unreachableTriangles > 0) json["left_out"] = model.report().unreachableTriangles;
    return json;
}

Json toJson(const planning::PathAudit& audit, const Scene& scene) {
    const char* const clearance = clearanceWord(scene);
    Json json = {
        {"verdict", wordFor(audit.verdict)},
        {"length", toJson(audit.length)},
        {"rotation_degrees", toJson(audit.rotation * 180 / M_PI)},
        {clearance, {{"lower", toJson(audit.lowerClearance)}, {"upper", toJson(audit.upperClearance)}}}};
    const planning::SegmentAudit& closest = audit.segments[audit.closest];
    json["closest"] = {
        {"segment", audit.closest + 1},
        {"t", toJson(closest.motion.closestTime)},
        {"pose", toJson(closest.X_environmentPart)},
        {"pair", closestPair(closest.motion.closest, closest.partMesh, closest.environmentMesh)}};
    for (const planning::SegmentAudit& segment : audit.segments) {
        const planning::MotionReport& motion = segment.motion;
        json["segments"].push_back(
            {{"verdict", wordFor(motion.verdict)},
             {"kind", nameOf(motion.whyInvalid.kind)},
             {"trouble", motion.whyInvalid.words()},
             {"valid_until_t", toJson(motion.certifiedTime)},
             {"length", toJson(segment.length)},
             {"rotation_degrees", toJson(segment.rotation * 180 / M_PI)},
             {clearance,
              {{"lower", toJson(motion.lowerClearance)}, {"upper", toJson(motion.upperClearance)}}},
             {"closest_t", toJson(motion.closestTime)},
             {"pair", closestPair(motion.closest, segment.partMesh, segment.environmentMesh)}});
    }
    return json;
}

Json closestPair(const SceneDistance& closest, const std::string& partMesh,
                 const std::string& environmentMesh) {
    if (!closest.witness) return nullptr;
    return {{"part",
             {{"mesh", partMesh},
              {"triangle", closest.witness->partTriangle},
              {"point", toJson(closest.witness->pointOnPart)}}},
            {"environment",
             {{"mesh", environmentMesh},
              {"triangle", closest.witness->environmentTriangle},
              {"point", toJson(closest.witness->pointOnEnvironment)}}}};
}

}  // namespace clearway::cli
