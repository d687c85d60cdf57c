#include "demos/study/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "clearway/planning/plan.h"
#include "clearway/targets.h"
#include "core/number.h"

namespace clearway::study {
namespace {

const Engine kBest;

EngineGroup groupOf(const StudyOptions& options, const std::string& generalSplit) {
    EngineGroup group;
    for (const std::string& leafSplit : options.leafSplits) {
        Engine engine;
        engine.generalSplit = generalSplit;
        engine.leafSplit = leafSplit;
        group.push_back(engine);
    }
    return group;
}

template <class Value>
EngineGroup changed(EngineGroup group, Value Engine::*member, const Value& value) {
    for (Engine& engine : group) engine.*member = value;
    return group;
}

/// A key of the mesh that does not depend on the folder or name of the mesh's file.
std::string keyOf(Mesh mesh) {
    mesh.origin.file.clear();
    return std::to_string(modelKey(mesh, {}));
}

template <class Numbers>
std::string textOf(const Numbers& numbers) {
    std::string text;
    for (int i = 0; i < numbers.size(); ++i) text += " " + formatNumber(numbers[i]);
    return text;
}

std::string textOf(const PartState& state) {
    return textOf(state.position) + textOf(state.rotation.coeffs());
}

std::string goalText(const Problem& problem) {
    if (!problem.outside) return textOf(problem.goal);
    return " outside" + (problem.outside->side ? nameOf(*problem.outside->side) : "");
}

}  // namespace

BuildOptions Engine::build() const {
    BuildOptions options;
    options.generalSplit = generalSplit;
    options.leafSplit = leafSplit;
    options.leafSize = leafSize;
    options.nodeWidth = nodeWidth;
    options.threads = 1;  // a worker has one processor
    return options;
}

std::string Engine::name() const {
    std::string name = generalSplit + "/" + leafSplit;
    if (leafSize != kBest.leafSize) name += " leaves of " + std::to_string(leafSize);
    if (nodeWidth != kBest.nodeWidth) name += " width " + std::to_string(nodeWidth);
    if (instructions != kBest.instructions) name += " " + instructions;
    return name;
}

bool Engine::sharesTreesWith(const Engine& other) const {
    return std::tie(generalSplit, leafSplit, leafSize, nodeWidth) ==
           std::tie(other.generalSplit, other.leafSplit, other.leafSize, other.nodeWidth);
}

bool Engine::operator==(const Engine& other) const {
    return sharesTreesWith(other) && instructions == other.instructions;
}

std::vector<Engine> plannedEngines(const StudyOptions& options) {
    std::vector<Engine> engines;
    for (const std::string& general : options.generalSplits) {
        const EngineGroup group = groupOf(options, general);
        engines.insert(engines.end(), group.begin(), group.end());
    }
    return engines;
}

Engine qualifyingEngine(const StudyOptions& options) {
    return groupOf(options, options.generalSplits.back()).front();
}

std::vector<EngineGroup> replayedGroups(const StudyOptions& options) {
    const EngineGroup planned = plannedEngines(options);
    if (options.isShort) return {planned};
    EngineGroup onAllTargets = planned;
    const std::vector<std::string> targets = availableTargets();
    for (std::size_t i = 1; i < targets.size();
         ++i) {  // the first is the best one, which the planned engines use
        if (targets[i] == "scalar") continue;
        for (const Engine& engine : changed(planned, &Engine::instructions, targets[i]))
            onAllTargets.push_back(engine);
    }
    std::vector<EngineGroup> groups = {onAllTargets};
    for (const std::string& general : options.generalSplits) {
        const EngineGroup group = groupOf(options, general);
        EngineGroup sized = group;  // "cost" makes leaves of up to 4 whatever the leaf size
        sized.erase(std::remove_if(sized.begin(), sized.end(),
                                   [](const Engine& engine) { return engine.leafSplit == "cost"; }),
                    sized.end());
        for (const int size : {8, 16}) groups.push_back(changed(sized, &Engine::leafSize, size));
        groups.push_back(changed(group, &Engine::nodeWidth, 2));
    }
    return groups;
}

std::string StudyProblem::fingerprint() const {
    std::string text = keyOf(part);
    for (const ObstacleGroup& group : obstacles.groups) {
        text += fmt::format(" {} {} {:d}{:d}{:d}", keyOf(group.mesh), formatNumber(group.margin),
                            group.isIgnoredAtStart, group.isIgnoredAtGoal, group.solids != nullptr);
        if (group.overlap > 0) text += " overlap " + formatNumber(group.overlap);
    }
    for (const ShrunkPart& each : shrunk) text += " " + keyOf(each.mesh);
    for (const PlannerChoice& choice : problem.planning.planners) {
        for (const NamedTexts* texts : {&choice.parameters, &choice.settings}) {
            for (const auto& [key, value] : *texts) text += " " + choice.name + "." + key + "=" + value;
        }
    }
    for (const auto& [key, value] : problem.planning.settings) text += " " + key + "=" + value;
    const Box bounds = boundsOf(problem, obstacles.environmentBox(), boundingBox(part));
    return text + textOf(problem.start) + goalText(problem) + textOf(bounds.min()) + textOf(bounds.max());
}

Scene buildScene(const StudyProblem& study, const Engine& engine) {
    const Model part = Model::build(study.part, engine.build());
    planning::PlanOptions reaching;
    reaching.objective = "max_min_clearance";
    const auto range =
        planning::planningRange(study.problem, reaching, part, study.obstacles.environmentBox());
    std::vector<std::shared_ptr<const ShrunkModel>> shrunk;
    for (const ShrunkPart& each : study.shrunk)
        shrunk.push_back(shrunkModel(each, Model::build(each.mesh, engine.build())));
    return makeScene(
        part, study.partSolids, study.obstacles, study.problem.rules, poseOf(study.problem.start),
        poseOf(study.problem.goal),
        [&](const Mesh& mesh) { return Model::build(mesh, engine.build(), range); }, shrunk);
}

}  // namespace clearway::study
