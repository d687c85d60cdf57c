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

std::string durationText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 120) return fmt::format("{} s", whole);
    const long long minutes = (whole + 59) / 60;
    if (minutes < 120) return fmt::format("{} min", minutes);
    return fmt::format("{} h {} min", minutes / 60, minutes % 60);
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

std::vector<EngineGroup> plannedGroups(const StudyOptions& options) {
    std::vector<EngineGroup> groups;
    for (const std::string& general : options.generalSplits) groups.push_back(groupOf(options, general));
    return groups;
}

std::vector<EngineGroup> replayedGroups(const StudyOptions& options) {
    std::vector<std::string> others = availableTargets();
    others.erase(others.begin());  // the first is the best one, which the planned engines use
    others.erase(std::remove(others.begin(), others.end(), "scalar"), others.end());
    std::vector<std::string> varied = options.generalSplits;
    if (options.isShort) varied = {varied.back()};

    std::vector<EngineGroup> groups;
    for (const EngineGroup& planned : plannedGroups(options)) {
        groups.push_back(planned);
        if (planned[0].generalSplit != varied.back() && options.isShort) continue;
        for (const std::string& target : others)
            groups.push_back(changed(planned, &Engine::instructions, target));
    }
    groups.push_back(groupOf(options, "mean"));
    for (const std::string& general : varied) {
        for (const int size : {8, 16})
            groups.push_back(changed(groupOf(options, general), &Engine::leafSize, size));
        groups.push_back(changed(groupOf(options, general), &Engine::nodeWidth, 2));
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

Scene buildScene(const StudyProblem& study, const Engine& engine, const StudyOptions& options) {
    const Model part = options.build(study.part, engine.build(), std::nullopt);
    planning::PlanOptions reaching;
    reaching.objective = "max_min_clearance";
    const auto range =
        planning::planningRange(study.problem, reaching, part, study.obstacles.environmentBox());
    std::vector<std::shared_ptr<const ShrunkModel>> shrunk;
    for (const ShrunkPart& each : study.shrunk) {
        shrunk.push_back(shrunkModel(each, options.build(each.mesh, engine.build(), std::nullopt)));
    }
    return makeScene(
        part, study.partSolids, study.obstacles, study.problem.rules, poseOf(study.problem.start),
        poseOf(study.problem.goal),
        [&](const Mesh& mesh) { return options.build(mesh, engine.build(), range); }, shrunk);
}

TimeLeft::TimeLeft(std::size_t pieces, double mostEach)
    : pieces_(pieces), mostEach_(mostEach), begin_(Clock::now()) {}

std::string TimeLeft::text() const {
    const double each = done_ > 0 ? secondsSince(begin_) / static_cast<double>(done_) : mostEach_;
    return (done_ > 0 ? "about " : "at most ") + durationText(each * static_cast<double>(pieces_ - done_)) +
           " left";
}

}  // namespace clearway::study
