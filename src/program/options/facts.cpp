#include "program/options/facts.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "program/options/print.h"

namespace clearway::cli {

namespace {

std::string& factsFile() {
    static std::string file;
    return file;
}

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
}

void tellScene(const Scene& scene) {
    facts()["part"] = toJson(scene.part);
    facts()["obstacles"] = Json::array();
    for (const Obstacle& obstacle : scene.obstacles) {
        Json json = toJson(obstacle.model);
        for (const Component& component : obstacle.model.components())
            json["names"].push_back(component.name);
        json["margin"] = toJson(obstacle.margin);
        if (obstacle.shrunk) {
            json["overlap"] = toJson(obstacle.shrunk->overlap);
            json["overlap_tolerance"] = toJson(obstacle.shrunk->tolerance);
        }
        json["solid"] = obstacle.solids != nullptr;
        json["ignored_near_start"] = obstacle.isIgnoredAtStart;
        json["ignored_near_goal"] = obstacle.isIgnoredAtGoal;
        facts()["obstacles"].push_back(json);
    }
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

Json toJson(const planning::PathAudit& audit) {
    Json json = {
        {"verdict", wordFor(audit.verdict)},
        {"length", toJson(audit.length)},
        {"turned_degrees", toJson(audit.turned * 180 / M_PI)},
        {"clearance", {{"lower", toJson(audit.lowerClearance)}, {"upper", toJson(audit.upperClearance)}}}};
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
             {"turned_degrees", toJson(segment.turned * 180 / M_PI)},
             {"clearance",
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
