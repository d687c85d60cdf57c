#include "program/cli/info_facts.h"

#include <nlohmann/json.hpp>

#include "mesh/topology.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

template <class Number>
Json orNull(const std::optional<Number>& number) {
    return number ? Json(*number) : Json();
}

Json namesIn(const NamedTexts& texts) {
    Json json = Json::object();
    for (const auto& [name, value] : texts) json[name] = value;
    return json;
}

Json componentFacts(const std::vector<Component>& components) {
    Json json = Json::array();
    for (const Component& component : components)
        json.push_back({{"name", component.name}, {"triangles", component.triangleCount}});
    return json;
}

Json treeFacts(const BuildReport& report) {
    const TreeStatistics& tree = report.tree;
    return {{"general_split", report.options.generalSplit},
            {"leaf_split", report.options.leafSplit},
            {"leaf_size", report.options.leafSize},
            {"nodes", tree.nodes},
            {"mean_children", toJson(tree.meanChildren)},
            {"leaves", tree.leaves},
            {"leaves_by_size", tree.leavesBySize},
            {"depth", tree.depth},
            {"bytes", tree.bytes},
            {"build_seconds", toJson(report.seconds)},
            {"triangles", report.triangles},
            {"out_of_reach", report.unreachableTriangles}};
}

Json contactFacts(const std::optional<ContactRule>& contact) {
    if (!contact) return nullptr;
    return {{"obstacles", contact->names}, {"distance", toJson(contact->distance)}};
}

}  // namespace

Json meshFacts(const Mesh& mesh, const CleanMesh& cleaned, const Model& model) {
    const MeshOrigin& origin = mesh.origin;
    const EdgeReport edges = checkEdges(cleaned.triangles);
    const CleanReport& report = cleaned.report;
    return {{"file", origin.file},
            {"scale", toJson(origin.scale)},
            {"shift", toJson(origin.shift)},
            {"format", origin.format},
            {"reading", readingWord(origin)},
            {"unit_stated", origin.unitMetres > 0 ? Json(unitName(origin.unitMetres)) : Json()},
            {"up_axis_stated", origin.upAxis != 0 ? Json(std::string(1, origin.upAxis)) : Json()},
            {"notes", origin.notes},
            {"faces_left_out", origin.ignoredFaces},
            {"faces_that_cross_themselves", origin.crossingFaces},
            {"faces_not_flat", origin.bentFaces},
            {"box", toJson(boundingBox(mesh))},
            {"triangles", mesh.triangles.size()},
            {"vertices", {{"read", mesh.vertices.size()}, {"different", cleaned.vertices.size()}}},
            {"components", componentFacts(mesh.components)},
            {"closed", edges.closedEdges > 0 && edges.isClosed()},
            {"edges",
             {{"of_one_triangle", edges.openEdges},
              {"of_more_than_two", edges.touchingEdges + edges.overfullEdges},
              {"with_neighbours_facing_apart", edges.twistedEdges}}},
            {"cleaning",
             {{"welded", report.weldedVertices},
              {"unused", report.unusedVertices},
              {"without_area", report.degenerateTriangles},
              {"duplicates_dropped", report.duplicateTriangles}}},
            {"tree", treeFacts(model.report())}};
}

Json problemFacts(const Problem& problem, const Box& bounds) {
    Json json = {{"name", problem.name},
                 {"space", problem.space == Space::kSe3 ? "SE(3)" : "SE(2)"},
                 {"start", toJson(problem.start)},
                 {"goal", problem.outside ? Json("outside") : toJson(problem.goal)},
                 {"bounds", toJson(bounds)},
                 {"bounds_stated", problem.volume.has_value()},
                 {"objective", problem.planning.objective},
                 {"objective_threshold", orNull(problem.planning.objectiveThreshold)},
                 {"sampler", problem.planning.sampler},
                 {"goal_threshold", orNull(problem.planning.goalThreshold)},
                 {"settings", namesIn(problem.planning.settings)},
                 {"margin", toJson(problem.margin)},
                 {"contact_start", contactFacts(problem.rules.startContact)},
                 {"contact_goal", contactFacts(problem.rules.goalContact)},
                 {"fineness", orNull(problem.fineness)},
                 {"coordinates", problem.meshes.asOmplApp ? "omplapp" : "stored"},
                 {"planners", Json::array()},
                 {"time_limit_seconds", orNull(problem.benchmark.timeLimit)},
                 {"memory_limit_megabytes", orNull(problem.benchmark.memoryLimit)},
                 {"runs", orNull(problem.benchmark.runCount)},
                 {"warnings", problem.warnings}};
    if (problem.outside && problem.outside->side) json["outside"] = nameOf(*problem.outside->side);
    for (const PlannerChoice& planner : problem.planning.planners)
        json["planners"].push_back({{"name", planner.name},
                                    {"parameters", namesIn(planner.parameters)},
                                    {"settings", namesIn(planner.settings)}});
    return json;
}

Json obstacleFacts(const ObstacleGroups& obstacles) {
    Json json = Json::array();
    for (const ObstacleGroup& group : obstacles.groups)
        json.push_back({{"components", componentFacts(group.mesh.components)},
                        {"triangles", group.mesh.triangles.size()},
                        {"margin", toJson(group.margin)},
                        {"overlap", toJson(group.overlap)},
                        {"solid", group.solids != nullptr},
                        {"ignored_near_start", group.isIgnoredAtStart},
                        {"ignored_near_goal", group.isIgnoredAtGoal}});
    return json;
}

Json poseFacts(const SceneClearance& clearance, const PartState& state) {
    const Pose X_environmentPart = poseOf(state);
    const PoseClearance at = clearance.at(X_environmentPart);
    const WhyInvalid why = clearance.whyInvalid(X_environmentPart, at);
    const MeshNames names = distinctMeshNames(clearance.scene(), at.nearest);
    return {{"valid", why.isValid()},
            {"kind", nameOf(why.kind)},
            {"why_not", why.isValid() ? Json() : Json(why.words())},
            {"clearance", toJson(at.lower)},
            {"pair", closestPair(at.nearest, names.part, names.environment)}};
}

}  // namespace clearway::cli
